// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Geom2d_Curve.hxx>
#include <memory>
#include <vector>

#include "surfmesh/geometry/curve.hh"

namespace surfmesh {

/// A curve of a file in the parameters of a face, over a range, moved by a step of its own at each
/// end and by what lies between them within.
struct ParameterCurve {
  Handle(Geom2d_Curve) curve;
  double first = 0;
  double last = 1;
  Uv move_first = {0, 0};
  Uv move_last = {0, 0};

  /// The ends, moved.
  Uv start() const;
  Uv end() const;
};

/// A curve over t in [0,1] that can be evaluated from several threads.
std::shared_ptr<const Curve> make_curve(const ParameterCurve& curve);

/// The inner knots of a curve where it may have a corner, as t.
std::vector<double> corners_of(const ParameterCurve& curve);

}  // namespace surfmesh
