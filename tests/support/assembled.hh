// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/improve/improve.hh"
#include "surfmesh/patch_mesh/turned_triangles.hh"
#include "surfmesh/refine/boundary_triangulation.hh"
#include "surfmesh/refine/refine.hh"

/// The stages from contours to assembly, with one size everywhere.
namespace surfmesh::testing {

/// The metric of one length in space, in all directions.
class SpaceSizeField : public MetricField {
 public:
  SpaceSizeField(const Surface& surface, double size) : surface_(surface), size_(size) {}

  Metric at(Uv uv, QueryHint&) const override {
    const Jet jet = surface_.evaluate(uv, Order::First);
    const double scale = 1 / (size_ * size_);
    return {scale * jet.du.dot(jet.du), scale * jet.du.dot(jet.dv), scale * jet.dv.dot(jet.dv)};
  }

 private:
  const Surface& surface_;
  double size_;
};

/// An assembly and the contour nodes it was made of.
struct Assembled {
  PolyMesh mesh;
  AssembleReport report;
  std::vector<ContourNodes> nodes;
  std::size_t chords = 0;  ///< that were split
  std::size_t turned = 0;  ///< triangles against the surface
};

inline PatchMesh mesh_patch(const Model& model, int patch, const std::vector<ContourNodes>& nodes,
                            const NodeNumbers& numbers, const MetricField& field) {
  PatchMesh result;
  result.surface = model.patches[static_cast<std::size_t>(patch)].surface.get();
  result.field = &field;
  result.boundary = collect_boundary(model, patch, nodes, numbers, field);
  std::vector<std::vector<Uv>> loops;
  for (const BoundaryLoop& loop : result.boundary.loops) {
    loops.emplace_back();
    for (const BoundaryNode& node : loop) loops.back().push_back(node.uv);
  }
  result.delaunay = triangulate_boundary(loops, field).delaunay;
  refine(*result.delaunay, field);
  improve(*result.delaunay, field);
  evaluate_vertices(result);
  mend_turned_triangles(result);
  return result;
}

inline Assembled assemble_with_size(const Model& model, double size) {
  std::vector<std::unique_ptr<MetricField>> fields;
  std::vector<const MetricField*> pointers;
  for (const Patch& patch : model.patches) {
    fields.push_back(std::make_unique<SpaceSizeField>(*patch.surface, size));
    pointers.push_back(fields.back().get());
  }
  Assembled result;
  result.nodes = place_contour_nodes(model, pointers).contours;
  const NodeNumbers numbers(model, result.nodes);
  std::vector<PatchMesh> patches;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    patches.push_back(mesh_patch(model, static_cast<int>(p), result.nodes, numbers, *pointers[p]));
  }
  result.chords = split_improper_chords(patches);
  for (PatchMesh& patch : patches) {
    evaluate_vertices(patch);
    result.turned += count_turned_triangles(patch);
  }
  result.report = assemble(result.mesh, model, result.nodes, numbers, patches);
  return result;
}

}  // namespace surfmesh::testing
