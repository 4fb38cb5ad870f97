// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/patch/mesh_patch.hh"
#include "surfmesh/patch_mesh/improper_chords.hh"

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
  std::map<std::size_t, std::size_t> turned;  // by patch
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    PatchResult made =
        mesh_patch({.surface = *model.patches[p].surface,
                    .field = *pointers[p],
                    .boundary = collect_boundary(model, static_cast<int>(p), result.nodes, numbers,
                                                 *pointers[p])});
    turned[p] = made.turned.count;
    patches.push_back(std::move(made.mesh));
  }
  const ChordReport chords = split_improper_chords(patches, model, pointers);
  result.chords = chords.nodes;
  for (const auto& [p, changed] : chords.turned) turned[p] = changed.count;
  for (const auto& [p, count] : turned) result.turned += count;
  result.report = assemble(result.mesh, model, result.nodes, numbers, std::move(patches));
  return result;
}

}  // namespace surfmesh::testing
