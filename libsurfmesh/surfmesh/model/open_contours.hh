// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "surfmesh/model/model.hh"

/// Search for contours that were perhaps meant to be one.
namespace surfmesh {

/// Share of the diagonal within which contours were perhaps meant to be joined.
inline constexpr double kNearShare = 1e-4;

/// A contour that one patch uses once: a true boundary.
struct OpenContour {
  const Contour* contour = nullptr;
  const Surface* surface = nullptr;
  std::vector<Vec3> points;
  Eigen::AlignedBox3d box;  ///< of the points, with a margin
};

/// The open contours of a model; `first_patch` is the index of its first patch in the contour uses.
std::vector<OpenContour> open_contours(const Model& model, int first_patch = 0);

/// Two contours that run along each other.
struct ContourPair {
  std::string a;
  std::string b;
  double gap = 0;  ///< greatest distance of the places compared
};

/// The pairs of contours, one of `a` and one of `b`, of which one is near the other all along, and
/// longer than four gaps.
///
/// Error    contours are compared at five places
/// Cost     O((n + m) log m), and some projections for each two whose boxes meet
std::vector<ContourPair> contours_along(const std::vector<OpenContour>& a,
                                        const std::vector<OpenContour>& b, double near);

/// The same of any two of some contours, each two once.
std::vector<ContourPair> contours_along(const std::vector<OpenContour>& all, double near);

}  // namespace surfmesh
