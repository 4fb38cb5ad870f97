// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"

namespace surfmesh {

/// What a file tells of a face besides its shape.
struct FaceFacts {
  int part = -1;       ///< index in CadShape::parts; -1 for none
  std::string name;    ///< empty for none
  std::string body;    ///< the name of its solid or shell within the part; empty for none
  std::string colour;  ///< "#rrggbb"; empty for none
};

using FaceFactsMap = NCollection_DataMap<TopoDS_Shape, FaceFacts, TopTools_ShapeMapHasher>;

/// The contents of a file.
struct CadShape {
  TopoDS_Shape shape;
  std::vector<std::string> parts;  ///< names of the leaves of the assembly; empty for no name
  FaceFactsMap facts;              ///< by face, with its location
  Notices notices;
};

/// What a face has become: itself, several faces in a compound, or nothing.
using FaceImage = std::function<TopoDS_Shape(const TopoDS_Shape& face)>;

/// Carry the facts over to what the faces have become.
void carry_facts(CadShape& cad, const FaceImage& image);

/// How many faces, edges, ... a shape has; those it has twice count once.
int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

/// The diagonal of a box around the shape, which may be somewhat too large.
double rough_diagonal(const TopoDS_Shape& shape);

}  // namespace surfmesh
