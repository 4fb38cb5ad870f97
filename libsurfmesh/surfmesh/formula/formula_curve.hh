// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "surfmesh/formula/formula.hh"
#include "surfmesh/geometry/curve.hh"

namespace surfmesh {

/// The parameters of a curve on a patch as formulas of t.
struct CurveFormulas {
  std::string u;
  std::string v;
  std::vector<NamedFormula> where = {};  ///< formulas that these may use
};

/// A curve in the parameters of a patch given by formulas of t, which runs through a range.
class FormulaCurve : public Curve {
 public:
  /// Throws   InvalidInput for an empty or infinite range, or a formula that cannot be read
  ///          (parse_formula), naming the coordinate
  FormulaCurve(const CurveFormulas& formulas, const CurveRange& range,
               const std::map<std::string, double>& constants = {});

  /// Throws   Geometry if the result is not finite, naming t in its range
  Uv evaluate(double t) const override;

  /// The coordinates as a program of t in the range of the curve.
  const FormulaProgram& program() const { return program_; }

  const CurveRange& range() const { return range_; }

 private:
  CurveRange range_;
  FormulaProgram program_;
};

/// The coordinates of a curve in space as formulas of t.
struct SpaceCurveFormulas {
  std::string x;
  std::string y;
  std::string z;
  std::vector<NamedFormula> where = {};
};

/// A curve in space given by formulas of t, which runs through a range.
class FormulaSpaceCurve : public SpaceCurve {
 public:
  /// Throws   as FormulaCurve
  FormulaSpaceCurve(const SpaceCurveFormulas& formulas, const CurveRange& range,
                    const std::map<std::string, double>& constants = {});

  /// Throws   as FormulaCurve
  Vec3 evaluate(double t) const override;

  /// The coordinates as a program of t in the range of the curve.
  const FormulaProgram& program() const { return program_; }

  const CurveRange& range() const { return range_; }

 private:
  CurveRange range_;
  FormulaProgram program_;
};

}  // namespace surfmesh
