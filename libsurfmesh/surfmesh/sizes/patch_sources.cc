// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/patch_sources.hh"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/sizes/place_sources.hh"
#include "surfmesh/sizes/source_place.hh"

namespace surfmesh {
namespace {

/// Give each source to its patch, with the place where it is given.
template <class Source>
void give(const std::vector<Source>& all, std::string_view list,
          std::vector<Source> PatchSources::*member, std::vector<PatchSources>& patches) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto& own = patches.at(static_cast<std::size_t>(all[i].patch)).*member;
    own.push_back(all[i]);
    own.back().origin = place_of(all[i], list, i);
  }
}

/// Run `body` with each source of a list. Its errors say which it was.
template <class Source, class Body>
void for_each_source(const std::vector<Source>& all, std::string_view list, Body body) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    try {
      body(all[i]);
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("{}: {}", place_of(all[i], list, i), error.what()));
    }
  }
}

class ClampCounter {
 public:
  explicit ClampCounter(const SizeBounds& bounds) : bounds_(bounds) {}

  void add(const Size& size) { count_ += bounds_.changes(size) ? 1 : 0; }
  void add(const std::optional<Outer>& outer) {
    if (outer) add(outer->size);
  }
  void add(const LocalSize& wish) {
    add(wish.size);
    add(wish.outer);
  }

  std::size_t count() const { return count_; }

 private:
  const SizeBounds& bounds_;
  std::size_t count_ = 0;
};

/// Without gradation, a size near a place reaches as far as its radius.
void check_radius(const NearSource& source, const PlacedSize& placed) {
  if (reach(placed) > 0) return;
  const Vec3& p = source.line.front();
  throw Error(ErrorCode::InvalidInput,
              fmt::format("the source near ({}, {}, {}) needs a radius, as grade is off", p.x(),
                          p.y(), p.z()));
}

/// Sizes near places and in boxes, by the patches where they apply; none of these for all.
using SizesInSpace = std::map<std::vector<int>, std::vector<PlacedSize>>;

SizesInSpace sizes_in_space(const Sources& sources, const ResolvedSizing& sizing) {
  SizesInSpace sizes;
  for_each_source(sources.near, "near", [&](const NearSource& source) {
    std::vector<PlacedSize>& own = sizes[source.patches];
    add_near(source, sizing.bounds, own);
    if (sizing.grade == 0) check_radius(source, own.back());
  });
  for_each_source(sources.boxes, "boxes", [&](const BoxSource& source) {
    add_box(source, sizing.bounds, sizes[source.patches]);
  });
  return sizes;
}

void give_trees(SizesInSpace all, double grade, std::vector<PatchSources>& patches) {
  for (auto& [where, sizes] : all) {
    const auto tree = std::make_shared<const SourceTree>(std::move(sizes), grade);
    for (const int p : where) patches.at(static_cast<std::size_t>(p)).trees.push_back(tree);
    if (!where.empty()) continue;
    for (PatchSources& patch : patches) patch.trees.push_back(tree);
  }
}

/// Sources of whole patches, of those of the same size the first, with their places.
std::vector<EverywhereSource> different_sizes(const std::vector<EverywhereSource>& sources) {
  std::set<std::tuple<double, bool, double, bool, double>> known;
  std::vector<EverywhereSource> different;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto& [along, across, angle] = sources[i].size;
    const bool is_new =
        known.insert({along.value, along.is_relative, across.value, across.is_relative, angle})
            .second;
    if (!is_new) continue;
    different.push_back(sources[i]);
    different.back().origin = place_of(sources[i], "everywhere", i);
  }
  return different;
}

}  // namespace

std::optional<double> PatchSources::precision() const {
  std::optional<double> least;
  const auto add = [&](const auto& source) {
    if (source.precision) least = std::min(least.value_or(*source.precision), *source.precision);
  };
  std::for_each(fields.begin(), fields.end(), add);
  std::for_each(tables.begin(), tables.end(), add);
  return least;
}

std::vector<PatchSources> sources_by_patch(const Sources& sources, const ResolvedSizing& sizing,
                                           std::size_t patches) {
  std::vector<PatchSources> result(patches);
  give(sources.everywhere, "everywhere", &PatchSources::everywhere, result);
  give(sources.at, "at", &PatchSources::at, result);
  give(sources.along, "along", &PatchSources::along, result);
  give(sources.inside, "inside", &PatchSources::inside, result);
  give(sources.fields, "fields", &PatchSources::fields, result);
  give(sources.tables, "tables", &PatchSources::tables, result);
  give_trees(sizes_in_space(sources, sizing), sizing.grade, result);
  return result;
}

std::size_t count_clamped(const Sources& sources, const SizeBounds& bounds) {
  ClampCounter counter(bounds);
  for_each_source(different_sizes(sources.everywhere), "everywhere",
                  [&](const EverywhereSource& source) { counter.add(source.size); });
  for_each_source(sources.at, "at", [&](const AtSource& source) {
    counter.add(source.size);
    counter.add(source.outer);
  });
  const auto add_wish = [&](const auto& source) { counter.add(source.wish); };
  for_each_source(sources.along, "along", add_wish);
  for_each_source(sources.inside, "inside", add_wish);
  for_each_source(sources.near, "near", add_wish);
  for_each_source(sources.boxes, "boxes", add_wish);
  return counter.count();
}

}  // namespace surfmesh
