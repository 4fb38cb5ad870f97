// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/node_interpolation.hh"

#include <algorithm>
#include <utility>

#include "surfmesh/geometry/first_form.hh"

namespace surfmesh {
namespace {

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
  return mesh.property(require(mesh, keys::vertex_uv)).data_vector();
}

NodeInterpolation::Answer NodeInterpolation::at(const SurfacePoint& at) const {
  QueryHint hint;
  const SizeTensor size = control_->size(at, hint);
  return {size, hint.element};
}

}  // namespace surfmesh
