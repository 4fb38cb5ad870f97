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

/// The part of the period that a contour covers; jumps over the seam are taken the short way.
struct Covered {
  double least;
  double greatest;
};

Covered covered_by(const UvPath& path, const Axis& axis) {
  double at = path.front().*axis.value;
  Covered covered{at, at};
  for (const Uv& place : path) {
    at += std::remainder(place.*axis.value - at, axis.period());
    covered.least = std::min(covered.least, at);
    covered.greatest = std::max(covered.greatest, at);
  }
  return covered;
}

/// True if a contour crosses the seam of today.
bool crosses_seam(const UvPath& path, const Axis& axis) {
  const double rounding = kSamePoint * axis.period();
  const Covered covered = covered_by(path, axis);
  return covered.least < axis.from - rounding || covered.greatest > axis.to + rounding;
}

/// The middle of the widest part of the period that no contour covers, where it is nearest to the
/// seam of today; nothing if there is no room.
std::optional<double> widest_gap(const std::vector<UvPath>& contours, const Axis& axis) {
  std::vector<std::pair<double, double>> covered;
  for (const UvPath& path : contours) {
    const auto [least, greatest] = covered_by(path, axis);
    const double shift = std::floor((least - axis.from) / axis.period()) * axis.period();
    covered.emplace_back(least - shift, greatest - shift);
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
  return middle - std::round((middle - axis.from) / axis.period()) * axis.period();
}

/// The same for contours that stay where they are in the parameters: the seam lies as far from the
/// least as from the greatest of these.
std::optional<double> gap_around(const std::vector<UvPath>& contours, const Axis& axis) {
  double least = contours.front().front().*axis.value, greatest = least;
  for (const UvPath& path : contours) {
    for (const Uv& place : path) {
      least = std::min(least, place.*axis.value);
      greatest = std::max(greatest, place.*axis.value);
    }
  }
  if (greatest - least > (1 - kLeastRoom) * axis.period()) return std::nullopt;
  return 0.5 * (least + greatest - axis.period());
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
                                            const std::vector<UvPath>& contours, bool are_fixed) {
  for (const Axis& axis : axes_of(surface.domain())) {
    const bool is_crossed = std::any_of(contours.begin(), contours.end(), [&](const UvPath& path) {
      return crosses_seam(path, axis);
    });
    if (!is_crossed || !is_periodic(surface, axis)) continue;
    const auto gap = are_fixed ? gap_around(contours, axis) : widest_gap(contours, axis);
    if (!gap) continue;
    const double from = rounded(*gap, axis.period());
    return fmt::format(
        "the surface is closed, and with the domain \"{}\": [{}, {}] no contour "
        "crosses its seam",
        axis.name, from, from + axis.period());
  }
  return std::nullopt;
}

}  // namespace surfmesh
