// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/close_loops.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/model/free_seam.hh"
#include "surfmesh/model/loop_region.hh"
#include "surfmesh/model/open_contours.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {
namespace {

/// Contours that meet in space but differ by this share of the domain in (u,v) do not meet there.
constexpr double kLoopJump = 1e-3;

/// The loops of a patch with that of the greatest area first, which is the outer one.
std::vector<std::size_t> outer_first(const std::vector<double>& areas) {
  std::vector<std::size_t> order(areas.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto outer = std::max_element(order.begin(), order.end(), [&](auto a, auto b) {
    return std::abs(areas[a]) < std::abs(areas[b]);
  });
  std::swap(order.front(), *outer);
  return order;
}

/// Check that all loops but the first in order are holes of it, not of each other.
void check_holes(const PatchInput& patch, const std::vector<LoopCurves>& curves,
                 const std::vector<std::size_t>& order) {
  if (order.size() < 2) return;
  const LoopRegions regions(curves);
  const std::size_t outer = order.front();
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t loop = order[i];
    const Uv p = curves[loop].front().at(0.5);
    const auto fail = [&](const char* reason) {
      fail_loop(ErrorCode::Geometry, patch, loop,
                fmt::format("the loop lies {} at (u,v) = ({:.6g}, {:.6g})", reason, p.u, p.v));
    };
    const std::vector<std::size_t> around = regions.around(p);
    if (std::ranges::count(around, outer) == 0) fail("outside of the outer loop");
    for (const std::size_t other : around) {
      if (other != outer && other != loop) fail("inside of a hole");
    }
  }
}

/// How to move the seam of a closed surface out of the way of contours; sides are not among these.
std::string seam_advice(const Surface& surface, const std::vector<LoopCurves>& loops) {
  std::vector<UvPath> paths;
  for (const LoopCurves& loop : loops) {
    for (const LoopCurve& curve : loop) {
      if (curve.name.find(':') == std::string::npos) paths.push_back(path_of(*curve.curve));
    }
  }
  const std::optional<std::string> advice = free_seam_advice(surface, paths, true);
  return advice ? "; " + *advice : std::string();
}

}  // namespace

std::string loop_label(const PatchInput& patch, std::size_t loop) {
  if (patch.origin.empty()) return fmt::format("patch {}: loop {}", patch.name, loop);
  return fmt::format("{}/loops/{}: patch {}", patch.origin, loop, patch.name);
}

void fail_loop(ErrorCode code, const PatchInput& patch, std::size_t loop,
               const std::string& reason) {
  throw Error(code, fmt::format("{}: {}", loop_label(patch, loop), reason));
}

LoopCurves LoopCloser::curves_of(const Chain& chain) const {
  LoopCurves result;
  for (const ChainLink& link : chain) {
    result.push_back({model_.contour(link.entry).name, model_.use(link.entry).curve, link.is_along,
                      contours_.range(link.entry.contour)});
  }
  return result;
}

std::vector<LoopCurves> LoopCloser::curves_of_all(const std::vector<Chain>& loops) const {
  std::vector<LoopCurves> result;
  for (const Chain& loop : loops) result.push_back(curves_of(loop));
  return result;
}

void LoopCloser::add_loops(int index, std::vector<Chain> loops) {
  const PatchInput& input = patch(index);
  std::vector<LoopCurves> curves;
  std::vector<double> areas;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    curves.push_back(curves_of(loops[l]));
    if (const auto location = find_point_outside(curves[l], input.surface->domain())) {
      fail_loop(ErrorCode::Geometry, input, l,
                fmt::format("the loop leaves the domain: {}{}", *location,
                            seam_advice(*input.surface, curves_of_all(loops))));
    }
    close(input, l, loops[l]);
    check_extent(input, l, loops[l]);
    areas.push_back(signed_area(curves[l]));
  }
  if (const auto location = crossing(curves)) {
    throw Error(ErrorCode::Geometry, fmt::format("{}: loops cross: {}", label(input), *location));
  }
  warn_of_near_parts(index, input, curves);
  const std::vector<std::size_t> order = outer_first(areas);
  check_holes(input, curves, order);
  for (const std::size_t l : order) {
    const bool is_turned = (areas[l] > 0) != (l == order[0]);
    if (is_turned) {
      Notice notice = warning_at(loop_label(input, l), NoticeKind::TurnedLoop,
                                 "the loop runs the wrong way round; it is turned");
      notice.patch = index;
      model_.notices.push_back(std::move(notice));
      std::reverse(loops[l].begin(), loops[l].end());
    }
    add(index, loops[l], is_turned);
  }
}

/// Check that contours meet end to end, and note that their ends are the same vertices.
void LoopCloser::close(const PatchInput& patch, std::size_t loop, const Chain& chain) {
  const Domain domain = patch.surface->domain();
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const ChainLink& from = chain[i];
    const ChainLink& to = chain[(i + 1) % chain.size()];
    const Contour& a = model_.contour(from.entry.contour);
    const Contour& b = model_.contour(to.entry.contour);
    const ContourUse &use_a = model_.use(from.entry), &use_b = model_.use(to.entry);
    const double end = from.is_along ? 1 : 0, start = to.is_along ? 0 : 1;
    const double gap = (model_.point(use_a, end) - model_.point(use_b, start)).norm();
    if (!(gap < reach_)) {
      fail_loop(ErrorCode::Geometry, patch, loop,
                fmt::format("the loop does not close, the gap between the end of {} and the start "
                            "of {} is {:.3g}",
                            a.name, b.name, gap));
    }
    const Uv p = use_a.curve->evaluate(end), q = use_b.curve->evaluate(start);
    if (std::abs(p.u - q.u) > kLoopJump * (domain.u1 - domain.u0) ||
        std::abs(p.v - q.v) > kLoopJump * (domain.v1 - domain.v0)) {
      fail_loop(ErrorCode::Geometry, patch, loop,
                fmt::format("between {} and {} the loop closes in space, but leaps from (u,v) = "
                            "({:.6g}, {:.6g}) to ({:.6g}, {:.6g}): a seam or pole is missing",
                            a.name, b.name, p.u, p.v, q.u, q.v));
    }
    equal_vertices_.emplace_back(from.is_along ? a.end : a.start, to.is_along ? b.start : b.end);
  }
}

/// A hole that is a point has no nodes; on a pole the loop has other contours, too.
void LoopCloser::check_extent(const PatchInput& patch, std::size_t loop, const Chain& chain) const {
  const bool is_point = std::all_of(chain.begin(), chain.end(), [&](const ChainLink& link) {
    return model_.contour(link.entry.contour).is_degenerate;
  });
  if (!is_point) return;
  fail_loop(ErrorCode::Geometry, patch, loop,
            fmt::format("the loop is a single point in space, seen with joining = {:.3g}",
                        model_.joining));
}

/// Elements between parts of the boundary that nearly meet are as flat as the gap is narrow. A slit
/// is a gap without material, which has no elements.
void LoopCloser::warn_of_near_parts(int index, const PatchInput& patch,
                                    const std::vector<LoopCurves>& curves) {
  const auto point_at = [&](Uv uv) { return patch.surface->evaluate(uv, Order::Position).point; };
  const std::vector<NearParts> gaps = near_parts(curves, kNearShare);
  if (gaps.empty()) return;
  const LoopRegions regions(curves);
  for (const NearParts& near : gaps) {
    if (!regions.is_in_material(lerp(near.at_a, near.at_b, 0.5))) continue;
    const Vec3 at = point_at(near.at_a);
    const double gap = (at - point_at(near.at_b)).norm();
    if (gap <= reach_) continue;  // they touch
    Notice notice = warning_at(
        label(patch), NoticeKind::NarrowGap,
        fmt::format("contours {} and {} nearly meet at (u,v) = ({:.6g}, {:.6g}): the gap between "
                    "them is {:.3g}",
                    near.a, near.b, near.at_a.u, near.at_a.v, gap));
    notice.patch = index;
    notice.point = at;
    model_.notices.push_back(std::move(notice));
  }
}

void LoopCloser::add(int patch, const Chain& chain, bool is_turned) {
  PatchLoop& loop = model_.patch(patch).loops.emplace_back();
  for (const ChainLink& link : chain) {
    model_.use(link.entry).is_forward = link.is_along != is_turned;
    loop.push_back(link.entry);
  }
}

void LoopCloser::unite_vertices() {
  DisjointSets sets(model_.vertices.size());
  for (const auto& [a, b] : equal_vertices_) {
    sets.unite(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  }
  std::vector<int> numbers(model_.vertices.size(), -1);
  std::vector<ModelVertex> kept;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t first = sets.find(i);
    if (first == i) {
      numbers[i] = static_cast<int>(kept.size());
      kept.push_back(model_.vertices[i]);
    } else {
      numbers[i] = numbers[first];
    }
  }
  model_.vertices = std::move(kept);
  for (Contour& contour : model_.contours) {
    contour.start = numbers[static_cast<std::size_t>(contour.start)];
    contour.end = numbers[static_cast<std::size_t>(contour.end)];
  }
}

}  // namespace surfmesh
