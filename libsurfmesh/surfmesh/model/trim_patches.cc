// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/trim_patches.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/model/check_breaks.hh"
#include "surfmesh/model/close_loops.hh"
#include "surfmesh/model/divide_contours.hh"
#include "surfmesh/model/free_seam.hh"
#include "surfmesh/model/named_contours.hh"
#include "surfmesh/model/open_contours.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {
namespace {

/// A contour is nearer than this to its patches and to the next one in a loop, in shares of the
/// diagonal.
constexpr double kContourGap = 1e-6;

/// Greatest length of a contour in diagonals of its box: what is longer is a wave that no sample of
/// the contour resolves, such as sin(1e9*t). Speeds are measured over this step of t, which is in
/// step with no wave.
constexpr double kMostLength = 1e4, kSpeedStep = 0.6180339887e-8;

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

/// True if a curve is far longer than its box: by the median of its speeds, at least half of which
/// is below its length.
template <class PointAt>
bool is_too_long(PointAt point_at) {
  Box3 box;
  std::vector<double> speeds;
  for (const double t : sample_parameters(kLineSamples)) {
    const double near = t < 0.5 ? t + kSpeedStep : t - kSpeedStep;
    const Vec3 point = point_at(t);
    const double step = (point_at(near) - point).norm();
    box.extend(point);
    speeds.push_back((step - rounding_at(point)) / kSpeedStep);
  }
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  return *middle > kMostLength * box.diagonal().norm();
}

/// Fail if a curve is a wave that no sample resolves.
void check_length(const ContourInput& contour) {
  bool is_long =
      contour.xyz && is_too_long([&](double t) -> Vec3 { return contour.xyz->evaluate(t); });
  for (const ContourInput::On& on : contour.on) {
    is_long = is_long || (on.curve && is_too_long([&](double t) -> Vec3 {
                            const Uv uv = on.curve->evaluate(t);
                            return {uv.u, uv.v, 0};
                          }));
  }
  if (!is_long) return;
  throw Error(ErrorCode::Geometry,
              fmt::format("the curve goes to and fro too often to be meshed: it is more than {} "
                          "times as long as its box",
                          kMostLength / 2));
}

/// The parts of each contour between its kinks, by its name.
using NamedParts = std::map<std::string, std::vector<ContourInput>, std::less<>>;

/// Named contours are not compared with others, so tell where that was perhaps meant.
void warn_of_neighbours(Model& model, const NamedParts& parts) {
  std::set<std::string_view> names;
  for (const auto& [name, of_name] : parts) {
    for (const ContourInput& part : of_name) names.insert(part.name);
  }
  const std::vector<OpenContour> all = open_contours(model);
  std::vector<OpenContour> named, sides;
  for (const OpenContour& open : all) {
    (names.contains(open.contour->name) ? named : sides).push_back(open);
  }
  std::vector<ContourPair> pairs = contours_along(named, sides, kNearShare * model.diagonal);
  const auto more = contours_along(named, kNearShare * model.diagonal);
  pairs.insert(pairs.end(), more.begin(), more.end());
  for (const ContourPair& pair : pairs) {
    model.notices.push_back(shortfall(
        NoticeKind::UnjoinedSides,
        fmt::format("contours {} and {} run along each other, at most {:.3g} apart, but are not "
                    "joined: give them one name",
                    pair.a, pair.b, pair.gap)));
    model.notices.back().contour = find_contour(model, pair.a);
  }
}

/// Turns the names that stand in loops into contour uses.
class Trimmer {
 public:
  Trimmer(Model& model, const TrimInput& input)
      : model_(model),
        input_(input),
        patch_numbers_(patch_numbers(input.patches)),
        contours_(model, input.patches, patch_numbers_,
                  {input.join, kContourGap * model.diagonal}) {
    for (const ContourInput& contour : input.contours) add_parts(contour);
  }

  void run() {
    std::vector<std::vector<Chain>> loops(input_.patches.size());
    for (std::size_t p = 0; p < loops.size(); ++p) {
      for (std::size_t l = 0; l < input_.patches[p].loops.size(); ++l) {
        loops[p].push_back(chain_of(static_cast<int>(p), l));
      }
    }
    LoopCloser closer(model_, input_.patches, contours_, kContourGap * model_.diagonal);
    for (std::size_t p = 0; p < loops.size(); ++p) {
      if (!loops[p].empty()) closer.add_loops(static_cast<int>(p), std::move(loops[p]));
    }
    closer.unite_vertices();
    warn_of_unused();
    warn_of_neighbours(model_, parts_);
  }

 private:
  const PatchInput& patch(int index) const {
    return input_.patches[static_cast<std::size_t>(index)];
  }

  void check_names(const ContourInput& contour) const;
  void add_parts(const ContourInput& contour);
  Chain chain_of(int patch, std::size_t loop);
  Chain chain_named(const std::string& name, int patch, std::size_t loop);
  Chain side_chain(const std::string& name, const Chain& side, int patch);
  std::string seam_advice(const ContourInput& contour, int patch) const;
  ChainLink contour_link(const ContourInput& input, int patch);
  void warn_of_unused();

  Model& model_;
  const TrimInput& input_;
  PatchNumbers patch_numbers_;
  NamedContours contours_;
  NamedParts parts_;
  std::map<std::pair<const ContourInput*, int>, std::size_t> mentions_;  ///< by patch
  std::set<std::pair<int, int>> used_;  ///< contour and use in some loop
};

void Trimmer::check_names(const ContourInput& contour) const {
  const auto refuse = [&](const std::string& reason) {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: {}", label(contour), reason));
  };
  const bool is_plain = !contour.name.empty() && contour.name[0] != '-' &&
                        contour.name.find_first_of(":#") == std::string::npos;
  if (!is_plain) refuse("a name does not begin with - and has no : and no #");
  if (parts_.contains(contour.name)) refuse("its name is used twice");
  bool has_curve = contour.xyz != nullptr;
  for (const ContourInput::On& on : contour.on) {
    has_curve = has_curve || on.curve;
    if (!patch_numbers_.contains(on.patch)) {
      refuse(fmt::format("there is no patch {}", on.patch));
    }
  }
  if (!has_curve) refuse("it needs a curve in space, or one on a patch");
}

void Trimmer::add_parts(const ContourInput& contour) {
  check_names(contour);
  try {
    check_finite(contour);
    check_length(contour);
    check_breaks(contour);
    parts_[contour.name] = divide_at_kinks(contour, input_.patches, patch_numbers_);
  } catch (const Error& error) {
    throw Error(error.code(), fmt::format("{}: {}", label(contour), error.what()));
  }
}

/// The contour uses that a loop's list of names stands for; adds contours and uses to the model.
Chain Trimmer::chain_of(int index, std::size_t loop) {
  const PatchInput& input = patch(index);
  const std::vector<std::string>& names = input.loops[loop];
  if (names.empty()) fail_loop(ErrorCode::InvalidInput, input, loop, "the loop is empty");
  Chain chain;
  for (const std::string& mention : names) {
    const std::string name(contour_name_of(mention));
    Chain part = chain_named(name, index, loop);
    const bool is_against = name.size() != mention.size();
    if (is_against) {
      std::reverse(part.begin(), part.end());
      for (ChainLink& link : part) link.is_along = !link.is_along;
    }
    for (const ChainLink& link : part) {
      if (used_.insert({link.entry.contour, link.entry.use}).second) continue;
      fail_loop(ErrorCode::InvalidInput, input, loop, fmt::format("{} is there twice", name));
    }
    chain.insert(chain.end(), part.begin(), part.end());
  }
  return chain;
}

Chain Trimmer::chain_named(const std::string& name, int index, std::size_t loop) {
  const auto side = input_.chains.find(name);
  if (side != input_.chains.end()) return side_chain(name, side->second, index);
  const auto named = parts_.find(name);
  if (named != parts_.end()) {
    Chain chain;
    for (const ContourInput& part : named->second) chain.push_back(contour_link(part, index));
    return chain;
  }
  fail_loop(ErrorCode::InvalidInput, patch(index), loop,
            fmt::format("there is no contour or side {}", name));
}

/// The contours of a side: of the patch itself, or of another one on which it is projected.
Chain Trimmer::side_chain(const std::string& name, const Chain& side, int index) {
  Chain chain;
  for (const ChainLink& link : side) {
    model_.contour(link.entry.contour).is_named = true;
    if (model_.use(link.entry).patch == index) {
      chain.push_back(link);
      continue;
    }
    const int c = link.entry.contour;
    const std::string location = fmt::format("{}: side {}", label(patch(index)), name);
    const std::vector<ContourUse>& uses = model_.contour(c).uses;
    if (std::any_of(uses.begin(), uses.end(), [&](const auto& u) { return u.patch == index; })) {
      throw Error(ErrorCode::InvalidInput, fmt::format("{} is there twice", location));
    }
    contours_.lie_along(link.entry);
    const int added = contours_.add_use(c, index, nullptr, location);
    chain.push_back({{c, added}, link.is_along});
  }
  return chain;
}

ChainLink Trimmer::contour_link(const ContourInput& input, int index) {
  const std::string location = fmt::format("{} on patch {}", label(input), patch(index).name);
  const std::size_t mention = mentions_[{&input, index}]++;
  std::vector<const ContourInput::On*> on;
  for (const ContourInput::On& entry : input.on) {
    if (entry.patch == patch(index).name) on.push_back(&entry);
  }
  if (mention >= std::max<std::size_t>(1, on.size())) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: the loops name it more often than it is given there", location));
  }
  const int c = contours_.contour_of(input);
  const auto curve = on.empty() ? nullptr : on[mention]->curve;
  try {
    return {{c, contours_.add_use(c, index, curve, location)}, true};
  } catch (const Error& error) {
    if (curve) throw;
    throw Error(error.code(), error.what() + seam_advice(input, index));
  }
}

/// How to move the seam of a patch out of the way of its contours, if this one crosses it.
std::string Trimmer::seam_advice(const ContourInput& contour, int index) const {
  const Surface& surface = *patch(index).surface;
  const auto in_space = curve_in_space(contour, input_.patches, patch_numbers_);
  std::vector<UvPath> paths = {path_on(surface, *in_space)};
  if (!lies_on(surface, *in_space, paths.front(), contours_.reach())) return {};
  for (const std::vector<std::string>& loop : patch(index).loops) {
    for (const std::string& mention : loop) {
      const auto named = parts_.find(contour_name_of(mention));
      if (named == parts_.end()) continue;
      for (const ContourInput& part : named->second) {
        // A curve in the parameters would have to move with the domain.
        const bool is_fixed = std::any_of(part.on.begin(), part.on.end(), [&](const auto& on) {
          return on.curve && on.patch == patch(index).name;
        });
        if (is_fixed) return {};
        paths.push_back(path_on(surface, *curve_in_space(part, input_.patches, patch_numbers_)));
      }
    }
  }
  const std::optional<std::string> advice = free_seam_advice(surface, paths, false);
  return advice ? ", or move the seam: " + *advice : std::string();
}

void Trimmer::warn_of_unused() {
  for (const ContourInput& input : input_.contours) {
    const ContourInput& part = parts_.at(input.name).front();
    if (!contours_.has(part)) {
      model_.notices.push_back(
          warning_at(label(input), NoticeKind::UnusedContour, "no loop names it, it is left out"));
      continue;
    }
    for (const ContourInput::On& on : input.on) {
      const int index = patch_numbers_.at(on.patch);
      if (mentions_.contains({&part, index})) continue;
      Notice notice = warning_at(label(input), NoticeKind::UnusedContour,
                                 fmt::format("no loop of patch {} names it", on.patch));
      notice.patch = index;
      model_.notices.push_back(std::move(notice));
    }
  }
}

}  // namespace

std::string_view contour_name_of(std::string_view mention) {
  return mention.starts_with('-') ? mention.substr(1) : mention;
}

void trim_patches(Model& model, const TrimInput& input) { Trimmer(model, input).run(); }

}  // namespace surfmesh
