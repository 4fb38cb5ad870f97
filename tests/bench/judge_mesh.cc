// SPDX-License-Identifier: BSD-3-Clause
#include "bench/judge_mesh.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/contour_stations.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/beside_pole.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/sizes/model_sources.hh"

namespace surfmesh::judge {
namespace {

/// A count that changes by less has settled.
constexpr double kSettled = 0.01;

/// Patches whose own counts change by a greater share get finer grids.
constexpr double kPatchSettled = 0.005;

/// Share of the diagonal that a corner may be away from the point of its (u,v).
constexpr double kSamePoint = 1e-6;

/// Greatest number of parts of a side of a triangle in the sum over its area.
constexpr int kMostParts = 64;

SizeFields exact_fields(const ModelInput& input, const ResolvedSizing& sizing) {
  const auto sources = model_sources(input.model, input.sources, sizing);
  SizeFields fields;
  for (std::size_t p = 0; p < input.model.patches.size(); ++p) {
    fields.push_back(std::make_unique<SizeField>(*input.model.patches[p].surface, sizing,
                                                 sources[p], input.options.control.precision));
  }
  return fields;
}

/// True if a curve runs on the border of the domain.
bool is_on_border(const Domain& domain, const Curve& curve) {
  constexpr int kSamples = 8;
  for (int i = 0; i <= kSamples; ++i) {
    const Uv uv = curve.evaluate(double(i) / kSamples);
    const double s = (uv.u - domain.u0) / (domain.u1 - domain.u0);
    const double t = (uv.v - domain.v0) / (domain.v1 - domain.v0);
    const bool is_triangle = domain.shape == Domain::Shape::Triangle;
    const double inside = std::min({s, t, is_triangle ? 1 - s - t : std::min(1 - s, 1 - t)});
    if (inside > kSamePoint) return false;
  }
  return true;
}

bool is_whole_domain(const Model& model, const Patch& patch) {
  return patch.loops.size() == 1 &&
         std::all_of(patch.loops[0].begin(), patch.loops[0].end(), [&](const LoopEntry& entry) {
           return is_on_border(patch.surface->domain(), *model.use(entry).curve);
         });
}

/// The triangles of a mesh in the parameters of their patches.
struct TriangleUv {
  Uv a, b, c;
};

std::vector<std::vector<TriangleUv>> triangles_by_patch(const PolyMesh& mesh, std::size_t patches) {
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto patch_of = require(mesh, keys::face_patch);
  std::vector<std::vector<TriangleUv>> triangles(patches);
  for (const FaceHandle fh : mesh.faces()) {
    const auto patch = static_cast<std::size_t>(mesh.property(patch_of, fh));
    if (patch >= patches) throw Error(ErrorCode::InvalidInput, "the mesh has more patches");
    const HalfedgeHandle first = mesh.halfedge_handle(fh);
    HalfedgeHandle heh = mesh.next_halfedge_handle(first);
    for (HalfedgeHandle next = mesh.next_halfedge_handle(heh); next != first;
         heh = next, next = mesh.next_halfedge_handle(next)) {
      triangles[patch].push_back(
          {mesh.property(uv_of, first), mesh.property(uv_of, heh), mesh.property(uv_of, next)});
    }
  }
  return triangles;
}

/// Metric area of a triangle in (u,v), cut into parts of a step of the grid at most.
double metric_area(const GradedSizes& sizes, int patch, const TriangleUv& triangle) {
  const auto& [a, b, c] = triangle;
  const Uv pa = sizes.grid(patch).in_steps(a), pb = sizes.grid(patch).in_steps(b),
           pc = sizes.grid(patch).in_steps(c);
  const double width = std::max({pa.u, pb.u, pc.u}) - std::min({pa.u, pb.u, pc.u});
  const double height = std::max({pa.v, pb.v, pc.v}) - std::min({pa.v, pb.v, pc.v});
  const int n = std::clamp(static_cast<int>(std::ceil(std::max(width, height))), 2, kMostParts);
  double sum = 0;
  const auto add = [&](double i, double j) {
    sum += sizes.density(patch, a + (i / n) * (b - a) + (j / n) * (c - a));
  };
  constexpr double kThird = 1.0 / 3.0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n - j; ++i) {
      add(i + kThird, j + kThird);
      if (i + j < n - 1) add(i + 2 * kThird, j + 2 * kThird);
    }
  }
  return 0.5 * std::abs(cross(b - a, c - a)) * sum / (double(n) * n);
}

class Judge {
 public:
  Judge(PolyMesh& mesh, const ModelInput& input, const JudgeOptions& options)
      : mesh_(mesh),
        model_(input.model),
        options_(options),
        sizing_(resolve(input.options.sizing, input.model)),
        fields_(exact_fields(input, sizing_)),
        triangles_(triangles_by_patch(mesh, input.model.patches.size())) {}

  Judgement run() {
    for (const auto& triangles : triangles_) result_.triangles += triangles.size();
    GradedSizes sizes = graded(coarse_grids());
    std::vector<double> coarse = counts(sizes);
    std::vector<PatchGrid> finer;
    for (const PatchGrid& grid : sizes.grids()) finer.push_back(grid.refined());
    while (true) {
      sizes = graded(finer);
      const std::vector<double> fine = counts(sizes);
      set_ideal(coarse, fine);
      if (!options_.is_adaptive || result_.is_settled() || !refine(coarse, fine, finer)) break;
      coarse = fine;
    }
    result_.nodes = node_count(sizes.grids());
    attach_metric(sizes);
    result_.edges = measure_edges(mesh_);
    return result_;
  }

 private:
  GradedSizes graded(const std::vector<PatchGrid>& grids) const {
    return GradedSizes(model_, fields_, sizing_.grade, grids);
  }

  /// A quarter of the nodes, as many for each patch.
  std::vector<PatchGrid> coarse_grids() {
    const double most = options_.most_nodes / static_cast<double>(model_.patches.size());
    result_.is_bounded = options_.nodes > most;
    std::vector<PatchGrid> grids;
    for (const Patch& patch : model_.patches) {
      grids.push_back(make_grid(*patch.surface, 0.25 * std::min(options_.nodes, most)));
    }
    return grids;
  }

  /// By patch, the unit triangles that fill its metric area.
  std::vector<double> counts(const GradedSizes& sizes) const {
    std::vector<double> result;
    for (std::size_t p = 0; p < model_.patches.size(); ++p) {
      const int patch = static_cast<int>(p);
      double area = 0;
      if (is_whole_domain(model_, model_.patches[p])) {
        area = sizes.metric_area(patch);
      } else {
        for (const TriangleUv& t : triangles_[p]) area += metric_area(sizes, patch, t);
      }
      result.push_back(area / kUnitTriangleArea);
    }
    return result;
  }

  void set_ideal(const std::vector<double>& coarse, const std::vector<double>& fine) {
    result_.coarse_ideal = result_.ideal = 0;
    for (const double count : coarse) result_.coarse_ideal += count;
    for (const double count : fine) result_.ideal += count;
  }

  /// Refine the grids of patches whose counts change. Returns false if there would be too many
  /// nodes.
  bool refine(const std::vector<double>& coarse, const std::vector<double>& fine,
              std::vector<PatchGrid>& grids) {
    std::vector<PatchGrid> finer = grids;
    for (std::size_t p = 0; p < grids.size(); ++p) {
      if (std::abs(fine[p] - coarse[p]) > kPatchSettled * fine[p]) finer[p] = grids[p].refined();
    }
    result_.is_bounded = static_cast<double>(node_count(finer)) > options_.most_nodes;
    if (result_.is_bounded) return false;
    grids = std::move(finer);
    return true;
  }

  void attach_metric(const GradedSizes& sizes) {
    const auto uv_of = require(mesh_, keys::corner_uv);
    const auto patch_of = require(mesh_, keys::face_patch);
    detach(mesh_, keys::corner_metric);
    const auto metric_of = attach(mesh_, keys::corner_metric);
    for (const HalfedgeHandle heh : mesh_.halfedges()) {
      if (mesh_.is_boundary(heh)) continue;
      const int patch = mesh_.property(patch_of, mesh_.face_handle(heh));
      const Uv uv = mesh_.property(uv_of, heh);
      check_place(heh, patch, uv);
      mesh_.property(metric_of, heh) =
          metric_from_size(regular_form(model_.surface(patch), uv), sizes.at(patch, uv));
    }
  }

  /// At a pole, that beside it, whose frame is that of the sizes there.
  static FirstFormFactor regular_form(const Surface& surface, Uv uv) {
    const FirstFormFactor form = form_at(surface, uv);
    return is_regular(form) ? form : form_at(surface, beside_pole(surface, uv));
  }

  void check_place(HalfedgeHandle heh, int patch, Uv uv) const {
    const Vec3 point = to_eigen(mesh_.point(mesh_.to_vertex_handle(heh)));
    const Vec3 there = model_.surface(patch).evaluate(uv, Order::Position).point;
    const double gap = (there - point).norm();
    if (gap <= kSamePoint * model_.diagonal) return;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("a corner of patch {} is {:.3g} away from its point of the model: the "
                            "mesh is of another model, or was made with other options",
                            model_.patch(patch).name, gap));
  }

  PolyMesh& mesh_;
  const Model& model_;
  const JudgeOptions& options_;
  ResolvedSizing sizing_;
  SizeFields fields_;
  std::vector<std::vector<TriangleUv>> triangles_;  ///< by patch
  Judgement result_;
};

}  // namespace

bool Judgement::is_settled() const { return std::abs(coarse_ideal - ideal) <= kSettled * ideal; }

Judgement judge_mesh(PolyMesh& mesh, const ModelInput& input, const JudgeOptions& options) {
  return Judge(mesh, input, options).run();
}

}  // namespace surfmesh::judge
