// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/check_breaks.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/formula/critical_value.hh"
#include "surfmesh/formula/find_breaks.hh"
#include "surfmesh/formula/formula_curve.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/model/loop_region.hh"
#include "surfmesh/model/patch_loops.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {
namespace {

/// A jump this near to a side, as a share of the domain, is between the side and what is beside it.
constexpr double kAtSide = 1e-9;

/// A parameter of less than this share of the domain is 0: breaks are found to 2^-44 of it.
constexpr double kZero = 0x1p-40;

/// A jump of less than this share of the diagonal is no cliff between elements of any usual size,
/// and may come from rounded coefficients.
constexpr double kSmallJump = 1e-4;

/// An operation as formulas name it.
std::string_view name_of(Operation operation) {
  switch (operation) {
    case Operation::Less:
    case Operation::LessEqual:
      return "a comparison or step";
    case Operation::Floor:
      return "floor";
    case Operation::Ceil:
      return "ceil";
    case Operation::Mod:
      return "mod";
    case Operation::Sign:
      return "sign";
    case Operation::Atan2:
      return "atan2";
    case Operation::Select:
      return "if";
    case Operation::Divide:
    case Operation::DivideConstant:
      return "a quotient";
    case Operation::Log:
    case Operation::Log10:
      return "a logarithm";
    case Operation::Tan:
      return "tan";
    default:
      return "a power";
  }
}

/// ", all along u = 0.37".
std::string line_text(const FormulaBreak& found) {
  if (found.line == BreakLine::ConstantU) return fmt::format(", along u = {:.6g}", found.at.u);
  if (found.line == BreakLine::ConstantV) return fmt::format(", along v = {:.6g}", found.at.v);
  return {};
}

/// The side of a domain on which a break is; empty if it is on none.
std::string_view side_of(const FormulaBreak& found, const Domain& domain) {
  const auto is_at = [](double x, double end, double span) {
    return std::abs(x - end) < kAtSide * span;
  };
  const double width = domain.u1 - domain.u0, height = domain.v1 - domain.v0;
  if (found.line == BreakLine::ConstantU) {
    if (is_at(found.at.u, domain.u0, width)) return "u0";
    if (is_at(found.at.u, domain.u1, width)) return "u1";
  }
  if (found.line == BreakLine::ConstantV) {
    if (is_at(found.at.v, domain.v0, height)) return "v0";
    if (is_at(found.at.v, domain.v1, height)) return "v1";
  }
  return {};
}

std::string jump_advice(const FormulaBreak& found, const Domain& domain) {
  const std::string_view side = side_of(found, domain);
  if (!side.empty()) {
    return fmt::format("side {} needs the formula of the points beside it", side);
  }
  switch (found.line) {
    case BreakLine::ConstantU:
      return fmt::format("divide the patch at u = {:.6g}, each part with the formula of its side",
                         found.at.u);
    case BreakLine::ConstantV:
      return fmt::format("divide the patch at v = {:.6g}, each part with the formula of its side",
                         found.at.v);
    default:
      return "divide the patch there by a contour, each part with the formula of its side";
  }
}

/// A parameter that is 0 but for the rounding of the search, as it is told.
double told(double x, double span) { return std::abs(x) < kZero * span ? 0 : x; }

FormulaBreak told(FormulaBreak found, const Domain& domain) {
  found.at.u = told(found.at.u, domain.u1 - domain.u0);
  found.at.v = told(found.at.v, domain.v1 - domain.v0);
  return found;
}

Notice notice_of(const FormulaBreak& found, const PatchInput& patch, double diagonal) {
  const bool is_small = found.height < kSmallJump * diagonal;
  Notice notice = {.kind = NoticeKind::SurfaceJump,
                   .severity = is_small ? Severity::Warning : Severity::Shortfall,
                   .text = fmt::format("its surface jumps by {}{:.3g} at (u,v) = ({:.6g}, "
                                       "{:.6g}){}, as {} does{}: {}",
                                       found.is_greatest ? "up to " : "", found.height, found.at.u,
                                       found.at.v, line_text(found), name_of(found.operation),
                                       is_small ? "" : ", and the mesh has a cliff there",
                                       jump_advice(found, patch.surface->domain()))};
  locate(label(patch), notice);
  notice.point = patch.surface->evaluate(found.beside, Order::Position).point;
  return notice;
}

std::string infinity_advice(const FormulaBreak& found) {
  if (found.line == BreakLine::Other) return "let the domain keep away from it";
  return "let the domain end before it, and a second patch begin behind it";
}

[[noreturn]] void throw_infinite(const FormulaBreak& found, const PatchInput& patch) {
  throw Error(
      ErrorCode::Geometry,
      fmt::format("{}: its surface runs to infinity at (u,v) = ({:.6g}, {:.6g}){}, as {} does: {}",
                  label(patch), found.at.u, found.at.v, line_text(found), name_of(found.operation),
                  infinity_advice(found)));
}

/// The part of a patch's domain inside its loops.
class Material {
 public:
  Material(const Model& model, int patch)
      : curves_(loop_curves(model, model.patch(patch))), regions_(curves_) {}
  Material(const Material&) = delete;
  Material& operator=(const Material&) = delete;

  bool contains(Uv point) const { return regions_.is_in_material(point); }

  /// The part of a domain that the outer loop covers.
  UvBox box(const Domain& domain) const {
    const BoxTree::Box& box = regions_.box(0);
    const Uv low = domain.clamp({box.min().x(), box.min().y()});
    const Uv high = domain.clamp({box.max().x(), box.max().y()});
    return {{low.u, high.u}, {low.v, high.v}};
  }

 private:
  std::vector<LoopCurves> curves_;
  LoopRegions regions_;  ///< of the curves
};

std::vector<FormulaBreak> breaks_of(const FormulaSurface& surface, const Model& model, int patch,
                                    bool is_trimmed) {
  const Domain domain = surface.domain();
  BreakSearch search{.box = {{domain.u0, domain.u1}, {domain.v0, domain.v1}},
                     .size = model.diagonal};
  if (!is_trimmed) return find_breaks(surface.program(), search);
  const Material material(model, patch);
  search.box = material.box(domain);
  search.is_inside = [&](Uv uv) { return material.contains(uv); };
  return find_breaks(surface.program(), search);
}

/// Share of a curve's range that its end may lie aside of a jump: contours that end so near to each
/// other meet.
constexpr double kBesideEnd = 1e-9;

/// The diagonal of the box of a curve's samples.
double size_of(const FormulaProgram& program, const CurveRange& range) {
  Eigen::AlignedBox3d box;
  for (const double s : sample_parameters(kLineSamples)) {
    std::array<JetNumber<0>, 3> results = {0.0, 0.0, 0.0};
    program.evaluate<0>(std::array{JetNumber<0>(range.at(s))},
                        std::span(results).first(program.result_count()));
    box.extend(Vec3(results[0].value(), results[1].value(), results[2].value()));
  }
  return box.diagonal().norm();
}

template <class FormulaCurveOrSpaceCurve>
void check_curve(const FormulaCurveOrSpaceCurve* curve) {
  if (!curve || !may_break(curve->program())) return;
  const CurveRange& range = curve->range();
  const std::vector<FormulaBreak> found = find_breaks(
      curve->program(),
      {.box = {{range.from, range.to}, {0, 0}}, .size = size_of(curve->program(), range)});
  if (found.empty()) return;
  const FormulaBreak& first = found.front();
  const std::string what = first.is_infinite ? std::string("runs to infinity")
                                             : fmt::format("jumps by {:.3g}", first.height);
  const double aside = kBesideEnd * (range.to - range.from);
  const bool is_at_start = std::abs(first.at.u - range.from) < aside;
  const bool is_at_end = is_at_start || std::abs(first.at.u - range.to) < aside;
  const double inside = is_at_start ? range.from + aside : range.to - aside;
  const std::string advice =
      first.is_infinite ? "let its range keep away from there"
      : is_at_end
          ? fmt::format(
                "let its range stop short of there, at {:.11g}: the end itself has another value",
                inside)
          : "divide it there, each part with a formula of its own";
  throw Error(ErrorCode::Geometry, fmt::format("the curve {} at t = {:.6g}, as {} does: {}", what,
                                               told(first.at.u, range.to - range.from),
                                               name_of(first.operation), advice));
}

}  // namespace

void check_breaks(const std::vector<PatchInput>& patches, Model& model) {
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const PatchInput& patch = patches[p];
    const auto* surface = dynamic_cast<const FormulaSurface*>(patch.surface.get());
    if (!surface || !may_break(surface->program())) continue;
    const int index = static_cast<int>(p);
    const auto breaks = breaks_of(*surface, model, index, !patch.loops.empty());
    for (const FormulaBreak& each : breaks) {
      const FormulaBreak found = told(each, surface->domain());
      if (found.is_infinite) throw_infinite(found, patch);
      model.notices.push_back(notice_of(found, patch, model.diagonal));
      model.notices.back().patch = index;
    }
    if (!breaks.empty() && breaks.back().may_be_more) {
      model.notices.back().text += "; there may be more, which the search left out";
    }
  }
}

void check_breaks(const ContourInput& contour) {
  check_curve(dynamic_cast<const FormulaSpaceCurve*>(contour.xyz.get()));
  for (const ContourInput::On& on : contour.on) {
    check_curve(dynamic_cast<const FormulaCurve*>(on.curve.get()));
  }
}

}  // namespace surfmesh
