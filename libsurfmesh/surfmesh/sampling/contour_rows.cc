// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/contour_rows.hh"

#include <algorithm>
#include <array>
#include <cmath>
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

/// Step of t for the direction of a contour: its error is of second order in the step.
constexpr double kTangentStep = 1e-4;

/// Share of the width of a domain by which points of a side lie beside it by rounding.
constexpr double kOnSide = 1e-12;

/// Where a use is looked at to tell if it runs along a side.
constexpr std::array<double, 3> kShares = {0.2817, 0.5, 0.6473};

/// Greatest distance between nodes of a row, in units of the smaller sizes.
constexpr double kLongestStep = 1;
constexpr int kFirstSteps = 4;
/// 4 × 2^12 nodes: more than sizes differ along one contour.
constexpr int kMaxHalvings = 12;

bool is_at(double x, double line, double width) { return std::abs(x - line) <= kOnSide * width; }

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

/// The side along which a use runs at even speed.
std::optional<DomainSide> ContourRows::find_side(const Use& use) const {
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
    if (uses_[use].side) update_side(use);
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
  const auto frame = frame_at(use, t, at.form);
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
  const auto frame = frame_at(to, result.t, result.at.form);
  result.is_seen = true;
  result.is_isotropic = !frame;
  result.frame = frame.value_or(ContourFrame());
  return result;
}

/// The direction of a use in the tangent frame; nothing where there is none.
std::optional<ContourFrame> ContourRows::frame_at(const Use& use, double t,
                                                  const FirstFormFactor& form) const {
  if (!is_regular(form)) return std::nullopt;
  const Curve& curve = *use.use->curve;
  const Uv step = curve.evaluate(std::min(1.0, t + kTangentStep)) -
                  curve.evaluate(std::max(0.0, t - kTangentStep));
  const double x = form.l11 * step.u + form.l21 * step.v, y = form.l22 * step.v;
  const double length = std::hypot(x, y);
  if (!(length > 0)) return std::nullopt;
  return ContourFrame{x / length, y / length};
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
  std::vector<double> stations;
  for (int i = 0; i < kFirstSteps; ++i) {
    add_stations(double(i) / kFirstSteps, double(i + 1) / kFirstSteps, kMaxHalvings, stations);
  }
  stations.push_back(1);
  for (Use& use : uses_) {
    if (!use.side) make_row(use, stations);
  }
  // Only now, for what a row sees of others may be a row.
  for (std::size_t use = 0; use < uses_.size(); ++use) {
    for (ContourNode& node : uses_[use].nodes) node = seen(use, node.node, node.t);
  }
}

/// Add the lower end of an interval of t and points within it, so that they are near each other.
void ContourRows::add_stations(double from, double to, int halvings,
                               std::vector<double>& stations) const {
  if (halvings > 0 && units_between(from, to) > kLongestStep) {
    const double middle = 0.5 * (from + to);
    add_stations(from, middle, halvings - 1, stations);
    add_stations(middle, to, halvings - 1, stations);
    return;
  }
  stations.push_back(from);
}

/// Length of an interval of the first use in the smallest sizes of all uses at its ends.
double ContourRows::units_between(double from, double to) const {
  const Use& first = uses_.front();
  const auto point_of = [this](const Use& use, double t) { return model_.point(*use.use, t); };
  const std::array points = {point_of(first, from), point_of(first, to)};
  const double length = (points[1] - points[0]).norm();
  double units = 0;
  for (const Use& use : uses_) {
    for (std::size_t end = 0; end < points.size(); ++end) {
      const double t = t_on(first, end == 0 ? from : to, use, points[end]);
      const Domain domain = use.surface->domain();
      int near = -1;
      const SizeTensor size =
          use.space->lattice_size(domain.fold(domain.clamp(use.use->curve->evaluate(t))), near);
      const Jet jet =
          use.surface->evaluate(domain.clamp(use.use->curve->evaluate(t)), Order::First);
      const auto frame = frame_at(use, t, first_form_factor(jet.du, jet.dv));
      if (frame) units = std::max(units, length / to_contour(size, *frame).h11);
    }
  }
  return units;
}

/// Stations are parameters of the first use.
void ContourRows::make_row(Use& use, const std::vector<double>& stations) {
  const Domain domain = use.surface->domain();
  int before = -1, near = -1;
  for (const double station : stations) {
    const double t = t_on(uses_.front(), station, use, model_.point(*uses_.front().use, station));
    const Uv uv = domain.fold(domain.clamp(use.use->curve->evaluate(t)));
    const Jet jet = use.surface->evaluate(uv, Order::First);
    const FirstFormFactor form = first_form_factor(jet.du, jet.dv);
    before =
        use.space->add_row_node({uv, jet.point, form, use.space->lattice_size(uv, near)}, before);
    use.nodes.push_back({before, t});
  }
  std::sort(use.nodes.begin(), use.nodes.end(),
            [](const ContourNode& a, const ContourNode& b) { return a.t < b.t; });
}

}  // namespace surfmesh::detail
