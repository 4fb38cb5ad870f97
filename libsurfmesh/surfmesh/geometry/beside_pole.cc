// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/beside_pole.hh"

#include "surfmesh/geometry/first_form.hh"

namespace surfmesh {
namespace {

constexpr double kStepFromPole = 1e-3;

}  // namespace

Uv beside_pole(const Surface& surface, Uv uv) {
  const Domain domain = surface.domain();
  // Towards the middle first, which is inside; then across, for lines through the middle.
  for (const Uv target : {domain.at(0.5, 0.5), domain.at(0.25, 0.4), domain.at(0.6, 0.25)}) {
    const Uv place = lerp(uv, target, kStepFromPole);
    const Jet jet = surface.evaluate(place, Order::First);
    if (is_regular(first_form_factor(jet.du, jet.dv))) return place;
  }
  return uv;
}

}  // namespace surfmesh
