// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/mesh_contour_gradation.hh"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "surfmesh/control/grade_sizes.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/sampling/contour_frame.hh"

namespace surfmesh::detail {
namespace {

/// Sizes of two patches that differ by less agree: ln of their ratio. Interpolation between nodes
/// on a contour differs by about as much.
constexpr double kMeshAgreement = 0.05;

/// Greatest distance between two points where a contour is compared, in units of the smaller sizes.
constexpr double kLongestMeshStep = 2;
constexpr int kFirstMeshSteps = 4;
/// 4 × 2^12 points: more than sizes differ along one contour.
constexpr int kMaxMeshHalvings = 12;

/// A point of a contour as one of its patches sees it.
struct Side {
  SurfacePoint at;
  ContourFrame frame;
};

/// A point of a contour as all its patches see it.
struct Station {
  double t = 0;  ///< on the first use
  Vec3 point;
  std::vector<Side> sides;  ///< by use; none where a patch has no tangent plane
};

/// Sizes of one patch in the tangent frame of another.
SizeTensor carried(const SizeTensor& h, const Side& from, const Side& to, bool is_mirrored) {
  return from_contour(unfolded(to_contour(h, from.frame), is_mirrored), to.frame);
}

/// A contour and the points where its patches are compared.
class ComparedContour {
 public:
  ComparedContour(const Model& model, std::size_t index)
      : model_(model), contour_(model.contours[index]), index_(index) {}

  std::size_t index() const { return index_; }
  const std::vector<ContourUse>& uses() const { return contour_.uses; }

  Station station(double t) const {
    const Vec3 point = space_point(t);
    return {t, point, sides(t, point)};
  }

 private:
  Vec3 space_point(double t) const { return model_.point(contour_.uses.front(), t); }

  std::vector<Side> sides(double t, const Vec3& point) const {
    std::vector<Side> result;
    for (const ContourUse& use : contour_.uses) {
      const Surface& surface = model_.surface(use);
      const bool is_same = use.is_same_speed && contour_.uses.front().is_same_speed;
      const double own_t = is_same ? t : project_to_curve(surface, *use.curve, point, t);
      const Uv uv = surface.domain().clamp(use.curve->evaluate(own_t));
      const Jet jet = surface.evaluate(uv, Order::First);
      const FirstFormFactor form = first_form_factor(jet.du, jet.dv);
      const auto frame = contour_frame(*use.curve, own_t, form);
      if (!frame) return {};
      result.push_back({{uv, jet.point, form}, *frame});
    }
    return result;
  }

  const Model& model_;
  const Contour& contour_;
  std::size_t index_;  ///< of the contour in the model
};

class MeshGradation {
 public:
  MeshGradation(const Model& model, std::vector<ControlInput>& inputs,
                std::vector<std::unique_ptr<ControlSpace>>& spaces)
      : model_(model),
        inputs_(inputs),
        spaces_(spaces),
        given_(model.contours.size()),
        added_(model.contours.size()),
        is_changed_(spaces.size(), true) {}

  ContourGradationReport run(const RunContext& context) {
    do {
      context.throw_if_cancelled();
      // Spaces stay as they are until all contours are compared.
      share_indices(model_.contours.size(), [this](std::size_t c) {
        if (is_compared(model_.contours[c])) compare(c);
      });
      apply_added();
      ++report_.rounds;
    } while (remake_spaces());
    return report_;
  }

 private:
  bool is_compared(const Contour& contour) const {
    return contour.uses.size() > 1 && !contour.is_degenerate &&
           std::any_of(contour.uses.begin(), contour.uses.end(), [this](const ContourUse& use) {
             return is_changed_[static_cast<std::size_t>(use.patch)];
           });
  }

  void compare(std::size_t contour) {
    const ComparedContour compared(model_, contour);
    Station last = compared.station(0);
    lower(compared, last);
    for (int i = 1; i <= kFirstMeshSteps; ++i) {
      Station next = compared.station(double(i) / kFirstMeshSteps);
      compare_between(compared, last, next, kMaxMeshHalvings);
      lower(compared, next);
      last = std::move(next);
    }
  }

  /// Compare within an interval of t, at points two units apart at most.
  void compare_between(const ComparedContour& compared, const Station& from, const Station& to,
                       int halvings) {
    if (halvings == 0 || units_between(compared, from, to) <= kLongestMeshStep) return;
    const Station middle = compared.station(0.5 * (from.t + to.t));
    lower(compared, middle);
    compare_between(compared, from, middle, halvings - 1);
    compare_between(compared, middle, to, halvings - 1);
  }

  /// Length of an interval in the smallest sizes at its ends. Where one end is a pole, the other
  /// one tells.
  double units_between(const ComparedContour& compared, const Station& from,
                       const Station& to) const {
    const double length = (to.point - from.point).norm();
    double units = 0;
    for (const Station* station : {&from, &to}) {
      for (std::size_t use = 0; use < station->sides.size(); ++use) {
        const Side& side = station->sides[use];
        const SizeTensor along = to_contour(size(compared.uses()[use], side), side.frame);
        units = std::max(units, length / along.h11);
      }
    }
    return units;
  }

  SizeTensor size(const ContourUse& use, const Side& side) const {
    QueryHint hint;
    return spaces_[static_cast<std::size_t>(use.patch)]->size(side.at, hint);
  }

  /// Give each patch that asks for larger sizes than another a node there.
  void lower(const ComparedContour& compared, const Station& station) {
    const std::vector<Side>& sides = station.sides;
    if (sides.empty()) return;
    const std::vector<ContourUse>& uses = compared.uses();
    std::vector<SizeTensor> sizes;
    for (std::size_t use = 0; use < uses.size(); ++use) {
      sizes.push_back(size(uses[use], sides[use]));
    }
    for (std::size_t to = 0; to < uses.size(); ++to) {
      SizeTensor least = sizes[to];
      for (std::size_t from = 0; from < uses.size(); ++from) {
        if (from == to) continue;
        const bool is_mirrored = uses[from].is_forward == uses[to].is_forward;
        least = limited_size(least, carried(sizes[from], sides[from], sides[to], is_mirrored));
      }
      if (log_conformity(sizes[to], least) > kMeshAgreement &&
          is_news(compared, to, station.t, least)) {
        add(compared, to, sides[to], least);
      }
    }
  }

  /// False if the patch has got such a size at this point before. That the control space gives
  /// another one is then interpolation, which further nodes at one point do not change.
  bool is_news(const ComparedContour& compared, std::size_t use, double t, const SizeTensor& size) {
    auto& given = given_[compared.index()];
    const auto [entry, is_first] = given.try_emplace({use, t}, size);
    if (is_first) return true;
    const SizeTensor lowered = limited_size(entry->second, size);
    if (log_conformity(entry->second, lowered) <= kMeshAgreement) return false;
    entry->second = lowered;
    return true;
  }

  void add(const ComparedContour& compared, std::size_t use, const Side& side,
           const SizeTensor& size) {
    const int patch = compared.uses()[use].patch;
    added_[compared.index()].push_back(
        {static_cast<std::size_t>(patch), {side.at.uv, side.at.point, side.at.form, size}});
  }

  /// Give the nodes of all contours to their patches, in the order of the contours.
  void apply_added() {
    std::fill(is_changed_.begin(), is_changed_.end(), false);
    for (std::vector<AddedNode>& nodes : added_) {
      for (const AddedNode& added : nodes) {
        inputs_[added.patch].nodes.push_back(added.node);
        is_changed_[added.patch] = true;
      }
      report_.lowered += nodes.size();
      nodes.clear();
    }
  }

  /// Make the control spaces anew that have got nodes. Returns whether there are any.
  bool remake_spaces() {
    std::vector<std::size_t> changed;
    for (std::size_t p = 0; p < spaces_.size(); ++p) {
      if (is_changed_[p]) changed.push_back(p);
    }
    share_indices(changed.size(),
                  [&](std::size_t i) { spaces_[changed[i]] = make_control(inputs_[changed[i]]); });
    report_.spaces += changed.size();
    return !changed.empty();
  }

  /// A node that a patch gets on a contour.
  struct AddedNode {
    std::size_t patch;
    ControlNode node;
  };

  const Model& model_;
  std::vector<ControlInput>& inputs_;
  std::vector<std::unique_ptr<ControlSpace>>& spaces_;
  std::vector<std::map<std::pair<std::size_t, double>, SizeTensor>> given_;  ///< contour; use, t
  std::vector<std::vector<AddedNode>> added_;  ///< by contour, in this round
  std::vector<char> is_changed_;               ///< by patch, after the round before
  ContourGradationReport report_;
};

}  // namespace

ContourGradationReport grade_meshes_across_contours(
    const Model& model, std::vector<ControlInput>& inputs,
    std::vector<std::unique_ptr<ControlSpace>>& spaces, const RunContext& context) {
  return MeshGradation(model, inputs, spaces).run(context);
}

}  // namespace surfmesh::detail
