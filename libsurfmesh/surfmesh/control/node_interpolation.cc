// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/node_interpolation.hh"

#include <algorithm>
#include <utility>

#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

/// Bounds of the points where a table is looked at along its edges.
constexpr int kMostPointsOnEdge = 64;
constexpr std::size_t kMostPoints = 20'000;

bool is_among(Uv uv, const std::vector<ControlNode>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(),
                     [uv](const ControlNode& node) { return node.uv == uv; });
}

/// The nodes, and the corners that are not among them.
std::vector<ControlNode> with_corners(const Surface& surface,
                                      const std::vector<ControlNode>& nodes) {
  std::vector<ControlNode> result;
  for (ControlNode& corner : corners_like_nearest(surface, nodes)) {
    if (!is_among(corner.uv, nodes)) result.push_back(std::move(corner));
  }
  result.insert(result.end(), nodes.begin(), nodes.end());
  return result;
}

}  // namespace

std::vector<ControlNode> corners_like_nearest(const Surface& surface,
                                              const std::vector<ControlNode>& nodes) {
  const Domain domain = surface.domain();
  std::vector<ControlNode> corners;
  for (const auto& [s, t] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
    const Uv uv = domain.at(s, t);
    const Jet jet = surface.evaluate(domain.fold(uv), Order::First);
    const auto nearest = std::min_element(
        nodes.begin(), nodes.end(), [&](const ControlNode& a, const ControlNode& b) {
          return (a.point - jet.point).squaredNorm() < (b.point - jet.point).squaredNorm();
        });
    corners.push_back({uv, jet.point, first_form_factor(jet.du, jet.dv), nearest->size, {}});
  }
  return corners;
}

NodeInterpolation::NodeInterpolation(const Surface& surface, const std::vector<ControlNode>& nodes)
    : control_(std::make_shared<ControlMesh>(surface.domain(), with_corners(surface, nodes),
                                             ControlSpaceOptions())) {}

std::vector<Uv> NodeInterpolation::points() const {
  const PolyMesh& mesh = control_->mesh();
  const auto uv = require(mesh, keys::vertex_uv);
  const auto size = require(mesh, keys::vertex_size);
  std::vector<Uv> points = mesh.property(uv).data_vector();
  for (const EdgeHandle eh : mesh.edges()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    const VertexHandle from = mesh.from_vertex_handle(heh), to = mesh.to_vertex_handle(heh);
    const double least = std::min(size_range(mesh.property(size, from)).least,
                                  size_range(mesh.property(size, to)).least);
    const double steps = (mesh.point(to) - mesh.point(from)).norm() / least;
    const int count = static_cast<int>(std::min(steps, double{kMostPointsOnEdge}));
    if (points.size() + static_cast<std::size_t>(count) > kMostPoints) break;
    for (int i = 1; i < count; ++i) {
      points.push_back(lerp(mesh.property(uv, from), mesh.property(uv, to), double(i) / count));
    }
  }
  return points;
}

NodeInterpolation::Answer NodeInterpolation::at(const SurfacePoint& at) const {
  QueryHint hint;
  const SizeTensor size = control_->size(at, hint);
  return {size, hint.element};
}

}  // namespace surfmesh
