// SPDX-License-Identifier: BSD-3-Clause
#include "bench/patch_grid.hh"

#include <algorithm>
#include <cmath>

namespace surfmesh::judge {
namespace {

/// Samples in each direction of the lengths of a patch.
constexpr int kSamples = 9;

/// Greatest ratio of the steps of the two directions.
constexpr double kMostSlender = 16;

constexpr int kLeastStepsInCell = 2;

/// The mean length of the parameter lines along v, per length of those along u.
double aspect(const Surface& surface) {
  const Domain domain = surface.domain();
  double along_u = 0, along_v = 0;
  for (int j = 0; j < kSamples; ++j) {
    for (int i = 0; i < kSamples; ++i) {
      const Uv uv = domain.fold(domain.at((i + 0.5) / kSamples, (j + 0.5) / kSamples));
      const Jet jet = surface.evaluate(uv, Order::First);
      along_u += jet.du.norm() * (domain.u1 - domain.u0);
      along_v += jet.dv.norm() * (domain.v1 - domain.v0);
    }
  }
  return along_u > 0 && along_v > 0 ? along_v / along_u : 1;
}

int steps_of(double count, int cells) {
  return cells * std::max(kLeastStepsInCell, static_cast<int>(std::lround(count / cells)));
}

}  // namespace

Uv PatchGrid::in_steps(Uv uv) const {
  return {(uv.u - domain.u0) / (domain.u1 - domain.u0) * u_steps,
          (uv.v - domain.v0) / (domain.v1 - domain.v0) * v_steps};
}

PatchGrid::Corners PatchGrid::corners_at(Uv uv) const {
  const Uv at = in_steps(uv);
  const int i = std::clamp(static_cast<int>(at.u), 0, u_steps - 1);
  const int j = std::clamp(static_cast<int>(at.v), 0, v_steps - 1);
  const double s = std::clamp(at.u - i, 0.0, 1.0), t = std::clamp(at.v - j, 0.0, 1.0);
  return {{node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)},
          {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t}};
}

PatchGrid make_grid(const Surface& surface, double nodes) {
  const double ratio = std::clamp(aspect(surface), 1 / kMostSlender, kMostSlender);
  const CellCount cells = surface.cells();
  const double u_count = std::sqrt(nodes / ratio);
  return {surface.domain(), steps_of(u_count, cells.u), steps_of(u_count * ratio, cells.v)};
}

}  // namespace surfmesh::judge
