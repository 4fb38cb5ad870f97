// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_space.hh"

#include "surfmesh/core/option_range.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {

void check(const ControlSpaceOptions& options) {
  check_option(ranges::kGrade, options.grade);
  check_option(ranges::kInterpolation, options.interpolation);
  check_option(ranges::kEpsilon, options.epsilon);
  check_option(ranges::kBlend, options.blend);
  check_option(ranges::kLookup, options.lookup);
  check_option(ranges::kReuse, options.reuse);
}

ControlSpace::ControlSpace(const ControlSpaceOptions& options,
                           const std::vector<ControlNode>& nodes)
    : options_(options),
      discs_(options.lookup == DiscLookup::Disc ? NodeDiscs(nodes) : NodeDiscs({})) {
  check(options);
}

SizeTensor ControlSpace::size(const SurfacePoint& at, QueryHint& hint) const {
  if (options_.reuse == 0) return size_anew(at, hint);
  const bool is_near =  // false before the first answer, which is NaN
      squared_length(hint.last_metric, at.uv - hint.last_uv) < options_.reuse * options_.reuse;
  if (is_near && hint.can_reuse) {
    ++hint.answers.reused;
    return hint.last_size;
  }
  hint.last_uv = at.uv;
  hint.last_size = size_anew(at, hint);
  hint.last_metric = metric_from_size(at.form, hint.last_size);
  return hint.last_size;
}

SizeTensor ControlSpace::size_anew(const SurfacePoint& at, QueryHint& hint) const {
  const bool by_vertices = options_.lookup == DiscLookup::Vertices;
  if (by_vertices) locate(at.uv, hint);
  const auto extended =
      by_vertices ? extended_size_by_vertices(at, hint) : discs_.size_at(at.point);
  if (extended && options_.grade == 0 && !options_.discs_meet_area_sources) {
    ++hint.answers.extended;
    return *extended;
  }
  if (!by_vertices) locate(at.uv, hint);
  const SizeTensor interpolated = interpolate(at, hint);
  return extended ? minimum(*extended, interpolated) : interpolated;
}

Metric ControlSpace::metric(const SurfacePoint& at, QueryHint& hint) const {
  return metric_from_size(at.form, size(at, hint));
}

}  // namespace surfmesh
