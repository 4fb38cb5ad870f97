// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// What defines a B-spline or NURBS surface, as files have it.
///
/// Knots are whole vectors: points + degree + 1 of them, with each knot as often as it counts. The
/// surface is there between the inner knots, from knots[degree] to the one with as many behind it;
/// ends may be clamped (degree + 1 equal knots) or not. A direction that is periodic has no point
/// twice, and its knots are those of one period from start to end: points + 1 of them. The first
/// point is then the one whose basis function begins `degree` knots before the start.
struct NurbsNet {
  std::array<int, 2> degree = {1, 1};             ///< along u, v; from 1 to kMostDegree
  std::array<std::vector<double>, 2> knots = {};  ///< of u, v; none smaller than the one before
  std::vector<std::vector<Vec3>> points = {};     ///< in rows along u: points[along v][along u]
  std::vector<std::vector<double>> weights = {};  ///< as points, above 0; empty if all are 1
  std::array<bool, 2> periodic = {false, false};  ///< along u, v
};

/// What defines a B-spline or NURBS curve in (u,v). Knots are as for NurbsNet.
struct NurbsPolygon {
  int degree = 1;  ///< from 1 to kMostDegree
  std::vector<double> knots = {};
  std::vector<Uv> points = {};
  std::vector<double> weights = {};  ///< as points, above 0; empty if all are 1
  bool periodic = false;
};

/// The greatest degree, as of CAD kernels. Beyond it, sums of powers lose too many digits.
inline constexpr int kMostDegree = 25;

/// What is wrong, and with which entry.
struct NurbsFault {
  std::string path;  ///< the entry as the end of a JSON pointer: "knots/0/5"
  std::string text;
};

/// Find what makes a surface or curve impossible: wrong counts, rows of different lengths, knots
/// that decrease, are all equal, or are so often equal that there is a jump inside, a degree out of
/// range, numbers that are not finite, weights that are not above 0.
std::optional<NurbsFault> find_fault(const NurbsNet& net);
/// Of a curve, likewise.
std::optional<NurbsFault> find_fault(const NurbsPolygon& polygon);

/// Throws   InvalidInput with the path and the text of the fault, if there is one
void check(const NurbsNet& net);
/// Of a curve, likewise.
void check(const NurbsPolygon& polygon);

}  // namespace surfmesh
