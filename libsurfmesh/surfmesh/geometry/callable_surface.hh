// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "surfmesh/geometry/jet_number.hh"
#include "surfmesh/geometry/jet_of_numbers.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/geometry/surface_checks.hh"

namespace surfmesh {

/// A surface given by a C++ callable f(u,v) that is generic in its number type, with exact
/// derivatives.
///
/// The callable takes two JetNumbers of order 0, 1 or 2 and returns a position, an Eigen vector or
/// std::array of three of them:
///
///   [](auto u, auto v) { return std::array{u, v, 1.5 * sin(2 * u) * cos(v / 5)}; }
///
/// Write `sin`, not `std::sin`: functions are found by the types of their arguments. The callable
/// must be safe to call from several threads.
template <class Function>
class CallableSurface : public Surface {
 public:
  /// Throws   InvalidInput for an empty or infinite domain
  CallableSurface(const Domain& domain, Function function)
      : domain_(domain), function_(std::move(function)) {
    check(domain);
  }

  Jet evaluate(Uv uv, Order order) const override {
    const Jet jet = order == Order::Position ? evaluate_to<0>(uv)
                    : order == Order::First  ? evaluate_to<1>(uv)
                                             : evaluate_to<2>(uv);
    check_finite(jet, uv, order);
    return jet;
  }

  Domain domain() const override { return domain_; }

 private:
  template <int order>
  Jet evaluate_to(Uv uv) const {
    using Number = JetNumber<order>;
    const auto position = function_(Number::parameter(uv.u, 0), Number::parameter(uv.v, 1));
    return jet_of<order>(position[0], position[1], position[2]);
  }

  Domain domain_;
  Function function_;
};

/// Make a surface from a generic callable.
/// Throws   InvalidInput for an empty or infinite domain
template <class Function>
std::shared_ptr<const Surface> make_callable_surface(const Domain& domain, Function function) {
  return std::make_shared<const CallableSurface<Function>>(domain, std::move(function));
}

}  // namespace surfmesh
