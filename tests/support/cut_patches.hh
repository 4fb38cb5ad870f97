// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "support/models.hh"
#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/patch/mesh_patch.hh"

namespace surfmesh::testing {

/// The meshes of a model's patches, each cut into two pieces along the middle of its u, before they
/// are assembled.
class CutPatches {
 public:
  CutPatches(Model given, double size)
      : model(std::move(given)),
        fields(model, size),
        nodes(place_contour_nodes(model, fields).contours),
        numbers(model, nodes) {
    for (int p = 0; p < static_cast<int>(model.patches.size()); ++p) {
      for (PatchBoundary& half : cut(collect_boundary(model, p, nodes, numbers, fields[p]), size)) {
        pieces.push_back(
            mesh_patch(
                {.surface = model.surface(p), .field = fields[p], .boundary = std::move(half)})
                .mesh);
      }
    }
  }

  AssembleReport assemble_into(PolyMesh& mesh) {
    return assemble(mesh, model, nodes, numbers, std::move(pieces));
  }

  Model model;
  UniformSizes fields;
  std::vector<ContourNodes> nodes;
  NodeNumbers numbers;
  std::vector<PatchMesh> pieces;

 private:
  std::array<PatchBoundary, 2> cut(const PatchBoundary& whole, double size) {
    const BoundaryLoop& loop = whole.loops.front();
    const Domain domain = model.surface(whole.patch).domain();
    const std::size_t below = nearest(loop, domain.at(0.5, 0));
    const std::size_t above = nearest(loop, domain.at(0.5, 1));
    const BoundaryLoop chord = chord_between(whole.patch, loop[below].uv, loop[above].uv, size);
    std::array<PatchBoundary, 2> halves;
    for (PatchBoundary& half : halves) half.patch = whole.patch;
    halves[0].loops = {closed_by(part(loop, below, above), {chord.rbegin(), chord.rend()})};
    halves[1].loops = {closed_by(part(loop, above, below), chord)};
    return halves;
  }

  static std::size_t nearest(const BoundaryLoop& loop, Uv place) {
    const auto distance = [place](const BoundaryNode& node) {
      return std::hypot(node.uv.u - place.u, node.uv.v - place.v);
    };
    return static_cast<std::size_t>(
        std::min_element(loop.begin(), loop.end(),
                         [&](const BoundaryNode& a, const BoundaryNode& b) {
                           return distance(a) < distance(b);
                         }) -
        loop.begin());
  }

  /// Nodes between two places, about as far apart in space as is asked for.
  BoundaryLoop chord_between(int patch, Uv from, Uv to, double size) {
    constexpr int kSteps = 100;
    const auto point = [&](double share) {
      return model.surface(patch).evaluate(lerp(from, to, share), Order::Position).point;
    };
    double length = 0;
    for (int i = 0; i < kSteps; ++i) {
      length += (point((i + 1.0) / kSteps) - point(static_cast<double>(i) / kSteps)).norm();
    }
    const int segments = std::max(3, static_cast<int>(std::lround(length / size)));
    const int first = numbers.add(segments - 1);
    BoundaryLoop chord;
    for (int i = 1; i < segments; ++i) {
      chord.push_back({lerp(from, to, static_cast<double>(i) / segments), first + i - 1, -1});
    }
    return chord;
  }

  /// From one node on to another one; the last segment is the cut.
  static BoundaryLoop part(const BoundaryLoop& loop, std::size_t first, std::size_t last) {
    BoundaryLoop result;
    for (std::size_t i = first; i != last; i = (i + 1) % loop.size()) result.push_back(loop[i]);
    result.push_back(loop[last]);
    result.back().contour = -1;
    return result;
  }

  static BoundaryLoop closed_by(BoundaryLoop part, const BoundaryLoop& chord) {
    part.insert(part.end(), chord.begin(), chord.end());
    return part;
  }
};

}  // namespace surfmesh::testing
