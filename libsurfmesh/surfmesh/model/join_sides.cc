// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/join_sides.hh"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/model/check_breaks.hh"
#include "surfmesh/model/contour_smoothness.hh"
#include "surfmesh/model/matched_sides.hh"
#include "surfmesh/model/merge_small.hh"
#include "surfmesh/model/near_miss_notices.hh"
#include "surfmesh/model/pin_ends.hh"
#include "surfmesh/model/touching_loops.hh"
#include "surfmesh/model/trim_patches.hh"

namespace surfmesh {
namespace {

/// Breaks nearer to an end than this t are it.
constexpr double kBesideSideEnd = 1e-9;

/// The t at which a side goes from one cell of its surface to the next.
std::vector<double> cell_breaks(const SideLine& line) {
  const CellCount cells = line.surface->cells();
  const bool is_along_u = line.a.v == line.b.v;
  std::vector<double> breaks;
  for (int i = 1; i < (is_along_u ? cells.u : cells.v); ++i) {
    const auto cell = static_cast<double>(i);
    const Uv border = line.surface->from_cells({cell, cell});
    const double t = is_along_u ? (border.u - line.a.u) / (line.b.u - line.a.u)
                                : (border.v - line.a.v) / (line.b.v - line.a.v);
    if (t > kBesideSideEnd && t < 1 - kBesideSideEnd) breaks.push_back(t);
  }
  std::sort(breaks.begin(), breaks.end());
  return breaks;
}

Contour make_contour(const MatchedSides& parts, const MatchedCurve& curve) {
  Contour result;
  result.name = parts.name_of(curve);
  result.start = parts.front_of(curve).start;
  result.end = parts.front_of(curve).end;
  result.is_degenerate = parts.is_degenerate(curve);
  for (const MatchedPiece& matched : curve.pieces) {
    const SideLine& whole = parts.piece(matched).line;
    const SideLine line = matched.is_reversed ? whole.reversed() : whole;
    result.uses.push_back({line.patch, std::make_shared<SegmentCurve>(line.a, line.b),
                           parts.side_of(matched).is_forward != matched.is_reversed,
                           matched.is_same_speed});
    std::vector<double> breaks = cell_breaks(line);
    const bool has_more = breaks.size() > result.breaks.size();
    if (matched.is_same_speed && has_more) result.breaks = std::move(breaks);
  }
  return result;
}

/// The contour use that each piece has become.
std::vector<LoopEntry> entries_of(const MatchedSides& parts) {
  std::vector<LoopEntry> result(parts.split.pieces.size());
  for (std::size_t c = 0; c < parts.curves.size(); ++c) {
    const std::vector<MatchedPiece>& pieces = parts.curves[c].pieces;
    for (std::size_t u = 0; u < pieces.size(); ++u) {
      result[static_cast<std::size_t>(pieces[u].piece)] = {static_cast<int>(c),
                                                           static_cast<int>(u)};
    }
  }
  return result;
}

/// The contour uses of every side in the direction of its growing parameter, by the side's name.
SideChains chains_of(const MatchedSides& parts) {
  std::vector<bool> is_reversed(parts.split.pieces.size());
  for (const MatchedCurve& curve : parts.curves) {
    for (const MatchedPiece& matched : curve.pieces) {
      is_reversed[static_cast<std::size_t>(matched.piece)] = matched.is_reversed;
    }
  }
  const std::vector<LoopEntry> entries = entries_of(parts);
  SideChains chains;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto side = static_cast<std::size_t>(parts.split.pieces[i].side);
    chains[parts.sides[side].name].push_back({entries[i], !is_reversed[i]});
  }
  return chains;
}

/// The outer loop of a whole patch: v0 and u1 along the growing parameter, v1 and u0 against it.
PatchLoop whole_loop(const std::string& patch, const SideChains& chains) {
  PatchLoop loop;
  for (std::size_t k = 0; k < 4; ++k) {
    Chain chain = chains.at(patch + ":" + kSideNames[k]);
    if (k >= 2) std::reverse(chain.begin(), chain.end());
    for (const ChainLink& link : chain) loop.push_back(link.entry);
  }
  return loop;
}

/// The sides that are part of the boundary: all of a patch without loops, else those that its loops
/// name.
std::vector<PatchSide> bounding_sides(const std::vector<PatchInput>& patches) {
  std::vector<PatchSide> result;
  for (PatchSide& side : sides_of(patches)) {
    const auto& loops = patches[static_cast<std::size_t>(side.curve.line.patch)].loops;
    const bool is_named = std::any_of(loops.begin(), loops.end(), [&](const auto& loop) {
      return std::any_of(loop.begin(), loop.end(), [&](const std::string& name) {
        return contour_name_of(name) == side.name;
      });
    });
    if (loops.empty() || is_named) result.push_back(std::move(side));
  }
  return result;
}

[[noreturn]] void refuse_side(std::string_view side_name) {
  throw Error(ErrorCode::InvalidInput, fmt::format("there is no side {}", side_name));
}

struct SideAddress {
  int patch = -1;
  bool is_along_u = false;
  double constant = kUnset;  ///< value of the other parameter
};

SideAddress find_side(const Model& model, std::string_view side_name) {
  const std::size_t colon = side_name.rfind(':');
  if (colon == std::string_view::npos) refuse_side(side_name);
  const std::string_view patch_name = side_name.substr(0, colon);
  const std::string_view side = side_name.substr(colon + 1);
  const auto patch = std::find_if(model.patches.begin(), model.patches.end(),
                                  [&](const Patch& p) { return p.name == patch_name; });
  if (patch == model.patches.end()) refuse_side(side_name);
  const Domain d = patch->surface->domain();
  const int index = static_cast<int>(patch - model.patches.begin());
  if (side == "u0") return {index, false, d.u0};
  if (side == "u1") return {index, false, d.u1};
  if (side == "v0") return {index, true, d.v0};
  if (side == "v1") return {index, true, d.v1};
  refuse_side(side_name);
}

}  // namespace

Model model_from_patches(const std::vector<PatchInput>& patches,
                         const std::vector<ContourInput>& contours,
                         const JoinOptions& options) try {
  check_option(ranges::kJoining, options.joining);
  check_patches(patches);
  Model model;
  model.box = measure_patches(patches);
  model.diagonal = model.box.diagonal().norm();
  const JoinLengths lengths = join_lengths(model.box, options.joining);
  model.joining = lengths.join;
  if (!(options.joining == JoinOptions().joining)) {
    model.made_with.push_back({std::string(ranges::kJoining.name), to_text(options.joining)});
  }
  const MatchedSides parts = match_sides(bounding_sides(patches), lengths);
  model.vertices.reserve(parts.split.vertices.size());
  for (const Vec3& position : parts.split.vertices) model.vertices.push_back({position});
  for (const MatchedCurve& curve : parts.curves) {
    model.contours.push_back(make_contour(parts, curve));
  }
  model.notices = near_miss_notices(parts, lengths);
  const SideChains chains = chains_of(parts);
  for (const PatchInput& patch : patches) {
    Patch& result = model.patches.emplace_back();
    result.name = patch.name;
    result.surface = patch.surface;
    result.origin = patch.origin;
    if (patch.loops.empty()) result.loops.push_back(whole_loop(patch.name, chains));
  }
  trim_patches(model, {patches, contours, chains, lengths.join});
  merge_short_contours(model, std::min(lengths.join, kJoiningShare * model.diagonal));
  pin_ends(model);
  separate_touching_loops(model);
  check_breaks(patches, model);
  set_smoothness(model);
  return model;
} catch (const std::bad_alloc&) {
  fail_without_memory("while joining patches");
}

std::vector<LoopEntry> side_uses(const Model& model, std::string_view side_name) {
  const SideAddress side = find_side(model, side_name);
  const auto fixed = [&](Uv uv) { return side.is_along_u ? uv.v : uv.u; };
  const auto moving = [&](Uv uv) { return side.is_along_u ? uv.u : uv.v; };
  std::vector<std::pair<double, LoopEntry>> found;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const std::vector<ContourUse>& uses = model.contours[c].uses;
    for (std::size_t u = 0; u < uses.size(); ++u) {
      if (uses[u].patch != side.patch) continue;
      const Uv start = uses[u].curve->evaluate(0);
      const Uv end = uses[u].curve->evaluate(1);
      if (fixed(start) != side.constant || fixed(end) != side.constant) continue;
      const double middle = (moving(start) + moving(end)) / 2;
      found.push_back({middle, {static_cast<int>(c), static_cast<int>(u)}});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<LoopEntry> result;
  for (const auto& [middle, entry] : found) result.push_back(entry);
  return result;
}

}  // namespace surfmesh
