// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "surfmesh/cage/bicubic_patch.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh::detail {

/// The squares of an irregular Catmull-Clark face on which its limit surface is one polynomial
/// each.
///
/// Away from extraordinary corners and semi-sharp sides that surface is made of bicubic pieces over
/// squares of the sides 1/2, 1/4, 1/8 and so on, which take half the time of the face to evaluate.
/// A square is such a piece if the polynomial that its corners determine is the surface inside,
/// too; those of the sides 1 to 1/8 are tried.
///
/// Error    positions to rounding; derivatives of first (second) order in a square of the side 1/n
///          to 3 n (9 n²) roundings of positions (test BicubicParts.*)
/// Source   Stam, Exact evaluation of Catmull-Clark subdivision surfaces (1998)
class BicubicParts {
 public:
  /// One piece, over a square of the face.
  class Part {
   public:
    Part(Uv corner, double squares_per_side, const BicubicPolynomial& polynomial)
        : corner_(corner), squares_per_side_(squares_per_side), polynomial_(polynomial) {}

    /// Position and derivatives at a point of the face.
    Jet evaluate(Uv uv, Order order) const;

   private:
    Uv corner_;
    double squares_per_side_;
    BicubicPolynomial polynomial_;
  };

  /// `surface` evaluates the face; where its derivatives are not finite, no piece is found.
  ///
  /// Cost     45 evaluations and 6 kB where one corner is extraordinary, 90 and 8 kB where a side
  ///          is semi-sharp
  explicit BicubicParts(const std::function<Jet(Uv, Order)>& surface);

  /// The piece that contains a point of the unit square; null if there is none.
  const Part* find(Uv uv) const;

 private:
  static constexpr int kFinest = 8;  ///< squares along a side of the smallest size

  std::vector<Part> parts_;
  std::array<std::int16_t, kFinest * kFinest> part_of_;  ///< by smallest square, rows along u
};

}  // namespace surfmesh::detail
