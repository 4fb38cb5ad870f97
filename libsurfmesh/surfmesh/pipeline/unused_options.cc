// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/unused_options.hh"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "surfmesh/core/option_range.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

Notice without_effect(std::string_view name, std::string_view reason) {
  return warning(NoticeKind::UnusedOption, fmt::format("{} has no effect {}", name, reason));
}

/// It may still be what makes the control space a mesh.
Notice unused_reuse(std::string_view reason) {
  return warning(NoticeKind::UnusedOption,
                 fmt::format("{} answers no question {}", ranges::kReuse.name, reason));
}

/// Segments of a circle are another way to say curvature.
Notices unused_curvature(const PipelineOptions& options) {
  if (options.sizing.segments_per_circle == 0 || !options.sizing.curvature) return {};
  return {without_effect(ranges::kCurvature.name, "beside segments_per_circle")};
}

/// Beside one length everywhere, other sizes that were asked for have no effect.
Notices unused_sizes(const PipelineOptions& options) {
  Notices notices;
  if (!options.sizing.size) return unused_curvature(options);
  PipelineOptions defaults;
  defaults.sizing.size = options.sizing.size;
  for (const std::string_view name :
       {ranges::kCurvature.name, ranges::kSegmentsPerCircle.name, ranges::kSag.name,
        ranges::kHmin.name, ranges::kHmax.name, ranges::kSharesOf.name, ranges::kStretch.name,
        ranges::kGrade.name, ranges::kProximity.name}) {
    // Segments of a circle change what curvature and hmin are by default.
    const bool is_segments = name == ranges::kSegmentsPerCircle.name;
    defaults.sizing.segments_per_circle = is_segments ? 0 : options.sizing.segments_per_circle;
    if (get_option(options, name) == get_option(defaults, name)) continue;
    notices.push_back(without_effect(name, "beside size"));
  }
  return notices;
}

/// What belongs to one way of placement or smoothing has no effect on the others.
Notices unused_for_triangles(const PipelineOptions& options) {
  const Smoothing smoothing = options.improve.smoothing;
  Notices notices;
  if (options.refine.conformity != 0 && options.refine.placement != Placement::Circumcentre) {
    notices.push_back(without_effect(ranges::kConformity.name, "without placement = circumcentre"));
  }
  if (options.improve.sweeps != ImproveOptions().sweeps && static_cast<int>(smoothing) >= 0) {
    notices.push_back(
        without_effect(ranges::kSweeps.name,
                       smoothing == Smoothing::Off
                           ? "without smoothing"
                           : fmt::format("beside smoothing = {}", static_cast<int>(smoothing))));
  }
  if (options.control.reuse != 0 && smoothing != Smoothing::Element) {
    notices.push_back(unused_reuse("without smoothing = element"));
  }
  return notices;
}

/// The way to quads has no effect without them, nor does the way of the fronts without these, nor
/// what makes triangles on the way without triangles.
Notices unused_ways(const PipelineOptions& every) {
  const QuadOptions& options = every.quads;
  Notices notices;
  const auto tell = [&](std::string_view name, std::string_view reason) {
    notices.push_back(without_effect(name, reason));
  };
  if (options.method != QuadMethod::Best && !options.is_on) {
    tell(ranges::kQuadMethod.name, "without quads");
  }
  if (options.front != QuadOptions{}.front && options.method != QuadMethod::Frontal) {
    tell(ranges::kQuadFront.name, "without quad_method = frontal");
  }
  const PipelineOptions defaults;
  const bool has_triangles = !options.is_on || options.method == QuadMethod::Frontal;
  if (has_triangles) {
    append(unused_for_triangles(every), notices);
    return notices;
  }
  for (const std::string_view name :
       {ranges::kPlacement.name, ranges::kKernel.name, ranges::kConformity.name,
        ranges::kSmoothing.name, ranges::kSweeps.name, ranges::kRepairs.name}) {
    if (get_option(every, name) != get_option(defaults, name)) tell(name, "on quads");
  }
  if (every.control.reuse != 0) notices.push_back(unused_reuse("on quads"));
  return notices;
}

}  // namespace

namespace detail {

Notices unused_options(const PipelineOptions& options) {
  Notices notices = unused_sizes(options);
  append(unused_ways(options), notices);
  return notices;
}

}  // namespace detail
}  // namespace surfmesh
