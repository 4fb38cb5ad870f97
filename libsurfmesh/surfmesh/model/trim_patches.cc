// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/trim_patches.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/project_curve.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/model/loop_checks.hh"
#include "surfmesh/model/open_contours.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {
namespace {

/// A contour is nearer than this to its patches and to the next one in a loop, in shares of the
/// diagonal.
constexpr double kContourGap = 1e-6;

/// Contours that meet in space but differ by this share of the domain in (u,v) do not meet there.
constexpr double kLoopJump = 1e-3;

std::string label(const ContourInput& contour) {
  return fmt::format("{}{}contour {}", contour.origin, contour.origin.empty() ? "" : ": ",
                     contour.name);
}

/// Fail if a sample of a contour's curves is not finite.
void check_finite(const ContourInput& contour) {
  for (const double t : sample_parameters(kLineSamples)) {
    bool is_finite = !contour.xyz || contour.xyz->evaluate(t).allFinite();
    for (const ContourInput::On& on : contour.on) {
      if (!on.curve) continue;
      const Uv uv = on.curve->evaluate(t);
      is_finite = is_finite && std::isfinite(uv.u) && std::isfinite(uv.v);
    }
    if (is_finite) continue;
    throw Error(ErrorCode::Geometry,
                fmt::format("the curve at t = {} is not finite", contour.range.at(t)));
  }
}

/// One contour use of a loop, in the direction of the loop.
struct Step {
  LoopEntry entry;
  bool is_along = true;
};

using Steps = std::vector<Step>;

/// What is known of a contour that is in the model.
struct Origin {
  std::shared_ptr<const SpaceCurve> xyz;
  CurveRange range;
};

class Trimmer {
 public:
  Trimmer(Model& model, const TrimInput& input)
      : model_(model), input_(input), reach_(kContourGap * model.diagonal) {
    for (const ContourInput& contour : input.contours) check_names(contour);
    origins_.resize(model.contours.size());
  }

  void run() {
    std::vector<std::vector<Steps>> loops(input_.patches.size());
    for (std::size_t p = 0; p < loops.size(); ++p) {
      for (std::size_t l = 0; l < input_.patches[p].loops.size(); ++l) {
        loops[p].push_back(resolve(static_cast<int>(p), l));
      }
    }
    for (std::size_t p = 0; p < loops.size(); ++p) {
      if (!loops[p].empty()) finish(static_cast<int>(p), loops[p]);
    }
    unite_vertices();
    warn_of_unused();
    warn_of_neighbours();
  }

 private:
  Contour& contour(int index) { return model_.contour(index); }
  const ContourUse& use(const LoopEntry& entry) {
    return contour(entry.contour).uses[static_cast<std::size_t>(entry.use)];
  }
  const PatchInput& patch(int index) const {
    return input_.patches[static_cast<std::size_t>(index)];
  }

  // Names.
  void check_names(const ContourInput& contour);
  std::string loop_label(int patch, std::size_t loop) const;
  [[noreturn]] void fail_loop(ErrorCode code, int patch, std::size_t loop,
                              const std::string& reason) const;
  Steps resolve(int patch, std::size_t loop);
  Steps side_steps(const std::string& name, const std::vector<ChainLink>& chain, int patch);
  Step contour_step(const ContourInput& input, int patch);

  // Contours and their uses.
  int contour_index(const ContourInput& input);
  std::shared_ptr<const SpaceCurve> curve_in_space(const ContourInput& input) const;
  int vertex_at(const Vec3& point);
  int add_use(int contour_index, int patch, std::shared_ptr<const Curve> curve,
              const std::string& place);
  std::shared_ptr<const Curve> project(int contour_index, int patch, const std::string& place);
  void check_same_place(const Contour& contour, const ContourUse& use, const std::string& place,
                        bool& is_same_speed);

  // Loops.
  LoopCurves curves_of(const Steps& steps);
  void close(int patch, std::size_t loop, const Steps& steps);
  void finish(int patch, std::vector<Steps>& loops);
  void check_extent(int patch, std::size_t loop, const Steps& steps);
  void warn_of_near_parts(int patch, const std::vector<LoopCurves>& curves);
  void check_holes(int patch, const std::vector<LoopCurves>& curves,
                   const std::vector<std::size_t>& order) const;
  void unite_vertices();
  void warn_of_unused();
  void warn_of_neighbours();

  Vec3 point(const ContourUse& use, double t) const {
    const Surface& surface = model_.surface(use);
    return surface.evaluate(use.curve->evaluate(t), Order::Position).point;
  }

  Model& model_;
  const TrimInput& input_;
  double reach_;
  std::map<std::string, const ContourInput*, std::less<>> by_name_;
  std::map<const ContourInput*, int> indices_;  ///< of contours that are in the model
  std::map<std::pair<const ContourInput*, int>, std::size_t> mentions_;  ///< by patch
  std::set<std::pair<int, int>> used_;  ///< contour and use in some loop
  std::vector<Origin> origins_;         ///< by contour of the model
  std::vector<std::pair<int, int>> equal_vertices_;
};

void Trimmer::check_names(const ContourInput& contour) {
  const auto refuse = [&](const std::string& reason) {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: {}", label(contour), reason));
  };
  const bool is_plain = !contour.name.empty() && contour.name[0] != '-' &&
                        contour.name.find(':') == std::string::npos;
  if (!is_plain) refuse("a name does not begin with - and has no colon");
  if (!by_name_.try_emplace(contour.name, &contour).second) refuse("its name is used twice");
  bool has_curve = contour.xyz != nullptr;
  for (const ContourInput::On& on : contour.on) {
    has_curve = has_curve || on.curve;
    const auto known = [&](const PatchInput& other) { return other.name == on.patch; };
    if (std::none_of(input_.patches.begin(), input_.patches.end(), known)) {
      refuse(fmt::format("there is no patch {}", on.patch));
    }
  }
  if (!has_curve) refuse("it needs a curve in space, or one on a patch");
  try {
    check_finite(contour);
  } catch (const Error& error) {
    throw Error(error.code(), fmt::format("{}: {}", label(contour), error.what()));
  }
}

std::string Trimmer::loop_label(int index, std::size_t loop) const {
  const PatchInput& input = patch(index);
  if (input.origin.empty()) return fmt::format("patch {}: loop {}", input.name, loop);
  return fmt::format("{}/loops/{}: patch {}", input.origin, loop, input.name);
}

void Trimmer::fail_loop(ErrorCode code, int patch, std::size_t loop,
                        const std::string& reason) const {
  throw Error(code, fmt::format("{}: {}", loop_label(patch, loop), reason));
}

/// The steps that a loop's list of names stands for; adds contours and uses to the model.
Steps Trimmer::resolve(int index, std::size_t loop) {
  Steps steps;
  const std::vector<std::string>& names = patch(index).loops[loop];
  if (names.empty()) fail_loop(ErrorCode::InvalidInput, index, loop, "the loop is empty");
  for (const std::string& mention : names) {
    const std::string name(contour_name_of(mention));
    const bool is_against = name.size() != mention.size();
    Steps part;
    const auto chain = input_.chains.find(name);
    const auto named = by_name_.find(name);
    if (chain != input_.chains.end()) {
      part = side_steps(name, chain->second, index);
    } else if (named != by_name_.end()) {
      part = {contour_step(*named->second, index)};
    } else {
      fail_loop(ErrorCode::InvalidInput, index, loop,
                fmt::format("there is no contour or side {}", name));
    }
    if (is_against) {
      std::reverse(part.begin(), part.end());
      for (Step& step : part) step.is_along = !step.is_along;
    }
    for (const Step& step : part) {
      if (used_.insert({step.entry.contour, step.entry.use}).second) continue;
      fail_loop(ErrorCode::InvalidInput, index, loop, fmt::format("{} is there twice", name));
    }
    steps.insert(steps.end(), part.begin(), part.end());
  }
  return steps;
}

/// The contours of a side: of the patch itself, or of another one on which it is projected.
Steps Trimmer::side_steps(const std::string& name, const std::vector<ChainLink>& chain, int index) {
  Steps steps;
  for (const ChainLink& link : chain) {
    const ContourUse& own = use(link.entry);
    if (own.patch == index) {
      steps.push_back({link.entry, link.is_along});
      continue;
    }
    const int c = link.entry.contour;
    const std::string place = fmt::format("{}: side {}", label(patch(index)), name);
    const std::vector<ContourUse>& uses = contour(c).uses;
    if (std::any_of(uses.begin(), uses.end(), [&](const auto& u) { return u.patch == index; })) {
      throw Error(ErrorCode::InvalidInput, fmt::format("{} is there twice", place));
    }
    if (!origins_[static_cast<std::size_t>(c)].xyz) {
      const Patch& owner = model_.patch(own.patch);
      origins_[static_cast<std::size_t>(c)].xyz =
          std::make_shared<CurveOnSurface>(owner.surface, own.curve);
    }
    const int added = add_use(c, index, project(c, index, place), place);
    steps.push_back({{c, added}, link.is_along});
  }
  return steps;
}

Step Trimmer::contour_step(const ContourInput& input, int index) {
  const std::string place = fmt::format("{} on patch {}", label(input), patch(index).name);
  const std::size_t mention = mentions_[{&input, index}]++;
  std::vector<const ContourInput::On*> on;
  for (const ContourInput::On& entry : input.on) {
    if (entry.patch == patch(index).name) on.push_back(&entry);
  }
  if (mention >= std::max<std::size_t>(1, on.size())) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: the loops name it more often than it is given there", place));
  }
  const int c = contour_index(input);
  const bool is_given = !on.empty() && on[mention]->curve;
  const int added =
      add_use(c, index, is_given ? on[mention]->curve : project(c, index, place), place);
  return {{c, added}, true};
}

/// The curve in space, or that of the first curve on a patch.
std::shared_ptr<const SpaceCurve> Trimmer::curve_in_space(const ContourInput& input) const {
  if (input.xyz) return input.xyz;
  const auto on = std::find_if(input.on.begin(), input.on.end(),
                               [](const ContourInput::On& entry) { return entry.curve; });
  const auto owner = std::find_if(input_.patches.begin(), input_.patches.end(),
                                  [&](const PatchInput& p) { return p.name == on->patch; });
  return std::make_shared<CurveOnSurface>(owner->surface, on->curve);
}

/// The contour of the model, made when it is first needed.
int Trimmer::contour_index(const ContourInput& input) {
  const auto [entry, is_new] =
      indices_.try_emplace(&input, static_cast<int>(model_.contours.size()));
  if (!is_new) return entry->second;
  const std::shared_ptr<const SpaceCurve> xyz = curve_in_space(input);
  Contour result;
  result.name = input.name;
  result.start = vertex_at(xyz->evaluate(0));
  result.end = vertex_at(xyz->evaluate(1));
  const Vec3 first = xyz->evaluate(0);
  const std::vector<double> parameters = sample_parameters(kLineSamples);
  result.is_degenerate = std::all_of(parameters.begin(), parameters.end(), [&](double t) {
    return (xyz->evaluate(t) - first).norm() <= input_.join;
  });
  model_.contours.push_back(std::move(result));
  origins_.push_back({xyz, input.range});
  return entry->second;
}

/// The vertex at a point, a new one if there is none.
int Trimmer::vertex_at(const Vec3& point) {
  for (std::size_t i = 0; i < model_.vertices.size(); ++i) {
    if ((model_.vertices[i].position - point).norm() <= input_.join) return static_cast<int>(i);
  }
  model_.vertices.push_back({point});
  return static_cast<int>(model_.vertices.size()) - 1;
}

std::shared_ptr<const Curve> Trimmer::project(int contour_index, int index,
                                              const std::string& place) {
  const Origin& origin = origins_[static_cast<std::size_t>(contour_index)];
  try {
    return project_curve(patch(index).surface, origin.xyz, reach_, origin.range);
  } catch (const Error& error) {
    throw Error(error.code(), fmt::format("{}: {}", place, error.what()));
  }
}

int Trimmer::add_use(int contour_index, int index, std::shared_ptr<const Curve> curve,
                     const std::string& place) {
  Contour& target = contour(contour_index);
  ContourUse added{index, std::move(curve), true, true};
  check_same_place(target, added, place, added.is_same_speed);
  target.uses.push_back(std::move(added));
  return static_cast<int>(target.uses.size()) - 1;
}

/// Fail if a use is elsewhere than the contour in space; tell if it has the speed of the first use.
void Trimmer::check_same_place(const Contour& contour, const ContourUse& use,
                               const std::string& place, bool& is_same_speed) {
  const Origin& origin = origins_[static_cast<std::size_t>(&contour - model_.contours.data())];
  const ContourUse& first = contour.uses.empty() ? use : contour.uses.front();
  double greatest = 0, where = 0;
  for (const double t : sample_parameters(kLineSamples)) {
    const Vec3 here = point(use, t);
    double gap = (origin.xyz->evaluate(t) - here).norm();
    if (!contour.uses.empty()) {
      const double step = (point(first, t) - here).norm();
      if (!(step < reach_)) is_same_speed = false;
      const Surface& surface = model_.surface(first.patch);
      // Ends have to meet at the same t, so that the direction is the same.
      const double foot = t == 0 || t == 1 ? t : project_to_curve(surface, *first.curve, here, t);
      gap = std::min(gap, (point(first, foot) - here).norm());
    }
    if (gap > greatest) std::tie(greatest, where) = std::pair(gap, t);
  }
  if (greatest < reach_) return;
  throw Error(ErrorCode::Geometry,
              fmt::format("{}: at t = {:.6g} it is {:.3g} away from where it is elsewhere, which "
                          "must be below {:.3g}",
                          place, origin.range.at(where), greatest, reach_));
}

LoopCurves Trimmer::curves_of(const Steps& steps) {
  LoopCurves result;
  for (const Step& step : steps) {
    const Contour& owner = contour(step.entry.contour);
    result.push_back({owner.name, use(step.entry).curve, step.is_along,
                      origins_[static_cast<std::size_t>(step.entry.contour)].range});
  }
  return result;
}

/// Check that contours meet end to end, and note that their ends are the same vertices.
void Trimmer::close(int index, std::size_t loop, const Steps& steps) {
  const Domain domain = patch(index).surface->domain();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& from = steps[i];
    const Step& to = steps[(i + 1) % steps.size()];
    const Contour& a = contour(from.entry.contour);
    const Contour& b = contour(to.entry.contour);
    const double end = from.is_along ? 1 : 0, start = to.is_along ? 0 : 1;
    const double gap = (point(use(from.entry), end) - point(use(to.entry), start)).norm();
    if (!(gap < reach_)) {
      fail_loop(ErrorCode::Geometry, index, loop,
                fmt::format("the loop does not close, the gap between the end of {} and the start "
                            "of {} is {:.3g}",
                            a.name, b.name, gap));
    }
    const Uv p = use(from.entry).curve->evaluate(end), q = use(to.entry).curve->evaluate(start);
    if (std::abs(p.u - q.u) > kLoopJump * (domain.u1 - domain.u0) ||
        std::abs(p.v - q.v) > kLoopJump * (domain.v1 - domain.v0)) {
      fail_loop(ErrorCode::Geometry, index, loop,
                fmt::format("between {} and {} the loop closes in space, but leaps from (u,v) = "
                            "({:.6g}, {:.6g}) to ({:.6g}, {:.6g}): a seam or pole is missing",
                            a.name, b.name, p.u, p.v, q.u, q.v));
    }
    equal_vertices_.emplace_back(from.is_along ? a.end : a.start, to.is_along ? b.start : b.end);
  }
}

/// Check the loops of a patch, bring them in order and add them.
void Trimmer::finish(int index, std::vector<Steps>& loops) {
  std::vector<LoopCurves> curves;
  std::vector<double> areas;
  const Domain domain = patch(index).surface->domain();
  for (std::size_t l = 0; l < loops.size(); ++l) {
    curves.push_back(curves_of(loops[l]));
    if (const auto place = place_outside(curves[l], domain)) {
      fail_loop(ErrorCode::Geometry, index, l, "the loop leaves the domain: " + *place);
    }
    close(index, l, loops[l]);
    check_extent(index, l, loops[l]);
    areas.push_back(signed_area(curves[l]));
  }
  if (const auto place = crossing(curves)) {
    throw Error(ErrorCode::Geometry,
                fmt::format("{}: loops cross: {}", label(patch(index)), *place));
  }
  warn_of_near_parts(index, curves);
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto outer = std::max_element(areas.begin(), areas.end(),
                                      [](double a, double b) { return std::abs(a) < std::abs(b); });
  std::swap(order[0], order[static_cast<std::size_t>(outer - areas.begin())]);
  check_holes(index, curves, order);
  for (const std::size_t l : order) {
    const bool is_turned = (areas[l] > 0) != (l == order[0]);
    if (is_turned) {
      model_.warnings.push_back(
          fmt::format("{}: the loop runs the wrong way round; it is turned", loop_label(index, l)));
      std::reverse(loops[l].begin(), loops[l].end());
    }
    PatchLoop& loop = model_.patch(index).loops.emplace_back();
    for (const Step& step : loops[l]) {
      contour(step.entry.contour).uses[static_cast<std::size_t>(step.entry.use)].is_forward =
          step.is_along != is_turned;
      loop.push_back(step.entry);
    }
  }
}

/// A hole that is a point has no nodes; on a pole the loop has other contours, too.
void Trimmer::check_extent(int index, std::size_t loop, const Steps& steps) {
  const bool is_point = std::all_of(steps.begin(), steps.end(), [&](const Step& step) {
    return contour(step.entry.contour).is_degenerate;
  });
  if (is_point) fail_loop(ErrorCode::Geometry, index, loop, "the loop is a single point in space");
}

/// Elements between parts of the boundary that nearly meet are as flat as the gap is narrow.
void Trimmer::warn_of_near_parts(int index, const std::vector<LoopCurves>& curves) {
  const Surface& surface = *patch(index).surface;
  const auto point_at = [&](Uv uv) { return surface.evaluate(uv, Order::Position).point; };
  for (const NearParts& near : near_parts(curves, kNearShare)) {
    model_.warnings.push_back(
        fmt::format("{}: contours {} and {} nearly meet at (u,v) = ({:.6g}, {:.6g}): the gap "
                    "between them is {:.3g}",
                    label(patch(index)), near.a, near.b, near.at_a.u, near.at_a.v,
                    (point_at(near.at_a) - point_at(near.at_b)).norm()));
  }
}

/// Check that all loops but the first in order are holes of it, not of each other.
void Trimmer::check_holes(int index, const std::vector<LoopCurves>& curves,
                          const std::vector<std::size_t>& order) const {
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t hole = order[i];
    const Uv p = curves[hole].front().at(0.5);
    const auto fail = [&](const char* reason) {
      fail_loop(ErrorCode::Geometry, index, hole,
                fmt::format("the loop lies {} at (u,v) = ({:.6g}, {:.6g})", reason, p.u, p.v));
    };
    if (!is_inside(curves[order[0]], p)) fail("outside of the outer loop");
    for (std::size_t j = 1; j < order.size(); ++j) {
      if (j != i && is_inside(curves[order[j]], p)) fail("inside of a hole");
    }
  }
}

/// Make one vertex of those that loops have found to be the same, and drop what is not used.
void Trimmer::unite_vertices() {
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

void Trimmer::warn_of_unused() {
  for (const ContourInput& input : input_.contours) {
    if (!indices_.contains(&input)) {
      model_.warnings.push_back(fmt::format("{}: no loop names it, it is left out", label(input)));
      continue;
    }
    for (const ContourInput::On& on : input.on) {
      const auto owner = std::find_if(input_.patches.begin(), input_.patches.end(),
                                      [&](const PatchInput& p) { return p.name == on.patch; });
      const int index = static_cast<int>(owner - input_.patches.begin());
      if (mentions_.contains({&input, index})) continue;
      model_.warnings.push_back(
          fmt::format("{}: no loop of patch {} names it", label(input), on.patch));
    }
  }
}

/// Named contours are not compared with others, so tell where that was perhaps meant.
void Trimmer::warn_of_neighbours() {
  const std::vector<OpenContour> all = open_contours(model_);
  std::vector<OpenContour> named, sides;
  for (const OpenContour& open : all) {
    (by_name_.contains(open.contour->name) ? named : sides).push_back(open);
  }
  std::vector<ContourPair> pairs = contours_along(named, sides, kNearShare * model_.diagonal);
  for (std::size_t i = 0; i < named.size(); ++i) {
    const std::vector<OpenContour> rest(named.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                        named.end());
    const auto more = contours_along({named[i]}, rest, kNearShare * model_.diagonal);
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
  for (const ContourPair& pair : pairs) {
    model_.warnings.push_back(
        fmt::format("contours {} and {} run along each other, at most {:.3g} apart, but are not "
                    "joined: give them one name",
                    pair.a, pair.b, pair.gap));
  }
}

}  // namespace

std::string_view contour_name_of(std::string_view mention) {
  return mention.starts_with('-') ? mention.substr(1) : mention;
}

void trim_patches(Model& model, const TrimInput& input) { Trimmer(model, input).run(); }

}  // namespace surfmesh
