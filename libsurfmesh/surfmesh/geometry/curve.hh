// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// A curve in the parameters of a patch, over t in [0,1]. Immutable, safe from several threads.
class Curve {
 public:
  virtual ~Curve() = default;

  virtual Uv evaluate(double t) const = 0;
};

/// The straight segment from a (t = 0) to b (t = 1), exact at both ends.
class SegmentCurve : public Curve {
 public:
  SegmentCurve(Uv a, Uv b) : a_(a), b_(b) {}

  Uv evaluate(double t) const override { return lerp(a_, b_, t); }

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

}  // namespace surfmesh
