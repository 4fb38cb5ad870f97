// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/face_shapes.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

#include "surfmesh/cage/face_angles.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

/// Sine of the angle between derivatives below which they leave no normal.
constexpr double kLeastSine = 1e-6;

FaceShape shape_of(const Surface& surface) {
  const Domain domain = surface.domain();
  const int count = domain.corner_count();
  Uv middle{0, 0};
  std::vector<Uv> samples;
  for (int i = 0; i < count; ++i) {
    samples.push_back(domain.corner(i));
    samples.push_back(lerp(domain.corner(i), domain.corner((i + 1) % count), 0.5));
    middle = middle + (1.0 / count) * domain.corner(i);
  }
  samples.push_back(middle);
  FaceShape shape;
  Vec3 sum = Vec3::Zero();
  std::vector<Vec3> normals;
  try {
    for (const Uv uv : samples) {
      const Jet jet = surface.evaluate(uv, Order::First);
      const Vec3 area = jet.du.cross(jet.dv);
      const double length = area.norm();
      if (!(length > kLeastSine * jet.du.norm() * jet.dv.norm())) return {};
      shape.centre = jet.point;
      shape.area = length / (count == 3 ? 2 : 1);
      sum += area;
      normals.push_back(area / length);
    }
  } catch (const Error&) {
    return {};  // the surface is not finite there: such a face is no part of a region
  }
  shape.normal = sum.normalized();
  shape.turn = 0;
  for (const Vec3& normal : normals) {
    shape.turn = std::max(shape.turn, detail::angle_between(normal, shape.normal));
  }
  return shape;
}

}  // namespace

double turn_from(const FaceShape& shape, const Vec3& axis) {
  return detail::angle_between(shape.normal, axis) + shape.turn;
}

std::vector<FaceShape> shapes_of(const std::vector<std::shared_ptr<const Surface>>& surfaces) {
  std::vector<FaceShape> shapes(surfaces.size());
  share_ranges(surfaces.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) {
      if (surfaces[f]) shapes[f] = shape_of(*surfaces[f]);
    }
  });
  return shapes;
}

}  // namespace surfmesh
