// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/analytic.hh"
#include "support/metric_fields.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/model/join_sides.hh"

/// Models of a few patches: analytic surfaces, in one piece and cut.
namespace surfmesh::testing {

/// Makes a model only when its test runs: test programs list all their tests at each start.
using MakeModel = std::function<Model()>;

using Shape = std::shared_ptr<const Surface>;

/// The sides of a patch p, as its loop.
inline const std::vector<std::string> kSides = {"p:v0", "p:u1", "-p:v1", "-p:u0"};

/// Contours of more than one patch, or of one more than once.
inline int count_shared(const Model& model) {
  return static_cast<int>(std::count_if(model.contours.begin(), model.contours.end(),
                                        [](const Contour& c) { return c.uses.size() > 1; }));
}

/// The rectangle from (x0, y0) to (x1, y1) in the plane z = 0, with x and y as parameters.
inline Shape rectangle(double x0, double y0, double x1, double y1) {
  return std::make_shared<test::PlanePatch>(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(),
                                            Domain{x0, x1, y0, y1});
}

/// The part of the unit sphere between two longitudes.
inline Shape sphere(double u0 = 0, double u1 = 2 * std::numbers::pi) {
  return std::make_shared<test::Sphere>(
      1, Domain{u0, u1, -std::numbers::pi / 2, std::numbers::pi / 2});
}

inline Shape cylinder(double u0, double u1) {
  return std::make_shared<test::Cylinder>(1, Domain{u0, u1, 0, 1});
}

inline Shape whole_torus() {
  return std::make_shared<test::Torus>(2, 0.5,
                                       Domain{0, 2 * std::numbers::pi, 0, 2 * std::numbers::pi});
}

/// Patches p0, p1, ...
inline Model model_of(const std::vector<Shape>& shapes) {
  std::vector<PatchInput> patches;
  for (const Shape& shape : shapes) {
    patches.push_back({std::string("p").append(std::to_string(patches.size())), shape});
  }
  return model_from_patches(patches);
}

/// The square [-1,1]² with a round hole of the given radius about the origin.
inline Model square_with_hole(double radius) {
  Model model = model_of({rectangle(-1, -1, 1, 1)});
  const int vertex = static_cast<int>(model.vertices.size());
  model.vertices.push_back({Vec3(radius, 0, 0)});
  Contour hole;
  hole.name = "hole";
  hole.start = hole.end = vertex;
  hole.is_smooth = false;
  const auto curve = std::make_shared<CallableCurve>([=](double t) {
    const double angle = t == 1 ? 0 : 2 * std::numbers::pi * t;
    return Uv{radius * std::cos(angle), radius * std::sin(angle)};
  });
  // Counter-clockwise: the patch lies on the right.
  hole.uses.push_back({0, curve, false, true});
  model.patches[0].loops.push_back({{static_cast<int>(model.contours.size()), 0}});
  model.contours.push_back(std::move(hole));
  return model;
}

/// The ring between circles of radius 1 and less, whose nodes are not at the same angles.
inline Model narrow_ring(double radius) {
  Model model = square_with_hole(radius);
  Contour outer = model.contours.back();
  outer.name = "outer";
  outer.start = outer.end = static_cast<int>(model.vertices.size());
  const double phase = 0.37;
  model.vertices.push_back({Vec3(std::cos(phase), std::sin(phase), 0)});
  outer.uses[0] = {0, std::make_shared<CallableCurve>([=](double t) {
                     const double angle = phase + 2 * std::numbers::pi * (t == 1 ? 0 : t);
                     return Uv{std::cos(angle), std::sin(angle)};
                   }),
                   true, true};
  model.patches[0].loops = {{{static_cast<int>(model.contours.size()), 0}},
                            model.patches[0].loops.back()};
  model.contours.push_back(outer);
  return model;
}

/// The index of a contour by its name.
inline int contour_index(const Model& model, std::string_view name) {
  for (std::size_t i = 0; i < model.contours.size(); ++i) {
    if (model.contours[i].name == name) return static_cast<int>(i);
  }
  throw Error(ErrorCode::InvalidInput, "no contour " + std::string(name));
}

/// The metric of every patch: one wanted length in space.
class UniformSizes {
 public:
  UniformSizes(const Model& model, double size) {
    for (const Patch& patch : model.patches) {
      fields_.push_back(isotropic_field_on(*patch.surface, size));
    }
    for (const FunctionField& field : fields_) pointers_.push_back(&field);
  }
  UniformSizes(const UniformSizes&) = delete;
  UniformSizes& operator=(const UniformSizes&) = delete;

  operator const std::vector<const MetricField*>&() const { return pointers_; }
  const MetricField& operator[](int patch) const {
    return *pointers_[static_cast<std::size_t>(patch)];
  }

 private:
  std::vector<FunctionField> fields_;
  std::vector<const MetricField*> pointers_;
};

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
