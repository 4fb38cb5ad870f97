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

namespace surfmesh {
namespace {

/// Give each source to its patch.
template <class Source>
void give(const std::vector<Source>& all, std::vector<Source> PatchSources::*member,
          std::vector<PatchSources>& patches) {
  for (const Source& source : all) {
    (patches.at(static_cast<std::size_t>(source.patch)).*member).push_back(source);
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
  for (const NearSource& source : sources.near) {
    std::vector<PlacedSize>& own = sizes[source.patches];
    add_near(source, sizing.bounds, own);
    if (sizing.grade == 0) check_radius(source, own.back());
  }
  for (const BoxSource& source : sources.boxes) {
    add_box(source, sizing.bounds, sizes[source.patches]);
  }
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

/// The sizes of whole patches, each once.
std::vector<Size> different_sizes(const std::vector<EverywhereSource>& sources) {
  std::set<std::tuple<double, bool, double, bool, double>> known;
  std::vector<Size> sizes;
  for (const EverywhereSource& source : sources) {
    const auto& [along, across, angle] = source.size;
    const bool is_new =
        known.insert({along.value, along.is_relative, across.value, across.is_relative, angle})
            .second;
    if (is_new) sizes.push_back(source.size);
  }
  return sizes;
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
  give(sources.everywhere, &PatchSources::everywhere, result);
  give(sources.at, &PatchSources::at, result);
  give(sources.along, &PatchSources::along, result);
  give(sources.inside, &PatchSources::inside, result);
  give(sources.fields, &PatchSources::fields, result);
  give(sources.tables, &PatchSources::tables, result);
  give_trees(sizes_in_space(sources, sizing), sizing.grade, result);
  return result;
}

std::size_t count_clamped(const Sources& sources, const SizeBounds& bounds) {
  ClampCounter counter(bounds);
  for (const Size& size : different_sizes(sources.everywhere)) counter.add(size);
  for (const AtSource& source : sources.at) {
    counter.add(source.size);
    counter.add(source.outer);
  }
  for (const AlongSource& source : sources.along) counter.add(source.wish);
  for (const InsideSource& source : sources.inside) counter.add(source.wish);
  for (const NearSource& source : sources.near) counter.add(source.wish);
  for (const BoxSource& source : sources.boxes) counter.add(source.wish);
  return counter.count();
}

}  // namespace surfmesh
