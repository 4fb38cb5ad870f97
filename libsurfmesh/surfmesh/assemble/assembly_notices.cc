// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/assembly_notices.hh"

#include <fmt/format.h>

#include <vector>

#include "surfmesh/assemble/promised_topology.hh"

namespace surfmesh::detail {
namespace {

/// Vertices of the model at which patches meet in nothing but this point, so that the mesh has
/// several there although no contour is cut.
std::vector<int> touched_vertices(const Model& model) {
  const PromisedTopology promise = promised_topology(model);
  std::vector<char> is_touched = promise.is_split;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const Contour& contour = model.contours[c];
    if (promise.is_open[c] == 0 || contour.uses.size() < 2) continue;
    for (const int end : {contour.start, contour.end}) {
      is_touched[static_cast<std::size_t>(end)] = 0;
    }
  }
  std::vector<int> result;
  for (std::size_t v = 0; v < is_touched.size(); ++v) {
    if (is_touched[v] != 0) result.push_back(static_cast<int>(v));
  }
  return result;
}

}  // namespace

Notices notices_of_assembly(const Model& model, std::size_t cut_sides) {
  Notices notices;
  if (cut_sides > 0) {
    notices.push_back(warning(
        NoticeKind::CutEdges,
        fmt::format("{} sides of faces are left open where three or more patches meet, or where "
                    "the surface cannot be oriented",
                    cut_sides)));
  }
  if (const std::vector<int> touched = touched_vertices(model); !touched.empty()) {
    const Vec3& first = model.position(touched.front());
    notices.push_back(warning(
        NoticeKind::SplitVertices,
        fmt::format("vertices that are taken apart, as patches meet there in a point only: {}, the "
                    "first at {}",
                    touched.size(), point_text(first))));
    notices.back().point = first;
  }
  return notices;
}

}  // namespace surfmesh::detail
