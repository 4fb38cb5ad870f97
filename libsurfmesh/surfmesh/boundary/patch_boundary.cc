// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/patch_boundary.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/boundary/loop_steps.hh"
#include "surfmesh/boundary/metric_arc.hh"

namespace surfmesh {
namespace {

using Steps = std::vector<LoopStep>;

/// Start at a step that is neither on a pole nor behind one, so that none wraps around.
/// Returns  false if there is none
bool start_beside_poles(const Model& model, Steps& steps) {
  const auto is_pole = [&](const LoopStep& step) { return is_on_pole(model, step); };
  for (auto start = steps.begin(); start != steps.end(); ++start) {
    const LoopStep& before = start == steps.begin() ? steps.back() : *(start - 1);
    if (is_pole(*start) || is_pole(before)) continue;
    std::rotate(steps.begin(), start, steps.end());
    return true;
  }
  return false;
}

/// The nodes from which steps start.
BoundaryLoop nodes_of(const Steps& steps, const std::vector<ContourNodes>& nodes,
                      const NodeNumbers& numbers) {
  BoundaryLoop result;
  for (const auto& [entry, node, segment] : steps) {
    const auto& of_uses = nodes[static_cast<std::size_t>(entry.contour)].uv;
    result.push_back({of_uses[static_cast<std::size_t>(entry.use)][node],
                      numbers(entry.contour, static_cast<int>(node)), entry.contour});
  }
  return result;
}

/// The least number of faces of a fan between two nodes. Of two patches at a pole both fans are
/// between the same nodes.
int least_faces(const Model& model, int pole, const BoundaryNode& from, const BoundaryNode& to) {
  if (from.vertex == to.vertex) return 3;
  const auto sides = std::count_if(
      model.contours.begin(), model.contours.end(),
      [&](const Contour& contour) { return contour.is_degenerate && contour.start == pole; });
  return sides == 2 ? 2 : 1;
}

/// Nodes between `from` and `to` at equal metric distances along the straight line, for at least so
/// many faces of a fan.
std::vector<Uv> ring_between(const BoundaryNode& from, const BoundaryNode& to, int least_faces,
                             int segments_per_face, const MetricField& field) {
  const SegmentCurve line(from.uv, to.uv);
  const MetricArc arc(line, field);
  const int count =
      segments_per_face *
      std::max(least_faces, static_cast<int>(std::lround(arc.length() / segments_per_face)));
  std::vector<Uv> inner;
  for (int i = 1; i < count; ++i) {
    inner.push_back(line.evaluate(arc.parameter(i * arc.length() / count)));
  }
  return inner;
}

/// The pole whose nodes are those of a run and the one behind it, without its ring.
PoleFan fan_at(const PoleRun& run, const BoundaryLoop& chain) {
  PoleFan fan;
  fan.pole = chain[run.first].vertex;
  for (std::size_t k = 0; k <= run.count; ++k) fan.sides.push_back(chain[run.first + k].uv);
  fan.contour_to = chain[run.first - 1].contour;
  fan.contour_from = chain[run.first + run.count].contour;
  return fan;
}

/// What the fans of a patch are made from.
struct FanMaker {
  const Model& model;
  const MetricField& field;
  int segments_per_face;
  int offset;  ///< nodes in earlier loops
};

/// Replace each pole in a loop by a ring. The loop begins and ends with steps that are not on
/// poles.
BoundaryLoop cut_off_poles(const FanMaker& maker, const BoundaryLoop& chain,
                           const std::vector<PoleRun>& runs, std::vector<PoleFan>& fans) {
  const int offset = maker.offset;
  BoundaryLoop loop;
  const auto next_number = [&] { return offset + static_cast<int>(loop.size()); };
  std::size_t done = 0;
  const auto copy_to = [&](std::size_t end) {
    for (; done < end; ++done) loop.push_back(chain[done]);
  };
  for (const PoleRun& run : runs) {
    copy_to(run.first);
    PoleFan& fan = fans.emplace_back(fan_at(run, chain));
    done = run.first + run.count + 1;
    const bool is_last = done == chain.size();
    BoundaryNode& before = loop.back();
    const BoundaryNode& after = is_last ? chain.front() : chain[done];
    before.contour = -1;
    fan.ring.push_back(next_number() - 1);
    fan.segments_per_face = maker.segments_per_face;
    const int least = least_faces(maker.model, fan.pole, before, after);
    for (const Uv uv : ring_between(before, after, least, maker.segments_per_face, maker.field)) {
      fan.ring.push_back(next_number());
      loop.push_back({uv, -1, -1});
    }
    fan.ring.push_back(is_last ? offset : next_number());
  }
  copy_to(chain.size());
  return loop;
}

}  // namespace

NodeNumbers::NodeNumbers(const Model& model, const std::vector<ContourNodes>& nodes)
    : count_(static_cast<int>(model.vertices.size())) {
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    const int segments = nodes[c].segment_count();
    ranges_.push_back({model.contours[c].start, model.contours[c].end, count_, segments});
    count_ += std::max(0, segments - 1);
  }
  contour_count_ = count_;
}

int NodeNumbers::operator()(int contour, int node) const {
  const Range& range = ranges_[static_cast<std::size_t>(contour)];
  if (node == 0) return range.start;
  if (node == range.segments) return range.end;
  return range.first_inner + node - 1;
}

Uv point_on_pole(const PoleFan& fan, double share) {
  const double place = (fan.first_share + share * (fan.last_share - fan.first_share)) *
                       static_cast<double>(fan.sides.size() - 1);
  const auto side = std::min(static_cast<std::size_t>(place), fan.sides.size() - 2);
  return lerp(fan.sides[side], fan.sides[side + 1], place - static_cast<double>(side));
}

PatchBoundary collect_boundary(const Model& model, int patch,
                               const std::vector<ContourNodes>& nodes, const NodeNumbers& numbers,
                               const MetricField& field, int segments_per_face) {
  PatchBoundary boundary;
  boundary.patch = patch;
  FanMaker maker{model, field, segments_per_face, 0};
  for (const PatchLoop& loop : model.patch(patch).loops) {
    Steps steps = steps_along(model, loop, [&](int contour) {
      const int count = nodes[static_cast<std::size_t>(contour)].segment_count();
      return static_cast<std::size_t>(count);
    });
    const bool can_cut_off = start_beside_poles(model, steps);
    const BoundaryLoop chain = nodes_of(steps, nodes, numbers);
    const std::vector<PoleRun> poles =
        can_cut_off ? pole_runs(model, steps) : std::vector<PoleRun>{};
    boundary.loops.push_back(cut_off_poles(maker, chain, poles, boundary.fans));
    maker.offset += static_cast<int>(boundary.loops.back().size());
  }
  return boundary;
}

}  // namespace surfmesh
