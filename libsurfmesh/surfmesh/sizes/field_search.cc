// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/field_search.hh"

#include <algorithm>
#include <utility>

#include "surfmesh/sizes/field_size.hh"

namespace surfmesh {
namespace {

/// Share of the domain below which, in both directions, parts are not searched completely.
constexpr double kSmallestShare = 0.001;

/// Halvings of such a part: to 1/32 in both directions, where its bounds are those of points.
constexpr int kFollowedHalvings = 10;

/// Such parts that are followed in one search. Best first, the others have higher bounds.
constexpr int kFollowedParts = 32;

}  // namespace

FieldSearch::FieldSearch(const SizeField& field, std::size_t budget)
    : field_(field), domain_(field.surface().domain()), budget_(budget) {}

bool FieldSearch::is_beyond(Uv uv) const { return !(domain_.fold(uv) == uv); }

/// The middle, or where that is beyond the diagonal, the corner before it.
Uv FieldSearch::inner_point(const UvBox& box) const {
  const Uv middle = {box.u.middle(), box.v.middle()};
  return is_beyond(middle) ? Uv{box.u.lower, box.v.lower} : middle;
}

bool FieldSearch::is_small(const UvBox& box) const {
  return box.u.width() < kSmallestShare * (domain_.u1 - domain_.u0) &&
         box.v.width() < kSmallestShare * (domain_.v1 - domain_.v0);
}

std::array<UvBox, 2> FieldSearch::halves(const UvBox& box) const {
  const bool is_along_u = box.u.width() * (domain_.v1 - domain_.v0) >=  //
                          box.v.width() * (domain_.u1 - domain_.u0);
  const Uv middle = {box.u.middle(), box.v.middle()};
  if (is_along_u) return {{{{box.u.lower, middle.u}, box.v}, {{middle.u, box.u.upper}, box.v}}};
  return {{{box.u, {box.v.lower, middle.v}}, {box.u, {middle.v, box.v.upper}}}};
}

FieldSearch::Part FieldSearch::bounded(const FieldSource& field, const UvBox& box) {
  ++evaluations_;
  return {box, least_length_in(field, field_.surface(), box)};
}

/// Halves of a box that reach into the domain and may hold lengths below `size`.
std::vector<FieldSearch::Part> FieldSearch::parts_below(const FieldSource& field, const UvBox& box,
                                                        double size) {
  std::vector<Part> parts;
  for (const UvBox& half : halves(box)) {
    if (is_beyond({half.u.lower, half.v.lower})) continue;
    const Part part = bounded(field, half);
    if (part.bound < size) parts.push_back(part);
  }
  return parts;
}

/// Look for the lowest point of a small part along the lower bounds.
std::optional<Uv> FieldSearch::follow(const FieldSource& field, Part part, double size) {
  for (int i = 0; i < kFollowedHalvings; ++i) {
    const std::vector<Part> parts = parts_below(field, part.box, size);
    if (parts.empty()) return std::nullopt;
    part = *std::ranges::min_element(parts, {}, &Part::bound);
    const Uv uv = inner_point(part.box);
    if (least_length(field, field_.surface(), uv) < size) return uv;
  }
  return std::nullopt;
}

std::optional<Uv> FieldSearch::search(const FieldSource& field, const UvBox& box, double size) {
  const Part whole = bounded(field, box);
  if (whole.bound >= size) return std::nullopt;
  int followed = 0;
  for (std::vector<Part> heap = {whole}; !heap.empty() && !is_exhausted();) {
    std::ranges::pop_heap(heap, std::ranges::greater{}, &Part::bound);  // lowest first
    const Part part = heap.back();
    heap.pop_back();
    const Uv uv = inner_point(part.box);
    if (least_length(field, field_.surface(), uv) < size) return uv;
    if (is_small(part.box)) {
      if (++followed > kFollowedParts) continue;
      if (const auto found = follow(field, part, size)) return found;
      continue;
    }
    for (const Part& half : parts_below(field, part.box, size)) {
      heap.push_back(half);
      std::ranges::push_heap(heap, std::ranges::greater{}, &Part::bound);
    }
  }
  return std::nullopt;
}

std::optional<Uv> FieldSearch::find_smaller(const UvBox& box, double size) {
  const bool is_possible = size > field_.bounds().hmin && !is_beyond({box.u.lower, box.v.lower});
  if (!is_possible) return std::nullopt;
  for (const FieldSource& field : field_.fields()) {
    if (!field.has_bounds() || is_exhausted()) continue;
    if (const auto found = search(field, box, size)) return found;
  }
  return std::nullopt;
}

}  // namespace surfmesh
