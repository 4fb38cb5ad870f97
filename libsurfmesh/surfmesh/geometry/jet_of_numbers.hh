// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/geometry/jet_number.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// The jet of a surface from its three coordinates as jet numbers.
template <int order>
Jet jet_of(const JetNumber<order>& x, const JetNumber<order>& y, const JetNumber<order>& z) {
  Jet jet;
  jet.point = {x.value(), y.value(), z.value()};
  if constexpr (order >= 1) {
    jet.du = {x.du(), y.du(), z.du()};
    jet.dv = {x.dv(), y.dv(), z.dv()};
  }
  if constexpr (order >= 2) {
    jet.duu = {x.duu(), y.duu(), z.duu()};
    jet.duv = {x.duv(), y.duv(), z.duv()};
    jet.dvv = {x.dvv(), y.dvv(), z.dvv()};
  }
  return jet;
}

}  // namespace surfmesh
