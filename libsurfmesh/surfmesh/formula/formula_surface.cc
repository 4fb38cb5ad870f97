// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_surface.hh"

#include <array>
#include <vector>

#include "surfmesh/formula/coordinates.hh"
#include "surfmesh/geometry/jet_of_numbers.hh"
#include "surfmesh/geometry/surface_checks.hh"

namespace surfmesh {
namespace {

const std::vector<std::string> kSurfaceParameters = {"u", "v"};

FormulaProgram read(const SurfaceFormulas& formulas,
                    const std::map<std::string, double>& constants) {
  return read_coordinates({{"x", formulas.x}, {"y", formulas.y}, {"z", formulas.z}},
                          kSurfaceParameters, constants, formulas.where);
}

}  // namespace

FormulaSurface::FormulaSurface(const SurfaceFormulas& formulas, const Domain& domain,
                               const std::map<std::string, double>& constants)
    : domain_(domain), program_(read(formulas, constants)) {
  check(domain);
}

template <int order>
Jet FormulaSurface::evaluate_to(Uv uv) const {
  using Number = JetNumber<order>;
  const std::array variables = {Number::parameter(uv.u, 0), Number::parameter(uv.v, 1)};
  std::array<Number, 3> position;
  program_.evaluate<order>(variables, position);
  return jet_of(position[0], position[1], position[2]);
}

Jet FormulaSurface::evaluate(Uv uv, Order order) const {
  const Jet jet = order == Order::Position ? evaluate_to<0>(uv)
                  : order == Order::First  ? evaluate_to<1>(uv)
                                           : evaluate_to<2>(uv);
  check_finite(jet, uv, order);
  return jet;
}

}  // namespace surfmesh
