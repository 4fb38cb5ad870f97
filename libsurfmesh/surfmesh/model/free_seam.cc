// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/free_seam.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/project_to_surface.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {
namespace {

/// Places along a contour.
constexpr int kPlaces = 64;

/// The least room for a seam between contours, as a share of the period.
constexpr double kLeastRoom = 0.02;

/// Points nearer than this share of the surface's box are one.
constexpr double kSamePoint = 1e-9;

/// One of the two parameters of a surface.
struct Axis {
  const char* name;
  double from;
  double to;
  double Uv::*value;

  double period() const { return to - from; }
};

/// Both parameters of a domain.
std::array<Axis, 2> axes_of(const Domain& domain) {
  return {{{"u", domain.u0, domain.u1, &Uv::u}, {"v", domain.v0, domain.v1, &Uv::v}}};
}

/// The greatest distance between points of the surface and those a period before and behind, as a
/// share of its box.
double mismatch(const Surface& surface, const Axis& axis) {
  Box3 box;
  double greatest = 0;
  for (const double s : sample_parameters(kLineSamples / 4)) {
    for (const double t : sample_parameters(kLineSamples / 4)) {
      const Uv inside = surface.domain().at(s, t);
      const Vec3 point = surface.evaluate(inside, Order::Position).point;
      box.extend(point);
      for (const double periods : {-1.0, 1.0}) {
        Uv beyond = inside;
        beyond.*axis.value += periods * axis.period();
        const Vec3 again = surface.evaluate(beyond, Order::Position).point;
        greatest = std::max(greatest, (again - point).norm());
      }
    }
  }
  return greatest / box.diagonal().norm();
}

/// True if the surface repeats itself along an axis beyond its domain.
bool is_periodic(const Surface& surface, const Axis& axis) {
  try {
    return mismatch(surface, axis) <= kSamePoint;
  } catch (const Error&) {
    return false;  // it has no values there
  }
}

/// The part of the period that a contour covers, from its first place on; jumps over the seam are
/// taken the short way.
std::pair<double, double> covered_by(const UvPath& path, const Axis& axis) {
  double at = path.front().*axis.value, least = at, greatest = at;
  for (const Uv& place : path) {
    at += std::remainder(place.*axis.value - at, axis.period());
    least = std::min(least, at);
    greatest = std::max(greatest, at);
  }
  return {least, greatest};
}

/// The middle of the widest part of the period that no contour covers, where it is nearest to the
/// seam of today; nothing if there is no room.
std::optional<double> widest_gap(const std::vector<UvPath>& contours, const Axis& axis) {
  std::vector<std::pair<double, double>> covered;
  for (const UvPath& path : contours) {
    auto [from, to] = covered_by(path, axis);
    const double shift = std::floor((from - axis.from) / axis.period()) * axis.period();
    covered.emplace_back(from - shift, to - shift);
  }
  std::sort(covered.begin(), covered.end());
  covered.emplace_back(covered.front().first + axis.period(), 0);
  double end = covered.front().second, room = 0, middle = 0;
  for (std::size_t i = 1; i < covered.size(); ++i) {
    const double gap = covered[i].first - end;
    if (gap > room) std::tie(room, middle) = std::pair(gap, end + gap / 2);
    end = std::max(end, covered[i].second);
  }
  if (room < kLeastRoom * axis.period()) return std::nullopt;
  const double shift = std::round((middle - axis.from) / axis.period()) * axis.period();
  return middle - shift;
}

/// A number with few digits near another one.
double rounded(double value, double scale) {
  const double step = std::pow(10, std::floor(std::log10(scale * kLeastRoom / 2)));
  return std::round(value / step) * step;
}

}  // namespace

UvPath path_on(const Surface& surface, const SpaceCurve& curve) {
  UvPath path;
  for (int i = 0; i <= kPlaces; ++i) {
    path.push_back(
        find_near_points(surface, curve.evaluate(static_cast<double>(i) / kPlaces)).front().uv);
  }
  return path;
}

bool lies_on(const Surface& surface, const SpaceCurve& curve, const UvPath& path, double reach) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec3 point = curve.evaluate(static_cast<double>(i) / kPlaces);
    if (!((surface.evaluate(path[i], Order::Position).point - point).norm() < reach)) return false;
  }
  return true;
}

UvPath path_of(const Curve& curve) {
  UvPath path;
  for (int i = 0; i <= kPlaces; ++i) {
    path.push_back(curve.evaluate(static_cast<double>(i) / kPlaces));
  }
  return path;
}

std::optional<std::string> free_seam_advice(const Surface& surface,
                                            const std::vector<UvPath>& contours) {
  if (contours.empty()) return std::nullopt;
  for (const Axis& axis : axes_of(surface.domain())) {
    if (!is_periodic(surface, axis)) continue;
    const std::optional<double> gap = widest_gap(contours, axis);
    if (!gap) continue;
    const double from = rounded(*gap, axis.period());
    return fmt::format(
        "the surface is closed, and with the domain \"{}\": [{:.6g}, {:.17g}] no "
        "contour crosses its seam",
        axis.name, from, from + axis.period());
  }
  return std::nullopt;
}

}  // namespace surfmesh
