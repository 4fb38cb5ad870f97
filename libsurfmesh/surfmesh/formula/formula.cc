// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "surfmesh/core/error.hh"
#include "surfmesh/formula/coordinates.hh"
#include "surfmesh/formula/formula_functions.hh"
#include "surfmesh/formula/unknown_name.hh"

namespace surfmesh {
namespace {

/// Names that mean the same in every formula of a model.
constexpr std::array<std::string_view, 5> kReserved = {"pi", "e", "u", "v", "t"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_name_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool is_name_part(char c) { return is_name_start(c) || is_digit(c); }

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

bool is_name(std::string_view text) {
  return !text.empty() && is_name_start(text[0]) && std::ranges::all_of(text, is_name_part);
}

using Constants = std::map<std::string, double>;

/// What names mean in a formula.
struct Names {
  const std::vector<std::string>& variables;
  const Constants& constants;
  const std::map<std::string, int>& named;  // nodes of the builder
};

/// The names that a formula may use, besides functions.
std::vector<std::string_view> words(const Names& names) {
  std::vector<std::string_view> result(names.variables.begin(), names.variables.end());
  for (const auto& [name, node] : names.named) result.push_back(name);
  for (const auto& [name, value] : names.constants) result.push_back(name);
  result.insert(result.end(), {"pi", "e"});
  return result;
}

/// What is written in other languages, and how to say it.
struct ForeignSign {
  std::string_view sign;
  std::string_view advice;
};

constexpr std::array kForeignSigns = {
    ForeignSign{"&&", "for 'and' multiply the comparisons: (a<b)*(b<c)"},
    ForeignSign{"||", "for 'or' take the greater comparison: max(a<b,b<c)"},
    ForeignSign{"=", "'equal' is =="}};

/// Recursive descent straight into the builder:
///   whole   = sum [ (<|<=|>|>=|==|!=) sum ]
///   sum     = product { (+|-) product }
///   product = signed { (*|/) signed }
///   signed  = (-|+) signed | power
///   power   = primary [ (^|**) signed ]
///   primary = number | name | function ( whole {, whole} ) | ( whole )
class Parser {
 public:
  Parser(std::string_view text, const Names& names, FormulaBuilder& builder)
      : text_(text), names_(names), builder_(builder) {}

  int parse() {
    const int result = parse_whole();
    if (!is_at_end()) fail("an operator or the end");
    return result;
  }

 private:
  int parse_whole() {
    const int left = parse_sum();
    refuse_foreign_signs();
    const std::string_view comparison = accept_comparison();
    if (comparison.empty()) return left;
    const int result = compare(left, comparison, parse_sum());
    refuse_foreign_signs();
    const std::size_t end = position_;
    if (accept_comparison().empty()) return result;
    position_ = end;
    throw fault("comparisons do not follow each other: multiply them, (a<b)*(b<c)");
  }

  int compare(int left, std::string_view comparison, int right) {
    if (comparison == "<") return builder_.apply(Operation::Less, left, right);
    if (comparison == ">") return builder_.apply(Operation::Less, right, left);
    if (comparison == "<=") return builder_.apply(Operation::LessEqual, left, right);
    if (comparison == ">=") return builder_.apply(Operation::LessEqual, right, left);
    const int equal = builder_.apply(Operation::Equal, left, right);
    if (comparison == "==") return equal;
    return builder_.apply(Operation::Subtract, builder_.constant(1), equal);
  }

  int parse_sum() {
    int left = parse_product();
    while (true) {
      if (accept("+")) {
        left = builder_.apply(Operation::Add, left, parse_product());
      } else if (accept("-")) {
        left = builder_.apply(Operation::Subtract, left, parse_product());
      } else {
        return left;
      }
    }
  }

  int parse_product() {
    int left = parse_signed();
    while (true) {
      if (accept("*")) {
        left = builder_.apply(Operation::Multiply, left, parse_signed());
      } else if (accept("/")) {
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
    const int result = accept("-")   ? builder_.apply(Operation::Negate, parse_signed())
                       : accept("+") ? parse_signed()
                                     : parse_power();
    --depth_;
    return result;
  }

  int parse_power() {
    const int base = parse_primary();
    return accept("^") || accept("**") ? builder_.apply(Operation::Power, base, parse_signed())
                                       : base;
  }

  int parse_primary() {
    skip_space();
    if (position_ == text_.size()) fail(kOperand);
    const char next = text_[position_];
    if (is_digit(next) || next == '.') return parse_number();
    if (is_name_start(next)) return parse_name();
    if (!accept("(")) fail(kOperand);
    const int result = parse_whole();
    if (!accept(")")) fail("an operator or ')'");
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

    if (const auto* function = find_formula_function(name)) return parse_call(*function);
    if (const auto node = find(name)) return *node;
    const bool is_call = accept("(");
    position_ = start;
    throw fault(is_call ? unknown_function(name) : unknown_name(name, words(names_)));
  }

  /// The node of a name that is no function.
  std::optional<int> find(const std::string& name) {
    const auto variable = std::ranges::find(names_.variables, name);
    if (variable != names_.variables.end()) {
      return static_cast<int>(variable - names_.variables.begin());
    }
    const auto named = names_.named.find(name);
    if (named != names_.named.end()) return named->second;
    const auto constant = names_.constants.find(name);
    if (constant != names_.constants.end()) return builder_.constant(constant->second);
    if (name == "pi" || name == "PI") return builder_.constant(std::numbers::pi);
    if (name == "e") return builder_.constant(std::numbers::e);
    return {};
  }

  int parse_call(const FormulaFunction& function) {
    if (!accept("(")) fail(fmt::format("'(' after the function {}", function.name));
    std::array<int, 3> arguments = {0, 0, 0};
    std::size_t count = 0;
    if (!accept(")")) {
      do {
        const int argument = parse_whole();
        if (count < arguments.size()) arguments[count] = argument;
        ++count;
      } while (accept(","));
      if (!accept(")")) fail("an operator, ',' or ')'");
    }
    expect_count(function, count);
    return builder_.apply(function.operation, arguments[0], arguments[1], arguments[2]);
  }

  void expect_count(const FormulaFunction& function, std::size_t count) {
    const std::size_t wanted = function.argument_count();
    if (count == wanted) return;
    --position_;
    throw fault(fmt::format("the function {} takes {} argument{}, not {}: {}({})", function.name,
                            wanted, wanted == 1 ? "" : "s", count, function.name,
                            function.arguments));
  }

  std::string_view accept_comparison() {
    for (const std::string_view sign : {"<=", ">=", "==", "!=", "<", ">"}) {
      if (accept(sign)) return sign;
    }
    return {};
  }

  void refuse_foreign_signs() {
    skip_space();
    const std::string_view rest = text_.substr(position_);
    for (const auto& [sign, advice] : kForeignSigns) {
      if (!rest.starts_with(sign) || rest.starts_with("==")) continue;
      throw fault(fmt::format("found '{}'; {}", sign, advice));
    }
  }

  void skip_space() {
    while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\t' ||
                                        text_[position_] == '\n' || text_[position_] == '\r')) {
      ++position_;
    }
  }

  /// Step over a sign, if it stands here; ** is not *.
  bool accept(std::string_view wanted) {
    skip_space();
    const std::string_view rest = text_.substr(position_);
    if (!rest.starts_with(wanted) || (wanted == "*" && rest.starts_with("**"))) return false;
    position_ += wanted.size();
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
    return fmt::format("'{}'", shortened(text_.substr(position_, end - position_)));
  }

  Error fault(const std::string& reason) const {
    const auto column =
        1 + std::count_if(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(position_),
                          [](char c) { return !is_continuation_byte(c); });
    return Error(ErrorCode::InvalidInput,
                 fmt::format("formula \"{}\", column {}: {}", shortened(text_), column, reason));
  }

  [[noreturn]] void fail(std::string_view expected) {
    skip_space();
    throw fault(fmt::format("expected {}, found {}", expected, found()));
  }

  static constexpr std::string_view kOperand = "a number, a name or '('";

  std::string_view text_;
  const Names& names_;
  FormulaBuilder& builder_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string_view formula_name_fault(std::string_view name) {
  if (!is_name(name)) return "is not a name of letters, digits and _";
  const bool is_taken =
      std::ranges::find(kReserved, name) != kReserved.end() || find_formula_function(name);
  return is_taken ? "would redefine a name of the formulas" : "";
}

FormulaReader::FormulaReader(const std::vector<std::string>& variables, const Constants& constants)
    : variables_(variables), builder_(variables.size()) {
  if (variables.size() > kMaxFormulaVariables) {
    throw Error(ErrorCode::InvalidInput, fmt::format("a formula of {} variables, of at most {}",
                                                     variables.size(), kMaxFormulaVariables));
  }
  for (const auto& [name, value] : constants) {
    std::string_view fault = name_fault(name);
    if (fault.empty() && !std::isfinite(value)) fault = "is not finite";
    if (fault.empty()) continue;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("the constant '{}' {}", shortened(name), fault));
  }
  constants_ = constants;
}

std::string_view FormulaReader::name_fault(const std::string& name) const {
  const std::string_view fault = formula_name_fault(name);
  const bool is_taken = std::ranges::find(variables_, name) != variables_.end() ||
                        constants_.contains(name) || named_.contains(name);
  return fault.empty() && is_taken ? "is the name of something else" : fault;
}

void FormulaReader::define(const std::string& name, std::string_view text) {
  const std::string_view fault = name_fault(name);
  if (!fault.empty()) {
    throw Error(ErrorCode::InvalidInput, fmt::format("the name '{}' {}", shortened(name), fault));
  }
  named_[name] = read(text);
}

int FormulaReader::read(std::string_view text) {
  const Names names = {variables_, constants_, named_};
  return Parser(text, names, builder_).parse();
}

FormulaProgram FormulaReader::finish(const std::vector<int>& formulas) const {
  return builder_.finish(formulas);
}

FormulaProgram parse_formulas(std::span<const std::string> texts,
                              const std::vector<std::string>& variables, const Constants& constants,
                              std::span<const NamedFormula> where) {
  FormulaReader reader(variables, constants);
  define_all(where, reader);
  std::vector<int> formulas;
  for (const std::string& text : texts) formulas.push_back(reader.read(text));
  return reader.finish(formulas);
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
