// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/cad_shape.hh"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <cmath>

namespace surfmesh {

void carry_facts(CadShape& cad, const FaceImage& image) {
  FaceFactsMap carried;
  for (FaceFactsMap::Iterator it(cad.facts); it.More(); it.Next()) {
    const TopoDS_Shape result = image(it.Key());
    if (result.IsNull()) continue;
    for (TopExp_Explorer face(result, TopAbs_FACE); face.More(); face.Next()) {
      carried.Bind(face.Current(), it.Value());
    }
  }
  cad.facts.Exchange(carried);
}

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

double rough_diagonal(const TopoDS_Shape& shape) {
  Bnd_Box box;
  constexpr bool kUseTriangulation = false;
  BRepBndLib::Add(shape, box, kUseTriangulation);
  return box.IsVoid() || box.IsOpen() ? 0 : std::sqrt(box.SquareExtent());
}

}  // namespace surfmesh
