// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/ring_sizes.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace surfmesh {
namespace {

constexpr int kChordsPerCell = 8;
constexpr int kLinesPerCell = 4;

/// Least size around a ring as a share of hmin: rings that are pinched to a point have no end of
/// elements otherwise.
constexpr double kLeastShare = 1.0 / 16;

/// A seam between two opposite sides, without its lengths; none if the uses are no such sides or
/// do not lie across from each other.
std::optional<Ring> seam_of(const Domain& domain, const ContourUse& a, const ContourUse& b) {
  const Uv a0 = a.curve->evaluate(0), a1 = a.curve->evaluate(1);
  const Uv b0 = b.curve->evaluate(0), b1 = b.curve->evaluate(1);
  const auto is_across = [](double x0, double x1, double y0, double y1, double low, double high) {
    return x0 == x1 && y0 == y1 && std::min(x0, y0) == low && std::max(x0, y0) == high;
  };
  if (is_across(a0.u, a1.u, b0.u, b1.u, domain.u0, domain.u1) && a0.v == b0.v && a1.v == b1.v) {
    return Ring{true, std::min(a0.v, a1.v), std::max(a0.v, a1.v), {}};
  }
  if (is_across(a0.v, a1.v, b0.v, b1.v, domain.v0, domain.v1) && a0.u == b0.u && a1.u == b1.u) {
    return Ring{false, std::min(a0.u, a1.u), std::max(a0.u, a1.u), {}};
  }
  return std::nullopt;
}

/// Length of the line of constant v, or of constant u, across the domain.
double line_length(const Surface& surface, bool is_along_u, double constant) {
  const Domain domain = surface.domain();
  const int chords = kChordsPerCell * (is_along_u ? surface.cells().u : surface.cells().v);
  const auto point = [&](int i) {
    const Uv on = domain.at(double(i) / chords, double(i) / chords);
    const Uv uv = is_along_u ? Uv{on.u, constant} : Uv{constant, on.v};
    return surface.evaluate(uv, Order::Position).point;
  };
  double length = 0;
  Vec3 last = point(0);
  for (int i = 1; i <= chords; ++i) {
    const Vec3 next = point(i);
    length += (next - last).norm();
    last = next;
  }
  return length;
}

void measure(const Surface& surface, Ring& ring) {
  const int lines = kLinesPerCell * static_cast<int>(std::ceil(ring.to - ring.from));
  for (int i = 0; i <= lines; ++i) {
    const double share = double(i) / lines;
    ring.lengths.push_back(
        line_length(surface, ring.is_along_u, (1 - share) * ring.from + share * ring.to));
  }
}

}  // namespace

double Ring::length_at(Uv uv) const {
  const double across = is_along_u ? uv.v : uv.u;
  if (across < from || across > to) return std::numeric_limits<double>::infinity();
  const double steps = static_cast<double>(lengths.size() - 1);
  const double at = (across - from) / (to - from) * steps;
  const auto i = static_cast<std::size_t>(std::min(at, steps - 1));
  const double share = at - static_cast<double>(i);
  return (1 - share) * lengths[i] + share * lengths[i + 1];
}

std::vector<Ring> short_rings(const Model& model, int patch, const SizeBounds& bounds) {
  const Patch& own = model.patch(patch);
  const CellCount cells = own.surface->cells();
  std::vector<Ring> rings;
  if (cells.u * cells.v == 1) return rings;
  for (const LoopEntry& entry : own.loops.front()) {
    const auto& uses = model.contour(entry).uses;
    // Each seam is met twice.
    if (uses.size() != 2 || uses[0].patch != uses[1].patch || entry.use != 0) continue;
    std::optional<Ring> ring = seam_of(own.surface->domain(), uses[0], uses[1]);
    if (!ring) continue;
    measure(*own.surface, *ring);
    const double least = *std::min_element(ring->lengths.begin(), ring->lengths.end());
    if (least < kUnitsAround * bounds.hmax) rings.push_back(std::move(*ring));
  }
  return rings;
}

double size_around(double ring_length, const SizeBounds& bounds) {
  return std::clamp(ring_length / kUnitsAround, kLeastShare * bounds.hmin, bounds.hmax);
}

}  // namespace surfmesh
