// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/contour_rows.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "surfmesh/control/grade_sizes.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh::detail {
namespace {

/// Share of the width of a domain by which points of a side lie beside it by rounding.
constexpr double kOnSide = 1e-12;

/// Where a use is looked at to tell if it runs along a side.
constexpr std::array<double, 3> kShares = {0.2817, 0.5, 0.6473};

/// Greatest distance between nodes of a row when it is made, in units of the smaller sizes, and
/// later in those of its own.
constexpr double kLongestStep = 1;
constexpr double kLongestLaterStep = 2;
constexpr int kFirstSteps = 4;
/// 4 × 2^12 nodes: more than sizes differ along one contour.
constexpr int kMaxHalvings = 12;
constexpr double kLeastStep = 1.0 / (kFirstSteps << kMaxHalvings);

bool is_at(double x, double line, double width) { return std::abs(x - line) <= kOnSide * width; }

/// Step of t from a pole, towards the middle of the contour, to where there is a direction.
constexpr double kStepFromPole = 1e-3;

/// The direction of a use at t; at a pole, that beside it, in whose frame the sizes of the pole
/// are.
std::optional<ContourFrame> frame_on(const ContourUse& use, const Surface& surface, double t,
                                     const FirstFormFactor& form) {
  if (const auto frame = contour_frame(*use.curve, t, form)) return frame;
  const double beside = t < 0.5 ? t + kStepFromPole : t - kStepFromPole;
  const Jet jet = surface.evaluate(use.curve->evaluate(beside), Order::First);
  return contour_frame(*use.curve, beside, first_form_factor(jet.du, jet.dv));
}

}  // namespace

ContourRows::ContourRows(const Model& model, std::size_t contour,
                         const std::vector<std::unique_ptr<ControlSpace>>& spaces)
    : model_(model), contour_(model.contours[contour]) {
  for (const ContourUse& use : contour_.uses) {
    auto& space = dynamic_cast<LatticeSpace&>(*spaces[static_cast<std::size_t>(use.patch)]);
    uses_.push_back({&use, &model.surface(use), &space, std::nullopt, {}});
    uses_.back().side = find_side(uses_.back());
  }
}

// --- sides ---

/// The side along which a use runs from node to node.
std::optional<DomainSide> ContourRows::find_side(const Use& use) const {
  const auto side = side_along(use);
  return side && ends_at_nodes(use, *side) ? side : std::nullopt;
}

bool ContourRows::ends_at_nodes(const Use& use, DomainSide side) const {
  const Domain& d = use.space->domain();
  const std::vector<int> nodes = use.space->nodes_on_side(side);
  const auto is_node = [&](Uv end) {
    return std::any_of(nodes.begin(), nodes.end(), [&](int node) {
      const Uv uv = use.space->uv(node);
      return is_at(uv.u, end.u, d.u1 - d.u0) && is_at(uv.v, end.v, d.v1 - d.v0);
    });
  };
  return is_node(use.use->curve->evaluate(0)) && is_node(use.use->curve->evaluate(1));
}

/// The side along which a use runs at even speed.
std::optional<DomainSide> ContourRows::side_along(const Use& use) const {
  const Domain& d = use.space->domain();
  const Uv a = use.use->curve->evaluate(0), b = use.use->curve->evaluate(1);
  const double width = d.u1 - d.u0, height = d.v1 - d.v0;
  for (const double t : kShares) {
    const Uv beside = use.use->curve->evaluate(t) - lerp(a, b, t);
    if (!is_at(beside.u, 0, width) || !is_at(beside.v, 0, height)) return std::nullopt;
  }
  const auto both_at_u = [&](double u) { return is_at(a.u, u, width) && is_at(b.u, u, width); };
  const auto both_at_v = [&](double v) { return is_at(a.v, v, height) && is_at(b.v, v, height); };
  if (both_at_u(d.u0)) return DomainSide::LowerU;
  if (both_at_u(d.u1)) return DomainSide::UpperU;
  if (both_at_v(d.v0)) return DomainSide::LowerV;
  if (both_at_v(d.v1)) return DomainSide::UpperV;
  const auto is_on_diagonal = [&](Uv p) {
    return is_at((p.u - d.u0) / width + (p.v - d.v0) / height, 1, 1);
  };
  const bool is_diagonal =
      d.shape == Domain::Shape::Triangle && is_on_diagonal(a) && is_on_diagonal(b);
  return is_diagonal ? std::optional(DomainSide::Diagonal) : std::nullopt;
}

/// Where a point of a side lies on a use; nothing if that runs along another part of the side.
std::optional<double> ContourRows::parameter_on_side(const Use& use, Uv uv) const {
  const Uv a = use.use->curve->evaluate(0), b = use.use->curve->evaluate(1);
  const Domain& d = use.space->domain();
  const Uv along{(b.u - a.u) / (d.u1 - d.u0), (b.v - a.v) / (d.v1 - d.v0)};
  const Uv to{(uv.u - a.u) / (d.u1 - d.u0), (uv.v - a.v) / (d.v1 - d.v0)};
  const double t = (along.u * to.u + along.v * to.v) / (along.u * along.u + along.v * along.v);
  if (!(t >= -kOnSide && t <= 1 + kOnSide)) return std::nullopt;
  return std::clamp(t, 0.0, 1.0);
}

void ContourRows::update() {
  for (std::size_t use = 0; use < uses_.size(); ++use) {
    if (uses_[use].side) {
      update_side(use);
      continue;
    }
    for (ContourNode& node : uses_[use].nodes) {
      if (node.sights.empty()) node = seen(use, node.node, node.t);
    }
  }
}

void ContourRows::update_side(std::size_t index) {
  Use& use = uses_[index];
  std::unordered_map<int, ContourNode> known;
  for (ContourNode& node : use.nodes) known.emplace(node.node, std::move(node));
  use.nodes.clear();
  for (const int node : use.space->nodes_on_side(*use.side)) {
    const auto old = known.find(node);
    if (old != known.end()) {
      use.nodes.push_back(std::move(old->second));
    } else if (const auto t = parameter_on_side(use, use.space->uv(node))) {
      use.nodes.push_back(seen(index, node, *t));
    }
  }
}

// --- what other uses see ---

ContourNode ContourRows::seen(std::size_t index, int node, double t) const {
  const Use& use = uses_[index];
  const SurfacePoint at = use.space->surface_point(node);
  ContourNode result{node, t};
  const auto frame = frame_on(*use.use, *use.surface, t, at.form);
  result.frame = frame.value_or(ContourFrame());
  result.sights.resize(uses_.size());
  for (std::size_t other = 0; other < uses_.size(); ++other) {
    if (other == index) continue;
    ContourNode::Sight& sight = result.sights[other];
    sight = sight_of(use, t, uses_[other], at.point);
    sight.is_isotropic = sight.is_isotropic || !frame;
  }
  return result;
}

ContourNode::Sight ContourRows::sight_of(const Use& from, double t, const Use& to,
                                         const Vec3& point) const {
  ContourNode::Sight result;
  result.t = t_on(from, t, to, point);
  const Domain domain = to.surface->domain();
  const Uv uv = domain.fold(domain.clamp(to.use->curve->evaluate(result.t)));
  const Jet jet = to.surface->evaluate(uv, Order::First);
  result.at = {uv, jet.point, first_form_factor(jet.du, jet.dv)};
  const auto frame = frame_on(*to.use, *to.surface, result.t, result.at.form);
  result.is_isotropic = !frame;
  result.frame = frame.value_or(ContourFrame());
  return result;
}

double ContourRows::t_on(const Use& from, double t, const Use& to, const Vec3& point) const {
  const bool is_same = from.use->is_same_speed && to.use->is_same_speed;
  return is_same ? t : project_to_curve(*to.surface, *to.use->curve, point, t);
}

SizeTensor ContourRows::row_size(const Use& use, double t) const {
  const std::vector<ContourNode>& nodes = use.nodes;
  const auto after =
      std::upper_bound(nodes.begin(), nodes.end(), t,
                       [](double value, const ContourNode& node) { return value < node.t; });
  const auto k = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - nodes.begin(), 1, std::ssize(nodes) - 1));
  const ContourNode &a = nodes[k - 1], &b = nodes[k];
  const double share = b.t > a.t ? std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0) : 0;
  return lerp(to_contour(use.space->size(a.node), a.frame),
              to_contour(use.space->size(b.node), b.frame), share);
}

SizeTensor ContourRows::size_seen(std::size_t from, std::size_t to, ContourNode& node) const {
  const Use& use = uses_[from];
  ContourNode::Sight& sight = node.sights[from];
  const SizeTensor along =
      use.side ? to_contour(use.space->lattice_size(sight.at.uv, sight.cell), sight.frame)
               : row_size(use, sight.t);
  if (sight.is_isotropic) return isotropic(size_range(along).least);
  return unfolded(along, is_mirrored(from, to));
}

// --- rows ---

void ContourRows::make_rows() {
  const bool has_all_sides =
      std::all_of(uses_.begin(), uses_.end(), [](const Use& use) { return use.side.has_value(); });
  if (has_all_sides) return;
  std::vector<Station> stations;
  Station last = station_at(0);
  for (int i = 1; i <= kFirstSteps; ++i) {
    const Station next = station_at(double(i) / kFirstSteps);
    add_stations(last, next, kMaxHalvings, stations);
    last = next;
  }
  stations.push_back(last);
  for (Use& use : uses_) {
    if (!use.side) make_row(use, stations);
  }
}

ContourRows::Station ContourRows::station_at(double t) const {
  const Use& first = uses_.front();
  Station station{t, model_.point(*first.use, t), std::numeric_limits<double>::infinity()};
  for (const Use& use : uses_) {
    const double own_t = t_on(first, t, use, station.point);
    const ControlNode node = row_node_at(use, own_t);
    const auto frame = contour_frame(*use.use->curve, own_t, node.form);
    if (frame) station.size = std::min(station.size, to_contour(node.size, *frame).h11);
  }
  return station;
}

/// Add the first station of an interval and stations within it, so that they are near each other.
void ContourRows::add_stations(const Station& from, const Station& to, int halvings,
                               std::vector<Station>& stations) const {
  const double units = (to.point - from.point).norm() / std::min(from.size, to.size);
  if (halvings > 0 && units > kLongestStep) {
    const Station middle = station_at(0.5 * (from.t + to.t));
    add_stations(from, middle, halvings - 1, stations);
    add_stations(middle, to, halvings - 1, stations);
    return;
  }
  stations.push_back(from);
}

/// A point of a use with the size of the lattice there.
ControlNode ContourRows::row_node_at(const Use& use, double t) const {
  const Domain domain = use.surface->domain();
  const Uv uv = domain.fold(domain.clamp(use.use->curve->evaluate(t)));
  const Jet jet = use.surface->evaluate(uv, Order::First);
  int near = -1;
  return {uv, jet.point, first_form_factor(jet.du, jet.dv), use.space->lattice_size(uv, near)};
}

void ContourRows::make_row(Use& use, const std::vector<Station>& stations) {
  std::vector<double> own;
  for (const Station& station : stations) {
    own.push_back(t_on(uses_.front(), station.t, use, station.point));
  }
  std::sort(own.begin(), own.end());
  int before = -1;
  for (const double t : own) {
    before = use.space->add_row_node(row_node_at(use, t), before);
    use.nodes.push_back({before, t});
  }
}

std::vector<int> ContourRows::extend_rows(std::size_t index) {
  Use& use = uses_[index];
  std::vector<int> added;
  if (use.side) return added;
  std::vector<ContourNode> nodes;
  for (ContourNode& node : use.nodes) {
    if (!nodes.empty() && is_long(use, nodes.back(), node)) {
      const double t = 0.5 * (nodes.back().t + node.t);
      added.push_back(
          use.space->insert_row_node(row_node_at(use, t), nodes.back().node, node.node));
      nodes.push_back({added.back(), t});
    }
    nodes.push_back(std::move(node));
  }
  use.nodes = std::move(nodes);
  return added;
}

/// True if two nodes of a row are far apart, in the smaller of their sizes along it.
bool ContourRows::is_long(const Use& use, const ContourNode& a, const ContourNode& b) {
  const LatticeSpace& space = *use.space;
  const double length =
      (space.surface_point(b.node).point - space.surface_point(a.node).point).norm();
  const double size = std::min(to_contour(space.size(a.node), a.frame).h11,
                               to_contour(space.size(b.node), b.frame).h11);
  return length > kLongestLaterStep * size && b.t - a.t > kLeastStep;
}

}  // namespace surfmesh::detail
