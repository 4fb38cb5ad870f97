// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <BRepAdaptor_Curve.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_FixSmallFace.hxx>
#include <ShapeFix_Wireframe.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>

#include "surfmesh_cad/heal_shape.hh"

namespace surfmesh {
namespace {

/// Edges shorter than this share of the diagonal are no edges of the part.
constexpr double kLeastEdge = 1e-7;

/// Intervals for an upper bound of the length of what is short: the length of a polyline is one but
/// for what lies between its points.
constexpr int kIntervals = 8;

/// But to no more than this share of the diagonal: a vertex of a large tolerance is no reason to
/// lose what lies elsewhere.
constexpr double kMostMerged = 1e-5;

/// Edges are merged to a distance somewhat above the longest of them.
constexpr double kMergeSlack = 2;

double length_of(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  double length = 0;
  gp_Pnt before = curve.Value(first);
  for (int i = 1; i <= kIntervals; ++i) {
    const gp_Pnt next = curve.Value(std::lerp(first, last, static_cast<double>(i) / kIntervals));
    length += before.Distance(next);
    before = next;
  }
  return length;
}

/// Whether an edge lies within the tolerance of its vertices, or is below `least`.
bool is_small(const TopoDS_Edge& edge, double least) {
  if (BRep_Tool::Degenerated(edge)) return false;
  TopoDS_Vertex start, end;
  TopExp::Vertices(edge, start, end);
  if (start.IsNull() || end.IsNull()) return false;
  const double within = std::max(BRep_Tool::Tolerance(start), BRep_Tool::Tolerance(end));
  // Most edges are seen to be longer by their ends.
  if (!start.IsSame(end) &&
      BRep_Tool::Pnt(start).Distance(BRep_Tool::Pnt(end)) > std::max(least, within)) {
    return false;
  }
  Standard_Real first, last;
  if (BRep_Tool::Curve(edge, first, last).IsNull()) return false;
  return length_of(edge) <= std::max(least, within);
}

/// How many edges are small, and the longest of them.
struct SmallEdges {
  int count = 0;
  double longest = 0;
};

SmallEdges small_edges(const TopoDS_Shape& shape, double least) {
  SmallEdges small;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (Standard_Integer i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    if (!is_small(edge, least)) continue;
    ++small.count;
    small.longest = std::max(small.longest, length_of(edge));
  }
  return small;
}

/// Edges of one face alone: a shape that is closed has none.
int open_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  int count = 0;
  for (Standard_Integer i = 1; i <= faces.Extent(); ++i) {
    const bool is_pole = BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(i)));
    if (!is_pole && faces(i).Extent() == 1) ++count;
  }
  return count;
}

/// Faces narrower than a distance become edges, then edges shorter than it vertices.
TopoDS_Shape merged(const TopoDS_Shape& shape, double distance,
                    const Handle(ShapeBuild_ReShape) & changes) {
  ShapeFix_FixSmallFace faces;
  faces.SetContext(changes);
  faces.Init(shape);
  faces.SetPrecision(distance);
  faces.SetMaxTolerance(distance);
  faces.Perform();
  ShapeFix_Wireframe edges(faces.FixShape());
  edges.SetContext(changes);
  edges.SetPrecision(distance);
  edges.SetMaxTolerance(distance);
  edges.ModeDropSmallEdges() = true;
  edges.FixSmallEdges();
  return edges.Shape();
}

/// Whether a shape may take the place of another: it is as closed, and as valid.
bool is_as_good(const TopoDS_Shape& result, const TopoDS_Shape& before) {
  return !result.IsNull() && open_edges(result) <= open_edges(before) &&
         (BRepCheck_Analyzer(result).IsValid() || !BRepCheck_Analyzer(before).IsValid());
}

}  // namespace

void merge_small_edges(CadShape& cad) {
  const double least = kLeastEdge * rough_diagonal(cad.shape);
  const SmallEdges before = small_edges(cad.shape, least);
  if (before.count == 0) return;
  const double most = kMostMerged * rough_diagonal(cad.shape);
  const double distance = std::min(std::max(least, kMergeSlack * before.longest), most);
  const Handle(ShapeBuild_ReShape) changes = new ShapeBuild_ReShape;
  const TopoDS_Shape result = merged(cad.shape, distance, changes);
  if (!is_as_good(result, cad.shape)) return;
  const int left = small_edges(result, least).count;
  if (left >= before.count) return;
  const int faces = count_of(cad.shape, TopAbs_FACE) - count_of(result, TopAbs_FACE);
  carry_facts(cad, [&changes](const TopoDS_Shape& face) { return changes->Apply(face); });
  cad.shape = result;
  append({warning(NoticeKind::HealedShape,
                  fmt::format("{} edges shorter than {:.3g} and {} faces as narrow are merged with "
                              "their neighbours",
                              before.count - left, distance, faces))},
         cad.notices);
}

}  // namespace surfmesh
