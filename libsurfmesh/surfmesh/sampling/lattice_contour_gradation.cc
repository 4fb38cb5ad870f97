// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/lattice_contour_gradation.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "surfmesh/control/grade_sizes.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/sampling/contour_rows.hh"

namespace surfmesh::detail {
namespace {

/// Sizes of two patches that differ by less agree: ln of their ratio.
constexpr double kAgreement = 0.02;

/// Sizes between the nodes on a contour that another patch gives smaller by less are as good.
constexpr double kMissOnContour = 0.1;

/// Units of the wanted sizes below which cells on a contour are not halved.
constexpr double kLeastUnits = 2;

class LatticeGradation {
 public:
  LatticeGradation(const Model& model, const std::vector<std::unique_ptr<ControlSpace>>& spaces)
      : changes_(spaces.size()),
        added_(spaces.size()),
        is_changed_(spaces.size(), 1),
        is_to_divide_(spaces.size(), 1) {
    for (const auto& space : spaces) spaces_.push_back(dynamic_cast<LatticeSpace*>(space.get()));
    for (std::size_t c = 0; c < model.contours.size(); ++c) {
      const Contour& contour = model.contours[c];
      if (contour.uses.size() < 2 || contour.is_degenerate) continue;
      contours_.emplace_back(model, c, spaces);
    }
  }

  ContourGradationReport run(const RunContext& context) {
    // Rows are added to patches one after the other, for several contours share a patch.
    for (ContourRows& contour : contours_) contour.make_rows();
    do {
      share_indices(contours_.size(), [this](std::size_t c) {
        if (touches(contours_[c], is_changed_)) contours_[c].update();
      });
      settle(context);
    } while (divide(context));
    return report_;
  }

 private:
  /// Give the nodes on contours what other patches have, until none comes down.
  void settle(const RunContext& context) {
    while (true) {
      context.throw_if_cancelled();
      std::vector<std::vector<Change>> changes(contours_.size());
      share_indices(contours_.size(),
                    [&](std::size_t c) { changes[c] = find_changes(contours_[c]); });
      if (!apply(changes)) return;
      grade_changed(context);
      ++report_.rounds;
    }
  }

  /// A size that a node of a patch is to take.
  struct Change {
    int patch;
    int node;
    SizeTensor size;
  };

  /// True if a patch of a contour is marked.
  static bool touches(const ContourRows& contour, const std::vector<char>& is_marked) {
    for (std::size_t use = 0; use < contour.use_count(); ++use) {
      if (is_marked[static_cast<std::size_t>(contour.patch(use))] != 0) return true;
    }
    return false;
  }

  std::vector<Change> find_changes(ContourRows& contour) const {
    std::vector<Change> changes;
    if (!touches(contour, is_changed_)) return changes;
    for (std::size_t use = 0; use < contour.use_count(); ++use) {
      for (ContourNode& node : contour.nodes(use)) {
        const SizeTensor size = contour.space(use).size(node.node);
        const SizeTensor least = least_seen(contour, use, node, size);
        if (log_conformity(size, least) <= kAgreement) continue;
        changes.push_back({contour.patch(use), node.node, least});
      }
    }
    return changes;
  }

  /// The minimum of a size with those of all other uses at its node, and of a row with those of the
  /// lattice around it.
  static SizeTensor least_seen(const ContourRows& contour, std::size_t use, ContourNode& node,
                               const SizeTensor& size) {
    SizeTensor least = size;
    if (!contour.side(use)) {
      const LatticeSpace& space = contour.space(use);
      const SizeTensor own = space.lattice_size(space.uv(node.node), node.sights[use].cell);
      least = limited_size(least, own);
    }
    for (std::size_t other = 0; other < node.sights.size(); ++other) {
      if (other == use) continue;
      const SizeTensor there = from_contour(contour.size_seen(other, use, node), node.frame);
      least = limited_size(least, there);
    }
    return least;
  }

  /// Set the sizes, in the order of the contours. Returns whether there were any.
  bool apply(const std::vector<std::vector<Change>>& changes) {
    std::fill(is_changed_.begin(), is_changed_.end(), 0);
    bool is_any = false;
    for (const auto& of_contour : changes) {
      for (const Change& change : of_contour) {
        const auto p = static_cast<std::size_t>(change.patch);
        LatticeSpace& space = *spaces_[p];
        space.set_size(change.node, limited_size(space.size(change.node), change.size));
        changes_[p].push_back(change.node);
        is_changed_[p] = is_to_divide_[p] = 1;
        is_any = true;
      }
      report_.lowered += of_contour.size();
    }
    return is_any;
  }

  /// Grade the patches that have changed, from their changed nodes.
  void grade_changed(const RunContext& context) {
    share_indices(spaces_.size(), [&](std::size_t p) {
      if (changes_[p].empty()) return;
      spaces_[p]->grade(changes_[p], context);
      changes_[p].clear();
    });
  }

  /// Halve the cells that do not give between their nodes what other patches have there. Returns
  /// whether there were any.
  bool divide(const RunContext& context) {
    for (ContourRows& contour : contours_) {
      if (!touches(contour, is_to_divide_)) continue;
      for (std::size_t use = 0; use < contour.use_count(); ++use) {
        for (ContourNode& node : contour.nodes(use)) divide_around(contour, use, node);
        append(contour.extend_rows(use), contour.patch(use));
      }
    }
    share_indices(spaces_.size(), [this](std::size_t p) {
      if (is_to_divide_[p] != 0) append(spaces_[p]->divide_beside_finer(), static_cast<int>(p));
    });
    std::fill(is_to_divide_.begin(), is_to_divide_.end(), 0);
    bool is_any = false;
    for (std::size_t p = 0; p < added_.size(); ++p) {
      if (added_[p].empty()) continue;
      is_any = true;
      is_changed_[p] = is_to_divide_[p] = 1;
      changes_[p] = spaces_[p]->with_neighbours(added_[p]);
      report_.added += added_[p].size();
      added_[p].clear();
    }
    grade_changed(context);
    return is_any;
  }

  void divide_around(ContourRows& contour, std::size_t use, ContourNode& node) {
    const SizeTensor size = contour.space(use).size(node.node);
    const SizeTensor along = to_contour(size, node.frame);
    for (std::size_t other = 0; other < node.sights.size(); ++other) {
      ContourNode::Sight& sight = node.sights[other];
      if (other == use || sight.is_isotropic) continue;
      const SizeTensor wanted =
          from_contour(unfolded(along, contour.is_mirrored(use, other)), sight.frame);
      divide_cell(contour, other, {sight.at, wanted}, sight.cell);
    }
    if (contour.side(use)) return;
    divide_cell(contour, use, {contour.space(use).surface_point(node.node), size},
                node.sights[use].cell);
  }

  /// A size that is wanted at a point.
  struct Wanted {
    SurfacePoint at;
    SizeTensor size;
  };

  void divide_cell(const ContourRows& contour, std::size_t use, const Wanted& wanted, int& cell) {
    LatticeSpace& space = contour.space(use);
    const SizeTensor given = space.lattice_size(wanted.at.uv, cell);
    if (log_conformity(given, limited_size(given, wanted.size)) <= kMissOnContour) return;
    Metric metric = metric_from_size(wanted.at.form, wanted.size);
    // Across a side, what a lattice gives on the side does not depend on its cells.
    const auto side = contour.side(use);
    if (side == DomainSide::LowerU || side == DomainSide::UpperU) metric.m11 = metric.m12 = 0;
    if (side == DomainSide::LowerV || side == DomainSide::UpperV) metric.m22 = metric.m12 = 0;
    append(space.divide_cell(wanted.at.uv, metric, kLeastUnits), contour.patch(use));
  }

  void append(const std::vector<int>& nodes, int patch) {
    auto& added = added_[static_cast<std::size_t>(patch)];
    added.insert(added.end(), nodes.begin(), nodes.end());
  }

  std::vector<LatticeSpace*> spaces_;
  std::vector<ContourRows> contours_;
  std::vector<std::vector<int>> changes_;  ///< nodes to grade from, by patch
  std::vector<std::vector<int>> added_;    ///< nodes of halved cells, by patch
  std::vector<char> is_changed_;           ///< by patch, since the last comparison
  std::vector<char> is_to_divide_;         ///< by patch, if it has changed since the last halving
  ContourGradationReport report_;
};

}  // namespace

ContourGradationReport grade_lattices_across_contours(
    const Model& model, const std::vector<std::unique_ptr<ControlSpace>>& spaces,
    const RunContext& context) {
  return LatticeGradation(model, spaces).run(context);
}

}  // namespace surfmesh::detail
