// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/brep_geometry.hh"

#include <array>

namespace surfmesh {
namespace {

/// As OpenCASCADE has them.
constexpr int kMostDegree = 25;
constexpr int kMostPoles = 1 << 24;

/// Curves that are parts of others, or at a distance from them, are made of others only so often.
constexpr int kMostDepth = 16;

/// Numbers of a line, a circle, an ellipse, a parabola and a hyperbola.
constexpr std::array<int, 5> kCurves2d = {4, 7, 8, 7, 8};
constexpr std::array<int, 5> kCurves3d = {6, 13, 14, 13, 14};

/// Numbers of a plane, a cylinder, a cone, a sphere and a torus.
constexpr std::array<int, 5> kSurfaces = {12, 13, 14, 13, 14};

bool flag(BrepWords& words) { return words.count(0, 1) == 1; }

void check_knots(BrepWords& words, int count) {
  for (int k = 0; k < count; ++k) {
    words.reals(1);
    words.count(1, kMostDegree + 1);
  }
}

void check_bezier_curve(BrepWords& words, int dimension) {
  const int size = dimension + (flag(words) ? 1 : 0);
  const int degree = words.count(1, kMostDegree);
  words.reals((degree + 1) * size);
}

void check_spline_curve(BrepWords& words, int dimension) {
  const int size = dimension + (flag(words) ? 1 : 0);
  flag(words);  // periodic
  words.count(1, kMostDegree);
  const int poles = words.count(2, kMostPoles), knots = words.count(2, kMostPoles);
  for (int p = 0; p < poles; ++p) words.reals(size);
  check_knots(words, knots);
}

void check_curve(BrepWords& words, int dimension, int depth = 0) {
  if (depth > kMostDepth) fail_brep("a curve is part of too many others");
  const int kind = words.count(1, 9);
  if (kind <= 5) {
    const auto& sizes = dimension == 2 ? kCurves2d : kCurves3d;
    return words.reals(sizes[static_cast<std::size_t>(kind - 1)]);
  }
  if (kind == 6) return check_bezier_curve(words, dimension);
  if (kind == 7) return check_spline_curve(words, dimension);
  // A part of a curve, or one at a distance from it, in space along a direction.
  words.reals(kind == 8 ? 2 : dimension == 2 ? 1 : 4);
  check_curve(words, dimension, depth + 1);
}

void check_bezier_surface(BrepWords& words) {
  const bool is_u_rational = flag(words), is_v_rational = flag(words);
  const int u = words.count(1, kMostDegree), v = words.count(1, kMostDegree);
  words.reals((u + 1) * (v + 1) * (is_u_rational || is_v_rational ? 4 : 3));
}

void check_spline_surface(BrepWords& words) {
  const bool is_u_rational = flag(words), is_v_rational = flag(words);
  flag(words);  // periodic along u
  flag(words);  // and v
  words.count(1, kMostDegree);
  words.count(1, kMostDegree);
  const int u = words.count(2, kMostPoles), v = words.count(2, kMostPoles);
  const int u_knots = words.count(2, kMostPoles), v_knots = words.count(2, kMostPoles);
  for (int i = 0; i < u; ++i) {
    for (int j = 0; j < v; ++j) words.reals(is_u_rational || is_v_rational ? 4 : 3);
  }
  check_knots(words, u_knots);
  check_knots(words, v_knots);
}

void check_surface(BrepWords& words, int depth = 0) {
  if (depth > kMostDepth) fail_brep("a surface is part of too many others");
  const int kind = words.count(1, 11);
  if (kind <= 5) return words.reals(kSurfaces[static_cast<std::size_t>(kind - 1)]);
  if (kind == 8) return check_bezier_surface(words);
  if (kind == 9) return check_spline_surface(words);
  if (kind <= 7) {
    words.reals(kind == 6 ? 3 : 6);
    return check_curve(words, 3);
  }
  words.reals(kind == 10 ? 4 : 1);
  check_surface(words, depth + 1);
}

}  // namespace

void check_brep_curves(BrepWords& words, int count, int dimension) {
  for (int i = 0; i < count; ++i) check_curve(words, dimension);
}

void check_brep_surfaces(BrepWords& words, int count) {
  for (int i = 0; i < count; ++i) check_surface(words);
}

}  // namespace surfmesh
