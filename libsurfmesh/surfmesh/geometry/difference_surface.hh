// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Adds derivatives, by differences of positions, to a surface that has none of its own.
///
/// Central differences over 1/4096 of the domain; where that would leave the domain, the point of
/// all derivatives moves inwards by the same amount.
///
/// Error    for a surface that turns once over its domain: relative 1e-7 from the step, in first
///          and second derivatives alike, and up to 1e-8 from rounding in second ones; 1e-3 beside
///          the border of the domain (test DifferenceSurface.*)
/// Cost     up to 9 evaluations of the position
class DifferenceSurface : public Surface {
 public:
  /// The surface must outlive this one.
  explicit DifferenceSurface(const Surface& surface) : surface_(surface) {}

  Jet evaluate(Uv uv, Order order) const override;
  Domain domain() const override { return surface_.domain(); }
  std::vector<SingularPoint> singular_points() const override { return surface_.singular_points(); }
  CellCount cells() const override { return surface_.cells(); }
  Uv from_cells(Uv point) const override { return surface_.from_cells(point); }
  Uv to_cells(Uv uv) const override { return surface_.to_cells(uv); }
  Uv beside_roundings(Uv uv) const override { return surface_.beside_roundings(uv); }

 private:
  Vec3 at(double u, double v) const { return surface_.evaluate({u, v}, Order::Position).point; }

  const Surface& surface_;
};

}  // namespace surfmesh
