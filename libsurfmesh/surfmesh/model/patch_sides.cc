// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/patch_sides.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/geometry/quasirandom.hh"
#include "surfmesh/model/open_contours.hh"

namespace surfmesh {
namespace {

/// Sides nearer than so many times the joining were perhaps meant to be joined.
constexpr double kNearPerJoining = 10;

/// Samples of a side among which the places of other sides' ends are looked for.
constexpr int kSideSamples = 64;

/// The golden ratio's fraction: its multiples are the least periodic numbers.
constexpr double kGolden = 0.6180339887498949;

constexpr int kPatchIntervals = 16;
constexpr int kAreaSamples = 256;

/// Greatest area of a patch in squares of its diagonal. A spiral of 10,000 turns has less; what has
/// more is a wave that no sample of sides, sizes or curvature resolves, such as sin(1e9*u).
constexpr double kMostFolds = 1e5;

Box3 bounds(const PatchInput& patch) try {
  const Domain domain = patch.surface->domain();
  Box3 box;
  for (int i = 0; i <= kPatchIntervals; ++i) {
    for (int j = 0; j <= kPatchIntervals; ++j) {
      const Uv uv = domain.at(double(i) / kPatchIntervals, double(j) / kPatchIntervals);
      box.extend(patch.surface->evaluate(uv, Order::Position).point);
    }
  }
  return box;
} catch (const Error& error) {
  throw Error(error.code(), fmt::format("{}: {}", label(patch), error.what()));
}

/// The area of a surface by samples that no wave is in step with, and that do not touch poles.
struct SampledArea {
  double mean = 0;
  double median = 0;  ///< half of it is below the area, whatever singular derivatives there are
};

SampledArea area(const Surface& surface) {
  const Domain domain = surface.domain();
  const double whole = (domain.u1 - domain.u0) * (domain.v1 - domain.v0);
  std::vector<double> areas;
  double sum = 0;
  for (int i = 1; i <= kAreaSamples; ++i) {
    const Jet jet = surface.evaluate(quasirandom_point(domain, i), Order::First);
    areas.push_back(whole * jet.du.cross(jet.dv).norm());
    sum += areas.back();
  }
  const auto middle = areas.begin() + kAreaSamples / 2;
  std::nth_element(areas.begin(), middle, areas.end());
  return {sum / kAreaSamples, *middle};
}

/// Fail if a surface has no area, or so much that it is folded beyond all sampling. `extent` is the
/// diagonal of its box; what is no wider than `width` is a point or a line.
void check_area(const PatchInput& patch, double extent, double width) {
  const bool is_point = !(extent > width);
  const SampledArea sampled = area(*patch.surface);
  if (is_point || !(sampled.mean > width * extent)) {
    throw Error(ErrorCode::Geometry, fmt::format("{}: its surface is a {}, without area",
                                                 label(patch), is_point ? "point" : "line"));
  }
  if (sampled.median > kMostFolds * extent * extent) {
    throw Error(ErrorCode::Geometry,
                fmt::format("{}: its surface goes to and fro too often to be meshed: its area is "
                            "about {:.2g}, within a box of diagonal {:.3g}",
                            label(patch), sampled.mean, extent));
  }
}

void check_domain(const PatchInput& patch) {
  const Domain d = patch.surface->domain();
  if (d.shape != Domain::Shape::Rectangle) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: its domain is not a rectangle", label(patch)));
  }
  const bool is_finite = std::isfinite(d.u1 - d.u0) && std::isfinite(d.v1 - d.v0);
  if (!is_finite || !(d.u0 < d.u1 && d.v0 < d.v1)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: its domain u from {} to {}, v from {} to {} is empty",
                            label(patch), d.u0, d.u1, d.v0, d.v1));
  }
}

}  // namespace

std::vector<double> sample_parameters(int count) {
  std::vector<double> result{0};
  for (int i = 1; i < count; ++i) {
    const double multiple = i * kGolden;
    result.push_back((i + multiple - std::floor(multiple)) / (count + 1));
  }
  result.push_back(1);
  return result;
}

double SideLine::project(const Vec3& point, double t_guess) const {
  return project_to_curve(*surface, SegmentCurve(a, b), point, t_guess);
}

SideLine SideLine::part(double t0, double t1) const {
  SideLine result{patch, surface, at_uv(t0), at_uv(t1)};
  if (a.u == b.u) result.a.u = result.b.u = a.u;
  if (a.v == b.v) result.a.v = result.b.v = a.v;
  return result;
}

Box3 SampledLine::box() const {
  Box3 result;
  for (const Vec3& point : points) result.extend(point);
  const Vec3 margin = Vec3::Constant(max_step());
  return {result.min() - margin, result.max() + margin};
}

double SampledLine::max_step() const {
  double result = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    result = std::max(result, (points[i] - points[i - 1]).norm());
  }
  return result;
}

double SampledLine::length() const {
  double result = 0;
  for (std::size_t i = 1; i < points.size(); ++i) result += (points[i] - points[i - 1]).norm();
  return result;
}

std::size_t SampledLine::nearest(const Vec3& point) const {
  const auto is_nearer = [&](const Vec3& p, const Vec3& q) {
    return (p - point).squaredNorm() < (q - point).squaredNorm();
  };
  const auto least = std::min_element(points.begin(), points.end(), is_nearer);
  return static_cast<std::size_t>(least - points.begin());
}

SampledLine sample(const SideLine& line, int count) {
  SampledLine result{line, {}};
  for (const double t : sample_parameters(count)) result.points.push_back(line.at(t));
  return result;
}

void check_patches(const std::vector<PatchInput>& patches) {
  if (patches.empty()) throw Error(ErrorCode::InvalidInput, "the model has no patches");
  std::set<std::string_view> names;
  for (const PatchInput& patch : patches) {
    if (!names.insert(patch.name).second) {
      throw Error(ErrorCode::InvalidInput, fmt::format("{}: its name is used twice", label(patch)));
    }
    if (!patch.surface) {
      throw Error(ErrorCode::InvalidInput, fmt::format("{} has no surface", label(patch)));
    }
    check_domain(patch);
  }
}

std::string label(const PatchInput& patch) {
  return fmt::format("{}{}patch {}", patch.origin, patch.origin.empty() ? "" : ": ", patch.name);
}

Box3 measure_patches(const std::vector<PatchInput>& patches) {
  std::vector<double> extents;
  Box3 all;
  for (const PatchInput& patch : patches) {
    const Box3 box = bounds(patch);
    extents.push_back(box.diagonal().norm());
    if (!std::isfinite(extents.back())) {
      throw Error(ErrorCode::Geometry,
                  fmt::format("{}: its surface is too large: the diagonal of its box is {}",
                              label(patch), extents.back()));
    }
    all.extend(box);
  }
  const double diagonal = all.diagonal().norm();
  for (std::size_t i = 0; i < patches.size(); ++i) {
    check_area(patches[i], extents[i], kJoiningShare * diagonal);
  }
  return all;
}

double rounding_at(const Vec3& point) {
  return 16 * std::numeric_limits<double>::epsilon() * point.lpNorm<Eigen::Infinity>();
}

JoinLengths join_lengths(const Box3& box, const Length& joining) {
  const double diagonal = box.diagonal().norm();
  const double asked = joining.in_units(diagonal);
  if (asked > kMostJoining * diagonal) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("joining = {} must not be above {} % of the diagonal, which is {:.6g}",
                            to_text(joining), 100 * kMostJoining, diagonal));
  }
  // The rounding is more than the share where a model is far from the origin.
  const double rounding = std::max(rounding_at(box.min()), rounding_at(box.max()));
  return join_lengths(std::max(asked, rounding), diagonal);
}

JoinLengths join_lengths(double join, double diagonal) {
  return {join, std::max(kNearShare * diagonal, kNearPerJoining * join), diagonal};
}

std::vector<PatchSide> sides_of(const std::vector<PatchInput>& patches) {
  std::vector<PatchSide> result;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const Surface* surface = patches[p].surface.get();
    const Domain d = surface->domain();
    const Uv ends[4][2] = {{{d.u0, d.v0}, {d.u1, d.v0}},
                           {{d.u1, d.v0}, {d.u1, d.v1}},
                           {{d.u0, d.v1}, {d.u1, d.v1}},
                           {{d.u0, d.v0}, {d.u0, d.v1}}};
    for (std::size_t k = 0; k < 4; ++k) {
      const SideLine line{static_cast<int>(p), surface, ends[k][0], ends[k][1]};
      result.push_back(
          {patches[p].name + ":" + kSideNames[k], sample(line, kSideSamples), k < 2, false});
    }
  }
  return result;
}

}  // namespace surfmesh
