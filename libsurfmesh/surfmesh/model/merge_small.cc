// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/merge_small.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/geometry/parts.hh"
#include "surfmesh/geometry/project_to_curve.hh"

namespace surfmesh {
namespace {

/// Share of the width of a domain below which a side is a point in (u,v).
constexpr double kLeastShare = 1e-6;

/// Intervals of each part of a contour.
constexpr int kIntervalsOfLength = 8;

/// The length of a contour that is no longer than `most`.
std::optional<double> short_length(const Model& model, const Contour& contour, double most) {
  const ContourUse& use = contour.uses.front();
  double length = 0;
  Vec3 last = model.point(use, 0);
  for (const double t : divided_parts(contour.breaks, kIntervalsOfLength)) {
    const Vec3 next = model.point(use, t);
    length += (next - last).norm();
    if (length > most) return std::nullopt;
    last = next;
  }
  return length;
}

/// False for poles, which have a length in (u,v).
bool is_point_in_parameters(const Model& model, const Contour& contour) {
  return std::all_of(contour.uses.begin(), contour.uses.end(), [&](const ContourUse& use) {
    const Domain domain = model.surface(use).domain();
    const Uv step = use.curve->evaluate(1) - use.curve->evaluate(0);
    const Uv half = use.curve->evaluate(0.5) - use.curve->evaluate(0);
    return std::max(std::abs(step.u), std::abs(half.u)) <= kLeastShare * (domain.u1 - domain.u0) &&
           std::max(std::abs(step.v), std::abs(half.v)) <= kLeastShare * (domain.v1 - domain.v0);
  });
}

/// Give the notices of parts that have moved their new numbers; -1 for parts that are left out.
void renumber(const std::vector<int>& number, int Notice::*index, Notices& notices) {
  for (Notice& notice : notices) {
    if (notice.*index >= 0) notice.*index = number[static_cast<std::size_t>(notice.*index)];
  }
}

/// Leaves out short contours.
class ContourMerger {
 public:
  ContourMerger(Model& model, double least)
      : model_(model),
        least_(least),
        vertices_(model.vertices.size()),
        reach_(model.vertices.size(), 0),
        is_out_(model.contours.size(), 0) {}

  void run() {
    for (std::size_t c = 0; c < model_.contours.size(); ++c) {
      if (!is_mergeable(static_cast<int>(c))) continue;
      is_out_[c] = 1;
      ++count_;
      unite_ends(model_.contours[c]);
    }
    if (count_ == 0) return;
    tell();
    move_ends();
    for (Patch& patch : model_.patches) {
      for (PatchLoop& loop : patch.loops) {
        std::erase_if(loop, [this](const LoopEntry& entry) { return is_out(entry.contour); });
      }
    }
    drop_contours();
  }

 private:
  /// How far what has become one vertex with the ends of a contour reaches.
  double reach_of(const Contour& contour) {
    const std::size_t a = vertices_.find(static_cast<std::size_t>(contour.start));
    const std::size_t b = vertices_.find(static_cast<std::size_t>(contour.end));
    return reach_[a] + (a == b ? 0 : reach_[b]);
  }

  void unite_ends(const Contour& contour) {
    const double length = short_length(model_, contour, std::numeric_limits<double>::max()).value();
    const double reach = reach_of(contour) + length;
    vertices_.unite(static_cast<std::size_t>(contour.start), static_cast<std::size_t>(contour.end));
    reach_[vertices_.find(static_cast<std::size_t>(contour.start))] = reach;
  }

  bool is_out(int contour) const { return is_out_[static_cast<std::size_t>(contour)] != 0; }

  bool is_mergeable(int c) {
    const Contour& contour = model_.contour(c);
    if (contour.uses.empty()) return false;
    if (contour.start == contour.end && !is_point_in_parameters(model_, contour)) return false;
    const double most = std::max(least_, contour.tolerance);
    const auto length = short_length(model_, contour, most);
    if (!length || reach_of(contour) + *length > most) return false;
    // Something is to be left of each loop.
    for (const ContourUse& use : contour.uses) {
      for (const PatchLoop& loop : model_.patch(use).loops) {
        const auto left = std::count_if(loop.begin(), loop.end(), [&](const LoopEntry& entry) {
          return entry.contour != c && !is_out(entry.contour);
        });
        if (left < 1) return false;
      }
    }
    return true;
  }

  void tell() {
    const auto first = std::find(is_out_.begin(), is_out_.end(), 1);
    const Contour& contour = model_.contours[static_cast<std::size_t>(first - is_out_.begin())];
    const Vec3& at = model_.position(contour.start);
    Notice notice = warning(
        NoticeKind::MergedContours,
        fmt::format("contours that are shorter than the tolerance are left out: {}, the first: {} "
                    "at {}",
                    count_, contour.name, point_text(at)));
    notice.point = at;
    model_.notices.push_back(std::move(notice));
  }

  /// Vertices that have become one lie in the first; their tolerance covers the others.
  void move_ends() {
    for (std::size_t v = 0; v < model_.vertices.size(); ++v) {
      ModelVertex& kept = model_.vertices[vertices_.find(v)];
      const double distance = (model_.vertices[v].position - kept.position).norm();
      kept.tolerance = std::max(kept.tolerance, model_.vertices[v].tolerance + distance);
    }
    for (Contour& contour : model_.contours) {
      contour.start = static_cast<int>(vertices_.find(static_cast<std::size_t>(contour.start)));
      contour.end = static_cast<int>(vertices_.find(static_cast<std::size_t>(contour.end)));
    }
  }

  void drop_contours() {
    std::vector<int> number(model_.contours.size(), -1);
    int count = 0;
    for (std::size_t c = 0; c < number.size(); ++c) {
      if (is_out_[c] == 0) number[c] = count++;
    }
    for (Patch& patch : model_.patches) {
      for (PatchLoop& loop : patch.loops) {
        for (LoopEntry& entry : loop) {
          entry.contour = number[static_cast<std::size_t>(entry.contour)];
        }
      }
    }
    std::size_t c = 0;
    std::erase_if(model_.contours, [&](const Contour&) { return is_out_[c++] != 0; });
    renumber(number, &Notice::contour, model_.notices);
  }

  Model& model_;
  double least_;  ///< length, model units
  DisjointSets vertices_;
  std::vector<double> reach_;  ///< of what has become one vertex, by the first of them
  std::vector<char> is_out_;   ///< by contour
  std::size_t count_ = 0;
};

/// Leaves out patches without width.
class SliverMerger {
 public:
  SliverMerger(Model& model, double least) : model_(model), least_(least) {}

  void run() {
    std::vector<char> is_out(model_.patches.size(), 0);
    std::size_t count = 0;
    std::string first;
    for (std::size_t p = 0; p < is_out.size(); ++p) {
      if (model_.patches.size() - count < 2 || !has_no_width(model_.patches[p])) continue;
      const PatchLoop loop = model_.patches[p].loops.front();
      if (count == 0) first = model_.patches[p].name;
      unite(static_cast<int>(p), loop[0].contour, loop[1].contour);
      model_.patches[p].loops.clear();
      is_out[p] = 1;
      ++count;
    }
    if (count == 0) return;
    drop_patches(is_out);
    model_.notices.push_back(warning(
        NoticeKind::MergedContours,
        fmt::format("patches that are narrower than the tolerance are left out: {}, the first: {}",
                    count, first)));
  }

 private:
  bool has_no_width(const Patch& patch) const {
    if (patch.loops.size() != 1 || patch.loops.front().size() != 2) return false;
    const LoopEntry &a = patch.loops.front()[0], &b = patch.loops.front()[1];
    if (a.contour == b.contour) return false;
    const Contour &one = model_.contour(a), &other = model_.contour(b);
    if (one.is_degenerate || other.is_degenerate || one.start == one.end) return false;
    const double most = std::max({least_, one.tolerance, other.tolerance});
    const ContourUse& use = model_.use(b);
    const bool is_opposed = model_.use(a).is_forward == use.is_forward;
    for (const double t : divided_parts(one.breaks, kIntervalsOfLength)) {
      const Vec3 point = model_.point(model_.use(a), t);
      const double foot =
          project_to_curve(*patch.surface, *use.curve, point, is_opposed ? 1 - t : t);
      if ((model_.point(use, foot) - point).norm() > most) return false;
    }
    return true;
  }

  /// Give the uses of a contour to another one, but for those of a patch.
  void unite(int patch, int kept, int given) {
    Contour &to = model_.contour(kept), &from = model_.contour(given);
    const bool is_turned = to.start != from.start;
    to.tolerance = std::max(to.tolerance, from.tolerance) + least_;  // several add up
    to.is_named |= from.is_named;
    std::vector<int> kept_as(to.uses.size(), -1), given_as(from.uses.size(), -1);
    std::vector<ContourUse> uses;
    for (std::size_t u = 0; u < to.uses.size(); ++u) {
      if (to.uses[u].patch == patch) continue;
      kept_as[u] = static_cast<int>(uses.size());
      uses.push_back(std::move(to.uses[u]));
    }
    for (std::size_t u = 0; u < from.uses.size(); ++u) {
      ContourUse& use = from.uses[u];
      if (use.patch == patch) continue;
      given_as[u] = static_cast<int>(uses.size());
      if (is_turned) {
        use.curve = std::make_shared<CurvePart<Curve>>(use.curve, 1, 0);
        use.is_forward = !use.is_forward;
      }
      uses.push_back(std::move(use));
    }
    for (ContourUse& use : uses) use.is_same_speed = false;
    if (!uses.empty()) uses.front().is_same_speed = true;
    to.uses = std::move(uses);
    from.uses.clear();
    for_each_entry([&](LoopEntry& entry) {
      const auto use = static_cast<std::size_t>(entry.use);
      if (entry.contour == kept) entry.use = kept_as[use];
      if (entry.contour == given) entry = {kept, given_as[use]};
    });
  }

  template <class Change>
  void for_each_entry(Change change) {
    for (Patch& patch : model_.patches) {
      for (PatchLoop& loop : patch.loops) {
        for (LoopEntry& entry : loop) change(entry);
      }
    }
  }

  void drop_patches(const std::vector<char>& is_out) {
    std::vector<int> number(is_out.size(), -1);
    int count = 0;
    for (std::size_t p = 0; p < is_out.size(); ++p) {
      if (is_out[p] == 0) number[p] = count++;
    }
    for (Contour& contour : model_.contours) {
      for (ContourUse& use : contour.uses) use.patch = number[static_cast<std::size_t>(use.patch)];
    }
    for (Group& group : model_.groups) {
      for (int& patch : group.patches) patch = number[static_cast<std::size_t>(patch)];
      std::erase(group.patches, -1);
    }
    renumber(number, &Notice::patch, model_.notices);
    std::size_t p = 0;
    std::erase_if(model_.patches, [&](const Patch&) { return is_out[p++] != 0; });
    drop_unused_contours();
  }

  void drop_unused_contours() {
    std::vector<int> number(model_.contours.size(), -1);
    int count = 0;
    for (std::size_t c = 0; c < number.size(); ++c) {
      if (!model_.contours[c].uses.empty()) number[c] = count++;
    }
    for_each_entry(
        [&](LoopEntry& entry) { entry.contour = number[static_cast<std::size_t>(entry.contour)]; });
    std::erase_if(model_.contours, [](const Contour& contour) { return contour.uses.empty(); });
    renumber(number, &Notice::contour, model_.notices);
  }

  Model& model_;
  double least_;  ///< width, model units
};

}  // namespace

void merge_short_contours(Model& model, double least) { ContourMerger(model, least).run(); }

void merge_slivers(Model& model, double least) { SliverMerger(model, least).run(); }

}  // namespace surfmesh
