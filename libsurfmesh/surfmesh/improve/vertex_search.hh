// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "surfmesh/core/language_standard.hh"

/// How vertices are moved, in (u,v) and in space alike.
namespace surfmesh::vertex_search {

/// Metric length below which a move is not worth its metric query.
inline constexpr double kLeastMove = 0.01;

/// Gain of score for which a vertex is moved: far above rounding, so that a search ends.
inline constexpr double kLeastGain = 1e-6;

/// By so much the score of a point within a fifth of a unit may differ with its own metric and with
/// that of the vertex.
inline constexpr double kMetricChange = 0.02;

/// Steps of a search for a better position; four halvings and a few moves are usual.
inline constexpr int kMaxSearchRounds = 40;

/// Metric lengths of the steps of a search.
inline constexpr double kFirstStep = 0.2, kLastStep = 0.02;

/// Unit steps around a circle.
template <class Step>
std::array<Step, 8> directions() {
  std::array<Step, 8> steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(steps.size());
    steps[i] = {std::cos(angle), std::sin(angle)};
  }
  return steps;
}

}  // namespace surfmesh::vertex_search
