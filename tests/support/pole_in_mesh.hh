// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "support/models.hh"
#include "surfmesh/boundary/patch_boundary.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"

/// A pole that no ring cuts off: some faces have corners that are one vertex of the result.
namespace surfmesh::testing {

/// The boundary of a cone's one patch with the ring around its apex taken out again.
inline PatchBoundary boundary_with_pole(PatchBoundary boundary) {
  const PoleFan fan = boundary.fans.at(0);
  BoundaryLoop loop;
  for (const BoundaryNode& node : boundary.loops.at(0)) {
    if (node.vertex >= 0) {
      loop.push_back(node);
      if (node.contour >= 0) continue;
      loop.back().contour = fan.contour_to;
      loop.push_back({fan.sides.front(), fan.pole, -1});
      loop.push_back({fan.sides.back(), fan.pole, fan.contour_from});
    }
  }
  return {boundary.patch, {loop}, {}};
}

/// Two rows of faces along a loop, each half as far from the middle as the one before, and
/// triangles around the middle.
inline constexpr int kRowsAroundPole = 2;

inline std::unique_ptr<PolyMesh> mesh_within(const BoundaryLoop& loop, Uv middle, bool has_quads) {
  const int count = static_cast<int>(loop.size());
  FaceList faces;
  for (int k = 0; k < count; ++k) {
    const int next = (k + 1) % count;
    for (int from = 0; from < kRowsAroundPole * count; from += count) {
      const std::array outer = {from + k, from + next},
                       inner = {outer[0] + count, outer[1] + count};
      if (has_quads) {
        faces.add(std::array{outer[0], outer[1], inner[1], inner[0]});
      } else {
        faces.add(std::array{outer[0], outer[1], inner[1]});
        faces.add(std::array{outer[0], inner[1], inner[0]});
      }
    }
    faces.add(std::array{kRowsAroundPole * count + k, kRowsAroundPole * count + next,
                         (kRowsAroundPole + 1) * count});
  }
  auto mesh = std::make_unique<PolyMesh>();
  const auto vertex_count = static_cast<std::size_t>((kRowsAroundPole + 1) * count + 1);
  build_faces(*mesh, vertex_count, faces, FirstSide::FromFirstCorner);
  const auto uv = attach(*mesh, keys::vertex_uv, middle);
  attach(*mesh, keys::vertex_metric, Metric{1, 0, 1});
  for (int row = 0; row <= kRowsAroundPole; ++row) {
    for (int k = 0; k < count; ++k) {
      mesh->property(uv, VertexHandle(row * count + k)) =
          lerp(loop[static_cast<std::size_t>(k)].uv, middle, 1 - std::pow(0.5, row));
    }
  }
  return mesh;
}

/// A cone whose mesh reaches its apex, before it is assembled.
struct PoleInMesh {
  PoleInMesh(bool has_quads, bool is_turned) {
    model.patches[0].is_reversed = is_turned;
    PatchBoundary boundary =
        boundary_with_pole(collect_boundary(model, 0, nodes, numbers, fields[0]));
    const Domain domain = model.surface(0).domain();
    auto mesh = mesh_within(boundary.loops[0], domain.at(0.5, 0.5), has_quads);
    patches.push_back(finish_patch(std::move(boundary), std::move(mesh), model.surface(0)));
  }

  Model model = cone_of(1);
  UniformSizes fields{model, 0.4};
  std::vector<ContourNodes> nodes = place_contour_nodes(model, fields).contours;
  NodeNumbers numbers{model, nodes};
  std::vector<PatchMesh> patches;
};

}  // namespace surfmesh::testing
