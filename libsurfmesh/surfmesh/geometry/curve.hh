// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// A curve in the parameters of a patch, over t in [0,1]. Immutable, safe to use from several
/// threads.
class Curve {
 public:
  virtual ~Curve() = default;

  virtual Uv evaluate(double t) const = 0;
};

/// The straight segment from a (t = 0) to b (t = 1), exact at both ends. A coordinate that both
/// ends have is that of all points, so that a segment on a side of a domain never leaves it.
class SegmentCurve : public Curve {
 public:
  SegmentCurve(Uv a, Uv b) : a_(a), b_(b) {}

  Uv evaluate(double t) const override {
    return {std::lerp(a_.u, b_.u, t), std::lerp(a_.v, b_.v, t)};
  }

 private:
  Uv a_;
  Uv b_;
};

/// A curve given by a C++ function of t in [0,1].
class CallableCurve : public Curve {
 public:
  explicit CallableCurve(std::function<Uv(double)> function) : function_(std::move(function)) {}

  Uv evaluate(double t) const override { return function_(t); }

 private:
  std::function<Uv(double)> function_;
};

/// A curve in space, over t in [0,1]. Immutable, safe to use from several threads.
class SpaceCurve {
 public:
  virtual ~SpaceCurve() = default;

  virtual Vec3 evaluate(double t) const = 0;

  /// The t between the parts that the curve consists of, ascending and in (0,1). Each part may hold
  /// as much detail as another whole curve: sample every part.
  virtual std::vector<double> breaks() const { return {}; }
};

/// A curve in space given by a C++ function of t in [0,1].
class CallableSpaceCurve : public SpaceCurve {
 public:
  explicit CallableSpaceCurve(std::function<Vec3(double)> function)
      : function_(std::move(function)) {}

  Vec3 evaluate(double t) const override { return function_(t); }

 private:
  std::function<Vec3(double)> function_;
};

/// The part of a curve, in the parameters of a patch or in space, between two of its t. Both ends
/// are exact.
template <class Whole>
class CurvePart : public Whole {
 public:
  CurvePart(std::shared_ptr<const Whole> whole, double from, double to)
      : whole_(std::move(whole)), from_(from), to_(to) {}

  decltype(std::declval<const Whole&>().evaluate(0)) evaluate(double t) const override {
    return whole_->evaluate(std::lerp(from_, to_, t));
  }

 private:
  std::shared_ptr<const Whole> whole_;
  double from_;
  double to_;
};

/// A curve in the parameters of a surface, as a curve in space.
class CurveOnSurface : public SpaceCurve {
 public:
  CurveOnSurface(std::shared_ptr<const Surface> surface, std::shared_ptr<const Curve> curve,
                 std::vector<double> breaks = {})
      : surface_(std::move(surface)), curve_(std::move(curve)), breaks_(std::move(breaks)) {}

  Vec3 evaluate(double t) const override {
    return surface_->evaluate(curve_->evaluate(t), Order::Position).point;
  }

  std::vector<double> breaks() const override { return breaks_; }

 private:
  std::shared_ptr<const Surface> surface_;
  std::shared_ptr<const Curve> curve_;
  std::vector<double> breaks_;
};

/// The parameter range in which the author wrote a curve. Messages give t in this range.
struct CurveRange {
  double from = 0;
  double to = 1;

  double at(double t) const { return (1 - t) * from + t * to; }
};

}  // namespace surfmesh
