// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/contour_distance.hh"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/triangle_distance.hh"

namespace surfmesh {
namespace {

/// The least radius with which a search starts, as a share of the contour's box, and how much it
/// grows if nothing is found.
constexpr double kLeastRadius = 1e-3, kGrowth = 4;

/// A triangle of a face, or a border edge as one without area.
struct Element {
  std::array<Vec3, 3> corners;
  FaceHandle face;
};

std::vector<Element> border_edges_of(const PolyMesh& mesh) {
  std::vector<Element> elements;
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (!mesh.is_boundary(heh)) continue;
    const HalfedgeHandle inner = mesh.opposite_halfedge_handle(heh);
    const Vec3 a = to_eigen(mesh.point(mesh.from_vertex_handle(heh)));
    const Vec3 b = to_eigen(mesh.point(mesh.to_vertex_handle(heh)));
    elements.push_back({{a, b, b}, mesh.face_handle(inner)});
  }
  return elements;
}

std::vector<Element> triangles_of(const PolyMesh& mesh) {
  std::vector<Element> elements;
  for (const FaceHandle fh : mesh.faces()) {
    detail::visit_triangles(detail::corners_of(mesh, fh), [&](const auto& corners) {
      elements.push_back({detail::points_of(mesh, corners), fh});
    });
  }
  return elements;
}

std::vector<BoxTree::Box> boxes_of(const std::vector<Element>& elements) {
  std::vector<BoxTree::Box> boxes;
  for (const Element& element : elements) {
    BoxTree::Box& box = boxes.emplace_back();
    for (const Vec3& corner : element.corners) box.extend(corner);
  }
  return boxes;
}

/// Finds the element that is nearest to a point.
class Elements {
 public:
  explicit Elements(std::vector<Element> elements)
      : elements_(std::move(elements)), tree_(boxes_of(elements_)) {}

  bool is_empty() const { return elements_.empty(); }

  /// The distance and the face; the search starts with a radius above 0.
  std::pair<double, FaceHandle> nearest(const Vec3& point, double radius) const {
    std::pair<double, std::size_t> best(std::numeric_limits<double>::infinity(), 0);
    for (; best.first > radius; radius *= kGrowth) {
      const Vec3 reach = Vec3::Constant(radius);
      tree_.visit({point - reach, point + reach}, [&](std::size_t i) {
        const double distance = detail::triangle_distance(point, elements_[i].corners).distance;
        best = std::min(best, std::pair(distance, i));
      });
    }
    return {best.first, elements_[best.second].face};
  }

 private:
  std::vector<Element> elements_;
  BoxTree tree_;
};

double length_of_box(const std::vector<Vec3>& points) {
  BoxTree::Box box;
  for (const Vec3& point : points) box.extend(point);
  return box.diagonal().norm();
}

bool has(const std::vector<SharpContour>& contours, bool is_border) {
  return std::any_of(contours.begin(), contours.end(), [is_border](const SharpContour& contour) {
    return contour.is_border == is_border;
  });
}

}  // namespace

std::vector<ContourDistance> far_contour_points(const PolyMesh& mesh,
                                                const std::vector<SharpContour>& contours,
                                                double least, const RunContext& context) {
  using List = std::vector<Element>;
  const Elements borders(has(contours, true) ? border_edges_of(mesh) : List());
  const Elements triangles(has(contours, false) ? triangles_of(mesh) : List());
  std::vector<std::vector<ContourDistance>> far(contours.size());
  share_indices(contours.size(), [&](std::size_t c) {
    const Elements& elements = contours[c].is_border ? borders : triangles;
    if (elements.is_empty()) return;
    context.throw_if_cancelled();
    const std::vector<Vec3>& points = contours[c].points;
    const double radius = std::max(least, kLeastRadius * length_of_box(points));
    for (const Vec3& point : points) {
      const auto [distance, face] = elements.nearest(point, radius);
      if (distance > least) far[c].push_back({contours[c].contour, point, distance, face});
    }
  });
  std::vector<ContourDistance> result;
  for (const auto& of_contour : far) {
    result.insert(result.end(), of_contour.begin(), of_contour.end());
  }
  return result;
}

}  // namespace surfmesh
