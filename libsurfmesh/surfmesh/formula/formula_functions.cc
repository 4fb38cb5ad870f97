// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_functions.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "surfmesh/formula/formula.hh"

namespace surfmesh {
namespace {

constexpr std::array kFunctions = {FormulaFunction{"abs", Operation::Abs},
                                   FormulaFunction{"sign", Operation::Sign},
                                   FormulaFunction{"floor", Operation::Floor},
                                   FormulaFunction{"ceil", Operation::Ceil},
                                   FormulaFunction{"sqrt", Operation::Sqrt},
                                   FormulaFunction{"cbrt", Operation::Cbrt},
                                   FormulaFunction{"exp", Operation::Exp},
                                   FormulaFunction{"log", Operation::Log},
                                   FormulaFunction{"ln", Operation::Log},
                                   FormulaFunction{"log10", Operation::Log10},
                                   FormulaFunction{"sin", Operation::Sin},
                                   FormulaFunction{"cos", Operation::Cos},
                                   FormulaFunction{"tan", Operation::Tan},
                                   FormulaFunction{"asin", Operation::Asin},
                                   FormulaFunction{"acos", Operation::Acos},
                                   FormulaFunction{"atan", Operation::Atan},
                                   FormulaFunction{"sinh", Operation::Sinh},
                                   FormulaFunction{"cosh", Operation::Cosh},
                                   FormulaFunction{"tanh", Operation::Tanh},
                                   FormulaFunction{"atan2", Operation::Atan2, "y,x"},
                                   FormulaFunction{"hypot", Operation::Hypot, "x,y"},
                                   FormulaFunction{"pow", Operation::Power, "x,y"},
                                   FormulaFunction{"min", Operation::Min, "x,y"},
                                   FormulaFunction{"max", Operation::Max, "x,y"},
                                   FormulaFunction{"mod", Operation::Mod, "x,y"},
                                   FormulaFunction{"step", Operation::LessEqual, "edge,x"},
                                   FormulaFunction{"if", Operation::Select, "condition,a,b"}};

}  // namespace

std::size_t FormulaFunction::argument_count() const {
  return 1 + static_cast<std::size_t>(std::ranges::count(arguments, ','));
}

std::span<const FormulaFunction> all_formula_functions() { return kFunctions; }

const FormulaFunction* find_formula_function(std::string_view name) {
  const auto it = std::ranges::find(kFunctions, name, &FormulaFunction::name);
  return it == kFunctions.end() ? nullptr : &*it;
}

std::string formula_functions() {
  std::string list;
  for (const FormulaFunction& function : kFunctions) {
    if (!list.empty()) list += ' ';
    list += function.name;
    if (function.argument_count() > 1) list += fmt::format("({})", function.arguments);
  }
  return list;
}

}  // namespace surfmesh
