// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/build_model.hh"

#include <fmt/format.h>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "surfmesh/core/error.hh"
#include "surfmesh/model/finish_model.hh"
#include "surfmesh_cad/face_loops.hh"
#include "surfmesh_cad/face_surface.hh"
#include "surfmesh_cad/file_points.hh"
#include "surfmesh_cad/model_box.hh"
#include "surfmesh_cad/model_fit.hh"
#include "surfmesh_cad/part_names.hh"

namespace surfmesh {
namespace {

/// Breaks of a contour are farther apart than this, and from its ends.
constexpr double kLeastBreak = 1e-6;

/// The inner knots of an edge's curve, as t.
std::vector<double> knots_of(const TopoDS_Edge& edge) {
  std::vector<double> knots;
  Standard_Real first, last;
  Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) {
    curve = trimmed->BasisCurve();
  }
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  if (spline.IsNull()) return knots;
  for (Standard_Integer k = 1; k <= spline->NbKnots(); ++k) {
    knots.push_back((spline->Knot(k) - first) / (last - first));
  }
  return knots;
}

/// Breaks in order, without those that are nearly the same, or nearly an end.
std::vector<double> tidy_breaks(std::vector<double> breaks) {
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> result;
  double before = 0;
  for (const double t : breaks) {
    if (t - before < kLeastBreak || t > 1 - kLeastBreak) continue;
    result.push_back(t);
    before = t;
  }
  return result;
}

class Builder {
 public:
  explicit Builder(const CadShape& cad) : cad_(cad), names_(cad) {
    TopExp::MapShapes(cad.shape, TopAbs_FACE, faces_);
  }

  BuiltModel build() {
    for (Standard_Integer f = 1; f <= faces_.Extent(); ++f) add(TopoDS::Face(faces_(f)));
    if (built_.model.patches.empty()) return std::move(built_);
    add_solids();
    finish_all();
    return std::move(built_);
  }

 private:
  FaceFacts facts_of(const TopoDS_Shape& face) const {
    const FaceFacts* facts = cad_.facts.Seek(face);
    return facts == nullptr ? FaceFacts() : *facts;
  }

  /// Faces that cannot be used are left out, for the others may be of use.
  void add(const TopoDS_Face& face) {
    const FaceFacts facts = facts_of(face);
    const std::string name = names_.next_patch(facts);
    try {
      // All that may fail comes before the model is changed.
      const FaceBoundary boundary = face_boundary(face);
      Patch patch;
      patch.name = name;
      patch.surface = face_surface(surface_of(face), boundary.domain);
      patch.is_reversed = face.Orientation() == TopAbs_REVERSED;
      patch_by_face_.Bind(face, add_patch(std::move(patch), boundary));
    } catch (const Standard_Failure& failure) {
      return leave_out(name, failure.GetMessageString());
    } catch (const Error& error) {
      return leave_out(name, error.what());
    }
    names_.add_to_groups(last_patch(), facts, built_.model.groups);
  }

  int last_patch() const { return static_cast<int>(built_.model.patches.size()) - 1; }

  void leave_out(const std::string& name, const std::string& reason) {
    Notice notice =
        shortfall(NoticeKind::IgnoredInput, fmt::format("the face is left out: {}", reason));
    locate(name, notice);
    built_.left_out.push_back(notice);
  }

  int add_patch(Patch patch, const FaceBoundary& boundary) {
    built_.model.patches.push_back(std::move(patch));
    dropped_edges_ += boundary.dropped_edges;
    for (const FaceLoop& loop : boundary.loops) {
      PatchLoop entries;
      for (const FaceEdge& edge : loop) entries.push_back(add_use(edge));
      built_.model.patches.back().loops.push_back(std::move(entries));
    }
    return last_patch();
  }

  LoopEntry add_use(const FaceEdge& edge) {
    const int index = edge.edge.IsNull() ? add_pole(edge) : contour_of(edge.edge);
    Contour& contour = built_.model.contour(index);
    ContourUse use;
    use.patch = last_patch();
    use.curve = make_curve(edge.curve);
    use.is_forward = edge.is_forward;
    contour.uses.push_back(std::move(use));
    const std::vector<double> corners = corners_of(edge.curve);
    contour.breaks.insert(contour.breaks.end(), corners.begin(), corners.end());
    return {index, static_cast<int>(contour.uses.size()) - 1};
  }

  Contour& new_contour() {
    Contour& contour = built_.model.contours.emplace_back();
    contour.name = fmt::format("edge{}", built_.model.contours.size());
    return contour;
  }

  int last_contour() const { return static_cast<int>(built_.model.contours.size()) - 1; }

  int contour_of(const TopoDS_Edge& edge) {
    if (const Standard_Integer* found = contours_.Seek(edge)) return *found;
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    TopoDS_Vertex start, end;
    TopExp::Vertices(forward, start, end);
    Contour& contour = new_contour();
    contour.start = vertex_of(start);
    contour.end = end.IsSame(start) ? contour.start : vertex_of(end);
    // A pole of the file is one, even if it has some extent by its inaccuracy.
    contour.is_degenerate = BRep_Tool::Degenerated(edge);
    if (!contour.is_degenerate) contour.breaks = knots_of(edge);
    contours_.Bind(edge, last_contour());
    return last_contour();
  }

  int add_pole(const FaceEdge& side) {
    Contour& contour = new_contour();
    contour.start = contour.end = vertex_of(side.vertex);
    contour.is_degenerate = true;
    return last_contour();
  }

  /// A vertex of the file; one that the file leaves out, as closed edges may, is a new one.
  int vertex_of(const TopoDS_Vertex& vertex) {
    if (!vertex.IsNull()) {
      if (const Standard_Integer* found = vertices_.Seek(vertex)) return *found;
    }
    const int index = static_cast<int>(built_.model.vertices.size());
    ModelVertex& added = built_.model.vertices.emplace_back();
    if (vertex.IsNull()) return index;
    added.position = to_vec3(BRep_Tool::Pnt(vertex));
    vertices_.Bind(vertex, index);
    return index;
  }

  /// A face of two solids belongs to the first. Solids are groups where there are several of them,
  /// unless parts or bodies are these.
  void add_solids() {
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(cad_.shape, TopAbs_SOLID, solids);
    const bool are_groups =
        solids.Extent() >= 2 && solids.Extent() > static_cast<int>(cad_.parts.size());
    for (Standard_Integer s = 1; s <= solids.Extent(); ++s) {
      const std::string name = fmt::format("solid{}", s);
      for (TopExp_Explorer face(solids(s), TopAbs_FACE); face.More(); face.Next()) {
        const Standard_Integer* patch = patch_by_face_.Seek(face.Current());
        if (patch == nullptr) continue;
        if (are_groups) add_to_group(name, *patch, built_.model.groups);
        Patch& own = built_.model.patch(*patch);
        if (own.solid >= 0) continue;
        own.solid = static_cast<int>(s);
        own.is_reversed = face.Current().Orientation() == TopAbs_REVERSED;
      }
    }
  }

  void finish_all() {
    Model& model = built_.model;
    for (Contour& contour : model.contours) contour.breaks = tidy_breaks(contour.breaks);
    centre_vertices(model);
    set_box(model);
    finish(model);
    put_in_order(model.groups);
    set_tolerances(model);
    if (dropped_edges_ > 0) {
      append({warning(NoticeKind::HealedShape,
                      fmt::format("{} edges that bound no face are left out", dropped_edges_))},
             model.notices);
    }
  }

  const CadShape& cad_;
  PartNames names_;
  TopTools_IndexedMapOfShape faces_;
  NCollection_DataMap<TopoDS_Shape, Standard_Integer, TopTools_ShapeMapHasher> patch_by_face_;
  NCollection_DataMap<TopoDS_Shape, Standard_Integer, TopTools_ShapeMapHasher> contours_;
  NCollection_DataMap<TopoDS_Shape, Standard_Integer, TopTools_ShapeMapHasher> vertices_;
  int dropped_edges_ = 0;
  BuiltModel built_;
};

}  // namespace

BuiltModel build_model(const CadShape& cad) { return Builder(cad).build(); }

}  // namespace surfmesh
