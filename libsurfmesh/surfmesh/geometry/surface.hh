// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/domain.hh"

namespace surfmesh {

/// How many derivatives an evaluation gives.
enum class Order { Position = 0, First = 1, Second = 2 };

/// Position and derivatives of a surface at one (u,v). Members above the order asked for are NaN.
struct Jet {
  Vec3 point = Vec3::Constant(kUnset);
  Vec3 du = Vec3::Constant(kUnset);
  Vec3 dv = Vec3::Constant(kUnset);
  Vec3 duu = Vec3::Constant(kUnset);
  Vec3 duv = Vec3::Constant(kUnset);
  Vec3 dvv = Vec3::Constant(kUnset);
};

/// A point of the domain near which second derivatives grow without bound or are not those of the
/// true surface: an extraordinary vertex of a subdivision surface.
struct SingularPoint {
  Uv at;
  /// Parameter distance below which derivatives are an artefact of the evaluation.
  double reach = 0;
};

/// How many cells a surface consists of, side by side along u and along v.
struct CellCount {
  int u = 1;
  int v = 1;
};

/// A parametric surface p(u,v).
///
/// Implementations are immutable after construction; evaluation is const and may be called from
/// several threads at once.
class Surface {
 public:
  virtual ~Surface() = default;

  /// Evaluate position and, by `order`, first and second derivatives.
  ///
  /// Derivatives are exact up to rounding. Points outside of the domain by rounding errors are
  /// allowed.
  /// Throws   Geometry if the result is not finite, naming (u,v)
  virtual Jet evaluate(Uv uv, Order order) const = 0;

  virtual Domain domain() const = 0;

  /// Extraordinary points; none for analytic surfaces. They are corners of cells, on the border of
  /// the domain.
  virtual std::vector<SingularPoint> singular_points() const { return {}; }

  /// Number of cells. Each may hold as much detail as another whole surface: sample every cell.
  /// They are of equal width and height in parameters unless from_cells() says otherwise.
  virtual CellCount cells() const { return {}; }

  /// The (u,v) of a point in units of cells: from (0,0) to (cells().u, cells().v).
  virtual Uv from_cells(Uv point) const {
    const CellCount count = cells();
    return domain().at(point.u / count.u, point.v / count.v);
  }

  /// A point of the domain in units of cells, the inverse of from_cells().
  virtual Uv to_cells(Uv uv) const {
    const Domain all = domain();
    const CellCount count = cells();
    return {(uv.u - all.u0) / (all.u1 - all.u0) * count.u,
            (uv.v - all.v0) / (all.v1 - all.v0) * count.v};
  }

  /// The point whose curvature counts for sizes: the given one, or one beside it if that lies in
  /// the narrow rounding of a semi-sharp crease, which elements should not follow.
  virtual Uv beside_roundings(Uv uv) const { return uv; }
};

}  // namespace surfmesh
