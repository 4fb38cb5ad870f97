// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/heal_shape.hh"

#include <fmt/format.h>

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Edge.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeConstruct_ProjectCurveOnSurface.hxx>
#include <ShapeExtend_WireData.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeUpgrade_ShapeDivideContinuity.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh_cad/face_surface.hh"
#include "surfmesh_cad/loop_box.hh"
#include "surfmesh_cad/spline_corners.hh"
#include "surfmesh_cad/turns.hh"

namespace surfmesh {
namespace {

/// Faces that nothing joins are sewn to this share of the diagonal.
constexpr double kUsualSewing = 1e-5;

/// Corners of splines are looked for, and cut out, to this distance in model units, as
/// OpenCASCADE's own tolerance of points is.
constexpr double kCornerTolerance = 1e-7;

void tell(CadShape& cad, std::string text) {
  append({warning(NoticeKind::HealedShape, std::move(text))}, cad.notices);
}

/// Whether a shape has no solids, and no two faces of it are in one shell.
bool is_unjoined(const TopoDS_Shape& shape) {
  if (count_of(shape, TopAbs_FACE) < 2 || count_of(shape, TopAbs_SOLID) > 0) return false;
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
    if (shell.Current().NbChildren() > 1) return false;
  }
  return true;
}

double sewing_tolerance(const CadShape& cad, const CadOptions& options) {
  if (!options.sew && !is_unjoined(cad.shape)) return 0;
  const double diagonal = rough_diagonal(cad.shape);
  return options.sew ? options.sew->in_units(diagonal) : kUsualSewing * diagonal;
}

/// A solid of a closed shell, whose outside is outside.
TopoDS_Solid solid_of(const TopoDS_Shape& shell) {
  TopoDS_Solid solid;
  BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

bool is_inside(const TopoDS_Solid& inner, const TopoDS_Solid& outer) {
  const TopoDS_Vertex vertex = TopoDS::Vertex(TopExp_Explorer(inner, TopAbs_VERTEX).Current());
  BRepClass3d_SolidClassifier place(outer, BRep_Tool::Pnt(vertex), Precision::Confusion());
  return place.State() == TopAbs_IN;
}

/// Solids of closed shells. One inside another is a hollow of it: its outside is inside.
std::vector<TopoDS_Shape> nested(const std::vector<TopoDS_Solid>& solids) {
  std::vector<TopoDS_Shape> result;
  for (const TopoDS_Solid& solid : solids) {
    const auto depth = std::count_if(solids.begin(), solids.end(), [&](const TopoDS_Solid& other) {
      return !other.IsSame(solid) && is_inside(solid, other);
    });
    result.push_back(solid);
    if (depth % 2 == 1) result.back().Reverse();
  }
  return result;
}

/// What was sewn, with solids in place of its closed shells, and the solids that were there.
TopoDS_Shape with_solids(const TopoDS_Shape& sewn, const TopoDS_Shape& before) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (TopExp_Explorer it(before, TopAbs_SOLID); it.More(); it.Next()) {
    builder.Add(all, it.Current());
  }
  std::vector<TopoDS_Solid> solids;
  for (TopExp_Explorer it(sewn, TopAbs_SHELL); it.More(); it.Next()) {
    if (BRep_Tool::IsClosed(it.Current())) {
      solids.push_back(solid_of(it.Current()));
    } else {
      builder.Add(all, it.Current());
    }
  }
  for (const TopoDS_Shape& solid : nested(solids)) builder.Add(all, solid);
  for (TopExp_Explorer it(sewn, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next()) {
    builder.Add(all, it.Current());
  }
  return all;
}

/// Put what an operation of OpenCASCADE has made in place of the shape.
void replace(CadShape& cad, const TopoDS_Shape& shape, const Handle(ShapeBuild_ReShape) & changes) {
  carry_facts(cad, [&changes](const TopoDS_Shape& face) { return changes->Apply(face); });
  cad.shape = shape;
}

/// Whether an edge has no curve in the parameters of a face that is as long as itself, and its
/// curve in space gives none. The precision is that of ShapeFix_Edge.
bool fails_to_project(const TopoDS_Edge& edge, const TopoDS_Face& face) try {
  ShapeAnalysis_Edge analysis;
  Handle(Geom2d_Curve) on_surface;
  double first = 0, last = 0;
  if (analysis.PCurve(edge, face, on_surface, first, last) &&
      analysis.CheckPCurveRange(first, last, on_surface)) {
    return false;
  }
  Handle(Geom_Curve) in_space = BRep_Tool::Curve(edge, first, last);
  if (in_space.IsNull()) return false;
  ShapeConstruct_ProjectCurveOnSurface projection;
  projection.Init(BRep_Tool::Surface(face), Precision::Confusion());
  on_surface.Nullify();
  projection.Perform(in_space, first, last, on_surface);
  return on_surface.IsNull();
} catch (const Standard_Failure&) {
  return false;  // which ShapeFix_Edge catches, too
}

/// Whether OpenCASCADE (7.6) crashes where it mends a shape: ShapeFix_Edge::FixAddPCurve takes for
/// granted that an edge that a wire runs along twice can be projected.
bool crashes_where_mended(const TopoDS_Shape& shape) {
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    for (TopExp_Explorer it(face.Current(), TopAbs_WIRE); it.More(); it.Next()) {
      const Handle(ShapeExtend_WireData) wire =
          new ShapeExtend_WireData(TopoDS::Wire(it.Current()));
      for (Standard_Integer e = 1; e <= wire->NbEdges(); ++e) {
        if (wire->IsSeam(e) && fails_to_project(wire->Edge(e), TopoDS::Face(face.Current()))) {
          return true;
        }
      }
    }
  }
  return false;
}

/// Faces and edges, for what is told.
std::string counts_of(const TopoDS_Shape& shape) {
  return fmt::format("{} faces and {} edges", count_of(shape, TopAbs_FACE),
                     count_of(shape, TopAbs_EDGE));
}

/// The ends of the curves that bound a face, and the points of those that are splines, in its
/// parameters.
LoopBox points_around(const TopoDS_Face& face) {
  LoopBox box;
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Current()), face, first, last);
    if (curve.IsNull()) continue;
    const auto extend = [&box](const gp_Pnt2d& point) { box.extend(Uv{point.X(), point.Y()}); };
    extend(curve->Value(first));
    extend(curve->Value(last));
    const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve);
    if (spline.IsNull()) continue;
    for (Standard_Integer p = 1; p <= spline->NbPoles(); ++p) extend(spline->Pole(p));
  }
  return box;
}

/// Why nothing can be done with a face; empty if something can, or if that is not known.
std::string damage_of(const TopoDS_Face& face) try {
  const Handle(Geom_Surface) surface = surface_of(face);
  if (!surface->IsUPeriodic() && !surface->IsVPeriodic()) return {};
  const LoopBox box = points_around(face);
  if (box.width() < 0) return {};  // there is no curve
  check_turns(*surface, {box.u0, box.u1, box.v0, box.v1});
  return {};
} catch (const Error& error) {
  return error.what();
} catch (const Standard_Failure&) {
  return {};
}

}  // namespace

void drop_damaged_faces(CadShape& cad) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(cad.shape, TopAbs_FACE, faces);
  const Handle(ShapeBuild_ReShape) changes = new ShapeBuild_ReShape;
  bool has_changes = false;
  for (Standard_Integer f = 1; f <= faces.Extent(); ++f) {
    const std::string damage = damage_of(TopoDS::Face(faces(f)));
    if (damage.empty()) continue;
    changes->Remove(faces(f));
    has_changes = true;
    Notice notice = shortfall(NoticeKind::IgnoredInput, "the face is left out: " + damage);
    locate(fmt::format("face {} of {}", f, faces.Extent()), notice);
    append({notice}, cad.notices);
  }
  if (has_changes) replace(cad, changes->Apply(cad.shape), changes);
}

void sew_faces(CadShape& cad, const CadOptions& options) {
  const double tolerance = sewing_tolerance(cad, options);
  if (!(tolerance > 0)) return;
  const int edges = count_of(cad.shape, TopAbs_EDGE);
  BRepBuilderAPI_Sewing sewing(tolerance);
  int faces = 0;
  for (TopExp_Explorer it(cad.shape, TopAbs_FACE, TopAbs_SOLID); it.More(); it.Next(), ++faces) {
    sewing.Add(it.Current());
  }
  if (faces == 0) return;
  sewing.Perform();
  if (sewing.SewedShape().IsNull()) return;
  carry_facts(cad, [&sewing](const TopoDS_Shape& face) {
    return sewing.IsModified(face) ? sewing.Modified(face) : face;
  });
  cad.shape = with_solids(sewing.SewedShape(), cad.shape);
  tell(cad, fmt::format(
                "its {} loose faces are sewn where they are nearer than {:.3g}: of {} edges "
                "{} are left, {} of them with one face",
                faces, tolerance, edges, count_of(cad.shape, TopAbs_EDGE), sewing.NbFreeEdges()));
}

void divide_at_corners(CadShape& cad) {
  if (!has_corners(cad.shape)) return;
  ShapeUpgrade_ShapeDivideContinuity tool(cad.shape);
  tool.SetBoundaryCriterion(GeomAbs_C1);
  tool.SetPCurveCriterion(GeomAbs_C1);
  tool.SetSurfaceCriterion(GeomAbs_C1);
  tool.SetTolerance(kCornerTolerance);
  if (!tool.Perform() || tool.Result().IsNull()) return;
  const std::string before = counts_of(cad.shape);
  replace(cad, tool.Result(), tool.GetContext());
  const std::string after = counts_of(cad.shape);
  if (after == before) return;
  tell(cad,
       fmt::format("splines are divided where they have corners: {} become {}", before, after));
}

bool mend_faces(CadShape& cad) {
  if (crashes_where_mended(cad.shape)) {
    append(
        {warning(NoticeKind::IgnoredInput,
                 "faces that cannot be used as they are were not mended: OpenCASCADE would crash "
                 "at a seam that cannot be projected onto its face")},
        cad.notices);
    return false;
  }
  ShapeFix_Shape fix(cad.shape);
  const bool is_changed = fix.Perform();
  if (!is_changed || fix.Shape().IsNull()) return false;
  const std::string before = counts_of(cad.shape);
  replace(cad, fix.Shape(), fix.Context());
  tell(cad, fmt::format("faces that could not be used as they are were mended: {} become {}",
                        before, counts_of(cad.shape)));
  return true;
}

}  // namespace surfmesh
