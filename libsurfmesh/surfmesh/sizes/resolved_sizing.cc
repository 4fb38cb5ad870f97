// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/resolved_sizing.hh"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "surfmesh/core/error.hh"
#include "surfmesh/sizes/length.hh"

namespace surfmesh {
namespace {

void expect(bool is_good, std::string_view option, const std::string& value,
            std::string_view range) {
  if (is_good) return;
  throw Error(ErrorCode::InvalidOption,
              fmt::format("{} = {} is outside its range: {}", option, value, range));
}

void expect(bool is_good, std::string_view option, double value, std::string_view range) {
  expect(is_good, option, fmt::format("{}", value), range);
}

double resolve(std::string_view option, const Length& length, double diagonal) {
  const double units = length.in_units(diagonal);
  expect(units > 0 && std::isfinite(units), option, to_text(length), "a length above 0");
  return units;
}

SizeBounds resolve_bounds(const Sizing& sizing, double diagonal) {
  const SizeBounds bounds{resolve("hmin", sizing.hmin, diagonal),
                          resolve("hmax", sizing.hmax, diagonal), diagonal};
  if (bounds.hmin <= bounds.hmax) return bounds;
  // Only the size of the model may tell.
  throw Error(ErrorCode::InvalidOption,
              fmt::format("hmin = {} must not be above hmax = {}, which are lengths of {:.6g} and "
                          "{:.6g}",
                          to_text(sizing.hmin), to_text(sizing.hmax), bounds.hmin, bounds.hmax));
}

void check_numbers(const Sizing& sizing) {
  const auto is_from_zero = [](double x) { return x >= 0 && std::isfinite(x); };
  const bool is_grade = sizing.grade == 0 || (sizing.grade >= 1 && std::isfinite(sizing.grade));
  expect(is_from_zero(sizing.curvature_factor()), "curvature", sizing.curvature_factor(),
         "0 (off) or above");
  expect(sizing.stretch >= 1, "stretch", sizing.stretch, "1 or above");
  expect(is_grade, "grade", sizing.grade, "0 (off), or 1 and above");
  expect(is_from_zero(sizing.proximity), "proximity", sizing.proximity, "0 (off) or above");
}

}  // namespace

ResolvedSizing resolve(const Sizing& sizing, double diagonal) {
  check_numbers(sizing);
  return {.bounds = resolve_bounds(sizing, diagonal),
          .curvature = sizing.curvature_factor(),
          .sag = sizing.sag ? resolve("sag", *sizing.sag, diagonal) : 0,
          .stretch = sizing.stretch,
          .grade = sizing.grade,
          .contour_curvature = sizing.contour_curvature,
          .proximity = sizing.proximity,
          .features = sizing.features,
          .curvature_from = sizing.curvature_from};
}

}  // namespace surfmesh
