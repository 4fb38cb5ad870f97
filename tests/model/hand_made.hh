// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/models.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh::testing {

/// Builds models of polygons by hand: contours are straight in (u,v) and named by their vertices.
class HandMade {
 public:
  int add_vertex(const Vec3& position) {
    model.vertices.push_back({position});
    return static_cast<int>(model.vertices.size()) - 1;
  }

  int add_patch(std::shared_ptr<const Surface> surface) {
    model.patches.push_back({.name = std::string("p").append(std::to_string(model.patches.size())),
                             .surface = std::move(surface),
                             .loops = {}});
    return static_cast<int>(model.patches.size()) - 1;
  }

  int add_contour(int start, int end) {
    Contour contour;
    contour.name = std::to_string(start).append("-").append(std::to_string(end));
    contour.start = start;
    contour.end = end;
    model.contours.push_back(std::move(contour));
    return static_cast<int>(model.contours.size()) - 1;
  }

  /// A straight use, from `from` to `to` in the direction of the contour.
  LoopEntry add_use(int contour, int patch, Uv from, Uv to, bool is_forward = true) {
    auto& uses = model.contour(contour).uses;
    uses.push_back({patch, std::make_shared<SegmentCurve>(from, to), is_forward});
    return {contour, static_cast<int>(uses.size()) - 1};
  }

  /// A loop of new contours through vertices at points in (u,v), with the patch on its left.
  void add_loop(int patch, const std::vector<std::pair<int, Uv>>& corners) {
    PatchLoop loop;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& [from, from_uv] = corners[i];
      const auto& [to, to_uv] = corners[(i + 1) % corners.size()];
      loop.push_back(add_use(add_contour(from, to), patch, from_uv, to_uv));
    }
    model.patch(patch).loops.push_back(std::move(loop));
  }

  /// Vertices at points of the plane z = 0, whose parameters are x and y.
  std::vector<std::pair<int, Uv>> corners_at(const std::vector<Uv>& points) {
    std::vector<std::pair<int, Uv>> corners;
    for (const Uv uv : points) corners.emplace_back(add_vertex({uv.u, uv.v, 0}), uv);
    return corners;
  }

  Model model;
};

}  // namespace surfmesh::testing
