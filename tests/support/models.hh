// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/analytic.hh"
#include "surfmesh/geometry/join_sides.hh"

/// Models of analytic surfaces, in one piece and cut.
namespace surfmesh::testing {

using Shape = std::shared_ptr<const Surface>;

/// A model of patches p0, p1, ...
inline Model model_of(const std::vector<Shape>& shapes) {
  std::vector<PatchInput> patches;
  for (const Shape& shape : shapes) {
    patches.push_back({std::string("p").append(std::to_string(patches.size())), shape});
  }
  return model_from_patches(patches);
}

inline Shape plane(Vec3 origin, Vec3 a, Vec3 b) {
  return std::make_shared<test::PlanePatch>(std::move(origin), std::move(a), std::move(b));
}

/// Surfaces of one kind over pieces of u.
template <class Make>
Model model_of_pieces(int pieces, Make make) {
  std::vector<Shape> shapes;
  for (int i = 0; i < pieces; ++i) {
    const double full = 2 * std::numbers::pi;
    // Written so that the end of one piece is exactly the start of the next.
    shapes.push_back(make(full * i / pieces, full * (i + 1) / pieces));
  }
  return model_of(shapes);
}

inline Model sphere_of(int pieces) {
  return model_of_pieces(pieces, [](double u0, double u1) {
    constexpr double quarter = std::numbers::pi / 2;
    return std::make_shared<test::Sphere>(1, Domain{u0, u1, -quarter, quarter});
  });
}

inline Model torus_of(int pieces) {
  return model_of_pieces(pieces, [](double u0, double u1) {
    return std::make_shared<test::Torus>(2, 0.7, Domain{u0, u1, 0, 2 * std::numbers::pi});
  });
}

inline Model cylinder_of(int pieces) {
  return model_of_pieces(pieces, [](double u0, double u1) {
    return std::make_shared<test::Cylinder>(1, Domain{u0, u1, 0, 2});
  });
}

/// With its apex.
inline Model cone_of(int pieces) {
  return model_of_pieces(pieces, [](double u0, double u1) {
    return std::make_shared<test::Cone>(1, Domain{u0, u1, 0, 1});
  });
}

inline Model mobius_band() {
  return model_of(
      {std::make_shared<test::MobiusBand>(1, Domain{0, 2 * std::numbers::pi, -0.3, 0.3})});
}

inline Model unit_square() { return model_of({plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0})}); }

/// Two unit squares side by side, the second with its normal downwards.
inline Model opposite_squares() {
  return model_of({plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), plane({1, 0, 0}, {0, 1, 0}, {1, 0, 0})});
}

/// Three unit squares that share the side x = y = 0.
inline Model three_squares() {
  return model_of({plane({0, 0, 0}, {1, 0, 0}, {0, 0, 1}), plane({0, 0, 0}, {0, 1, 0}, {0, 0, 1}),
                   plane({0, 0, 0}, {-1, -1, 0}, {0, 0, 1})});
}

}  // namespace surfmesh::testing
