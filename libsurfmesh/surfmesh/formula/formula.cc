// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <numbers>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

struct Function {
  std::string_view name;
  Operation operation;
  int argument_count;
};

constexpr std::array kFunctions = {
    Function{"sqrt", Operation::Sqrt, 1},   Function{"cbrt", Operation::Cbrt, 1},
    Function{"exp", Operation::Exp, 1},     Function{"log", Operation::Log, 1},
    Function{"sin", Operation::Sin, 1},     Function{"cos", Operation::Cos, 1},
    Function{"tan", Operation::Tan, 1},     Function{"asin", Operation::Asin, 1},
    Function{"acos", Operation::Acos, 1},   Function{"atan", Operation::Atan, 1},
    Function{"atan2", Operation::Atan2, 2}, Function{"sinh", Operation::Sinh, 1},
    Function{"cosh", Operation::Cosh, 1},   Function{"tanh", Operation::Tanh, 1},
    Function{"abs", Operation::Abs, 1},     Function{"min", Operation::Min, 2},
    Function{"max", Operation::Max, 2},     Function{"pow", Operation::Power, 2},
    Function{"hypot", Operation::Hypot, 2}};

/// Names that mean the same in every formula of a model.
constexpr std::array<std::string_view, 5> kReserved = {"pi", "e", "u", "v", "t"};

/// Longer formulas are quoted only in part.
constexpr std::size_t kMaxQuoted = 80;

const Function* find_function(std::string_view name) {
  const auto it = std::ranges::find(kFunctions, name, &Function::name);
  return it == kFunctions.end() ? nullptr : &*it;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_name_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool is_name_part(char c) { return is_name_start(c) || is_digit(c); }

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

bool is_name(std::string_view text) {
  return !text.empty() && is_name_start(text[0]) && std::ranges::all_of(text, is_name_part);
}

using Constants = std::map<std::string, double>;

void check_constants(const Constants& constants, const std::vector<std::string>& variables) {
  for (const auto& [name, value] : constants) {
    const bool is_taken = std::ranges::find(kReserved, name) != kReserved.end() ||
                          std::ranges::find(variables, name) != variables.end() ||
                          find_function(name) != nullptr;
    const char* fault = !is_name(name)          ? "is not a name"
                        : is_taken              ? "would redefine a name of the formulas"
                        : !std::isfinite(value) ? "is not finite"
                                                : nullptr;
    if (fault) {
      throw Error(ErrorCode::InvalidInput, fmt::format("the constant '{}' {}", name, fault));
    }
  }
}

/// Recursive descent straight into the builder:
///   sum     = product { (+|-) product }
///   product = signed { (*|/) signed }
///   signed  = (-|+) signed | power
///   power   = primary [ ^ signed ]
///   primary = number | name | function ( sum {, sum} ) | ( sum )
class Parser {
 public:
  Parser(std::string_view text, const std::vector<std::string>& variables,
         const Constants& constants, FormulaBuilder& builder)
      : text_(text), variables_(variables), constants_(constants), builder_(builder) {}

  int parse() {
    const int result = parse_sum();
    if (!is_at_end()) fail("an operator or the end");
    return result;
  }

 private:
  int parse_sum() {
    int left = parse_product();
    while (true) {
      if (accept('+')) {
        left = builder_.apply(Operation::Add, left, parse_product());
      } else if (accept('-')) {
        left = builder_.apply(Operation::Subtract, left, parse_product());
      } else {
        return left;
      }
    }
  }

  int parse_product() {
    int left = parse_signed();
    while (true) {
      if (accept('*')) {
        left = builder_.apply(Operation::Multiply, left, parse_signed());
      } else if (accept('/')) {
        left = builder_.apply(Operation::Divide, left, parse_signed());
      } else {
        return left;
      }
    }
  }

  /// Every recursion passes here: the one place to count the depth.
  int parse_signed() {
    if (++depth_ > kMaxFormulaDepth) {
      throw fault(fmt::format("nested more than {} deep", kMaxFormulaDepth));
    }
    const int result = accept('-')   ? builder_.apply(Operation::Negate, parse_signed())
                       : accept('+') ? parse_signed()
                                     : parse_power();
    --depth_;
    return result;
  }

  int parse_power() {
    const int base = parse_primary();
    return accept('^') ? builder_.apply(Operation::Power, base, parse_signed()) : base;
  }

  int parse_primary() {
    skip_space();
    if (position_ == text_.size()) fail(kOperand);
    const char next = text_[position_];
    if (is_digit(next) || next == '.') return parse_number();
    if (is_name_start(next)) return parse_name();
    if (!accept('(')) fail(kOperand);
    const int result = parse_sum();
    if (!accept(')')) fail("an operator or ')'");
    return result;
  }

  int parse_number() {
    double value = 0;
    const char* begin = text_.data() + position_;
    const auto [end, code] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (code == std::errc::result_out_of_range) {
      throw fault(fmt::format("the number {} is out of range", std::string_view(begin, end)));
    }
    if (code != std::errc()) fail(kOperand);
    position_ += static_cast<std::size_t>(end - begin);
    return builder_.constant(value);
  }

  int parse_name() {
    const std::size_t start = position_;
    while (position_ < text_.size() && is_name_part(text_[position_])) ++position_;
    const std::string name(text_.substr(start, position_ - start));

    if (const Function* function = find_function(name)) return parse_call(*function);
    const auto variable = std::ranges::find(variables_, name);
    if (variable != variables_.end()) return static_cast<int>(variable - variables_.begin());
    if (name == "pi") return builder_.constant(std::numbers::pi);
    if (name == "e") return builder_.constant(std::numbers::e);
    const auto constant = constants_.find(name);
    if (constant != constants_.end()) return builder_.constant(constant->second);

    const bool is_call = accept('(');
    position_ = start;
    throw fault(fmt::format("unknown {} '{}'", is_call ? "function" : "name", name));
  }

  int parse_call(const Function& function) {
    if (!accept('(')) fail(fmt::format("'(' after the function {}", function.name));
    std::array<int, 2> arguments = {0, 0};
    int count = 0;
    if (!accept(')')) {
      do {
        const int argument = parse_sum();
        if (count < 2) arguments[static_cast<std::size_t>(count)] = argument;
        ++count;
      } while (accept(','));
      if (!accept(')')) fail("an operator, ',' or ')'");
    }
    if (count != function.argument_count) {
      --position_;
      throw fault(fmt::format("the function {} takes {} argument{}, not {}", function.name,
                              function.argument_count, function.argument_count == 1 ? "" : "s",
                              count));
    }
    return builder_.apply(function.operation, arguments[0], arguments[1]);
  }

  void skip_space() {
    while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\t' ||
                                        text_[position_] == '\n' || text_[position_] == '\r')) {
      ++position_;
    }
  }

  bool accept(char wanted) {
    skip_space();
    if (position_ == text_.size() || text_[position_] != wanted) return false;
    ++position_;
    return true;
  }

  bool is_at_end() {
    skip_space();
    return position_ == text_.size();
  }

  /// What stands at the position: a whole name or number, or one character.
  std::string found() const {
    if (position_ == text_.size()) return "the end";
    std::size_t end = position_ + 1;
    if (is_name_part(text_[position_])) {
      while (end < text_.size() && is_name_part(text_[end])) ++end;
    } else {
      while (end < text_.size() && is_continuation_byte(text_[end])) ++end;
    }
    return fmt::format("'{}'", text_.substr(position_, end - position_));
  }

  Error fault(const std::string& reason) const {
    const auto column =
        1 + std::count_if(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(position_),
                          [](char c) { return !is_continuation_byte(c); });
    const std::string quoted = text_.size() <= kMaxQuoted
                                   ? std::string(text_)
                                   : std::string(text_.substr(0, kMaxQuoted)) + "...";
    return Error(ErrorCode::InvalidInput,
                 fmt::format("formula \"{}\", column {}: {}", quoted, column, reason));
  }

  [[noreturn]] void fail(std::string_view expected) {
    skip_space();
    throw fault(fmt::format("expected {}, found {}", expected, found()));
  }

  static constexpr std::string_view kOperand = "a number, a name or '('";

  std::string_view text_;
  const std::vector<std::string>& variables_;
  const Constants& constants_;
  FormulaBuilder& builder_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

}  // namespace

FormulaProgram parse_formulas(std::span<const std::string> texts,
                              const std::vector<std::string>& variables,
                              const Constants& constants) {
  if (variables.size() > kMaxFormulaVariables) {
    throw Error(ErrorCode::InvalidInput, fmt::format("a formula of {} variables, of at most {}",
                                                     variables.size(), kMaxFormulaVariables));
  }
  check_constants(constants, variables);
  FormulaBuilder builder(variables.size());
  std::vector<int> results;
  for (const std::string& text : texts) {
    results.push_back(Parser(text, variables, constants, builder).parse());
  }
  return builder.finish(results);
}

Formula parse_formula(std::string_view text, const std::vector<std::string>& variables,
                      const Constants& constants) {
  const std::array texts = {std::string(text)};
  return Formula(parse_formulas(texts, variables, constants));
}

double evaluate_constant(std::string_view text, const Constants& constants) {
  const double value = parse_formula(text, {}, constants).evaluate(std::span<const double>());
  if (!std::isfinite(value)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("formula \"{}\": its value is not finite", text));
  }
  return value;
}

template <int order>
JetNumber<order> Formula::evaluate(double u, double v) const {
  assert(program_.variable_count() <= 2);
  const std::array variables = {JetNumber<order>::parameter(u, 0),
                                JetNumber<order>::parameter(v, 1)};
  std::array<JetNumber<order>, 1> result;
  program_.evaluate<order>(std::span(variables).first(program_.variable_count()), result);
  return result[0];
}

template JetNumber<0> Formula::evaluate<0>(double, double) const;
template JetNumber<1> Formula::evaluate<1>(double, double) const;
template JetNumber<2> Formula::evaluate<2>(double, double) const;

double Formula::evaluate(std::span<const double> variables) const {
  std::array<JetNumber<0>, kMaxFormulaVariables> numbers;
  std::copy(variables.begin(), variables.end(), numbers.begin());
  std::array<JetNumber<0>, 1> result;
  program_.evaluate<0>(std::span(numbers).first(variables.size()), result);
  return result[0].value();
}

bool Formula::is_constant() const {
  const auto& instructions = program_.instructions();
  return instructions.size() == 1 && instructions[0].operation == Operation::Constant;
}

}  // namespace surfmesh
