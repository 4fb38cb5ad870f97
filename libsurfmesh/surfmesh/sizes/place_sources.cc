// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/place_sources.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/curve_polyline.hh"

namespace surfmesh {
namespace {

/// Share of a domain's width by which points on its boundary may lie outside: a few roundings, also
/// of a file's decimal digits.
constexpr double kOutsideByRounding = 1e-12;

/// Greatest distance of a chord from its curve, as a share of the least size there: far below what
/// elements of that size can follow.
constexpr double kPlaceChordShare = 0.1;

/// A placed size without its place.
PlacedSize wish_of(const LocalSize& wish, const SizeBounds& bounds) {
  PlacedSize placed;
  placed.at_from = placed.at_to = bounds.clamped(wish.size);
  placed.angle = wish.size.angle;
  placed.radius = bounds.radius(wish.radius);
  if (wish.outer) {
    placed.outer = {bounds.clamped(wish.outer->size), wish.outer->size.angle,
                    bounds.radius(wish.outer->radius)};
  }
  return placed;
}

void add_segment(PlacedSize placed, const Vec3& from, const Vec3& to,
                 std::vector<PlacedSize>& sizes) {
  placed.from = from;
  placed.to = to;
  sizes.push_back(placed);
}

void add_curve(const SpaceCurve& curve, const PlacedSize& placed, std::vector<PlacedSize>& sizes) {
  const auto points = curve_polyline(curve, kPlaceChordShare * least_length(placed));
  for (std::size_t i = 1; i < points.size(); ++i) {
    add_segment(placed, points[i - 1].point, points[i].point, sizes);
  }
}

/// A curve in the parameters of a surface that outlives it.
class CurveSeenOn : public SpaceCurve {
 public:
  CurveSeenOn(const Surface& surface, const Curve& curve) : surface_(surface), curve_(curve) {}

  Vec3 evaluate(double t) const override {
    return surface_.evaluate(curve_.evaluate(t), Order::Position).point;
  }

 private:
  const Surface& surface_;
  const Curve& curve_;
};

}  // namespace

Uv inside_domain(const Surface& surface, Uv uv) {
  const Domain domain = surface.domain();
  const Uv inside = domain.fold(domain.clamp(uv));
  const Uv step = inside - uv;
  const bool is_near = std::abs(step.u) <= kOutsideByRounding * (domain.u1 - domain.u0) &&
                       std::abs(step.v) <= kOutsideByRounding * (domain.v1 - domain.v0);
  if (is_near) return inside;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("a source at (u,v) = ({}, {}) lies outside the domain", uv.u, uv.v));
}

void add_at(const AtSource& source, const Surface& surface, const SizeBounds& bounds,
            std::vector<PlacedSize>& sizes) {
  const Vec3 point = surface.evaluate(inside_domain(surface, source.at), Order::Position).point;
  add_segment(wish_of({source.size, source.radius, source.outer}, bounds), point, point, sizes);
}

void add_along(const AlongSource& source, const Surface& surface, const SizeBounds& bounds,
               std::vector<PlacedSize>& sizes) {
  const PlacedSize placed = wish_of(source.wish, bounds);
  for (const auto& curve : source.curves) {
    add_curve(CurveSeenOn(surface, *curve), placed, sizes);
  }
}

void add_border(const InsideSource& source, const Surface& surface, const SizeBounds& bounds,
                std::vector<PlacedSize>& sizes) {
  const std::size_t count = source.polygon.size();
  if (count < 3) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("a polygon needs three corners or more, this one has {}", count));
  }
  for (const Uv corner : source.polygon) inside_domain(surface, corner);
  const PlacedSize placed = wish_of(source.wish, bounds);
  for (std::size_t i = 0; i < count; ++i) {
    const SegmentCurve side(source.polygon[i], source.polygon[(i + 1) % count]);
    add_curve(CurveSeenOn(surface, side), placed, sizes);
  }
}

void add_near(const NearSource& source, const SizeBounds& bounds, std::vector<PlacedSize>& sizes) {
  if (source.line.empty()) {
    throw Error(ErrorCode::InvalidInput, "a source near a line needs a point");
  }
  for (const Vec3& point : source.line) {
    if (!point.allFinite()) {
      throw Error(ErrorCode::InvalidInput, "a source is near a point that is not finite");
    }
  }
  const PlacedSize placed = wish_of(source.wish, bounds);
  if (source.line.size() == 1) add_segment(placed, source.line[0], source.line[0], sizes);
  for (std::size_t i = 1; i < source.line.size(); ++i) {
    add_segment(placed, source.line[i - 1], source.line[i], sizes);
  }
}

void add_box(const BoxSource& source, const SizeBounds& bounds, std::vector<PlacedSize>& sizes) {
  const Vec3 &low = source.box.min(), &high = source.box.max();
  if (!(low.allFinite() && high.allFinite() && (low.array() <= high.array()).all())) {
    throw Error(ErrorCode::InvalidInput, "a source is inside a box that is empty or not finite");
  }
  PlacedSize placed = wish_of(source.wish, bounds);
  placed.is_box = true;
  add_segment(placed, low, high, sizes);
}

bool contains(const std::vector<Uv>& polygon, Uv uv) {
  bool is_inside = false;
  for (std::size_t i = 0, last = polygon.size() - 1; i < polygon.size(); last = i++) {
    const Uv a = polygon[last], b = polygon[i];
    if ((a.v > uv.v) == (b.v > uv.v)) continue;
    const double u = a.u + (uv.v - a.v) / (b.v - a.v) * (b.u - a.u);
    if (uv.u < u) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace surfmesh
