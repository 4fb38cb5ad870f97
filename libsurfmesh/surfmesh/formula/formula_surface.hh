// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "surfmesh/formula/formula.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// The coordinates of a surface as formulas of u and v; a graph if x and y are left out.
struct SurfaceFormulas {
  std::string x = "u";
  std::string y = "v";
  std::string z = "0";
  std::vector<NamedFormula> where = {};  ///< they may use these, which are computed once a point
};

/// A surface given by formulas, with exact derivatives.
class FormulaSurface : public Surface {
 public:
  /// Throws   InvalidInput for an empty or infinite domain, or a formula that cannot be read
  ///          (parse_formula), naming the coordinate
  FormulaSurface(const SurfaceFormulas& formulas, const Domain& domain,
                 const std::map<std::string, double>& constants = {});

  Jet evaluate(Uv uv, Order order) const override;

  Domain domain() const override { return domain_; }

  /// The coordinates as a program of u and v.
  const FormulaProgram& program() const { return program_; }

 private:
  template <int order>
  Jet evaluate_to(Uv uv) const;

  Domain domain_;
  FormulaProgram program_;
};

}  // namespace surfmesh
