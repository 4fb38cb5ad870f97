// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/step_text.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh_cad/cad_number.hh"

namespace surfmesh {
namespace {

using Number = std::uint64_t;

/// OpenCASCADE has numbers of entities as int.
constexpr Number kMostNumber = std::numeric_limits<std::int32_t>::max();

struct Reference {
  Number to = 0;
  Number from = 0;  ///< the entity that refers to it
};

/// The entities of a file, and for each the indices of those it refers to.
struct References {
  std::vector<Number> numbers;
  std::vector<std::vector<std::size_t>> targets;
};

[[noreturn]] void fail_as_damaged(const std::string& reason) {
  throw Error(ErrorCode::InvalidInput, fmt::format("the STEP file is damaged: {}", reason));
}

/// Entities of these kinds alone, without what makes them one of a finer kind, have no place in
/// space.
constexpr std::array<std::string_view, 2> kWithoutPlace = {"POINT", "VERTEX"};

/// Entities whose lists have at least one element by the standard. OpenCASCADE 7.6 takes it for
/// granted, and crashes at an empty one.
constexpr std::array<std::string_view, 30> kWithFullLists = {
    "ADVANCED_BREP_SHAPE_REPRESENTATION",
    "BEZIER_CURVE",
    "BEZIER_SURFACE",
    "B_SPLINE_CURVE",
    "B_SPLINE_CURVE_WITH_KNOTS",
    "B_SPLINE_SURFACE",
    "B_SPLINE_SURFACE_WITH_KNOTS",
    "CLOSED_SHELL",
    "CONNECTED_EDGE_SET",
    "CONNECTED_FACE_SET",
    "DIRECTION",
    "EDGE_BASED_WIREFRAME_MODEL",
    "EDGE_BASED_WIREFRAME_SHAPE_REPRESENTATION",
    "EDGE_LOOP",
    "FACETED_BREP_SHAPE_REPRESENTATION",
    "FACE_BASED_SURFACE_MODEL",
    "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION",
    "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION",
    "INTERSECTION_CURVE",
    "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
    "OPEN_SHELL",
    "POLY_LOOP",
    "QUASI_UNIFORM_CURVE",
    "QUASI_UNIFORM_SURFACE",
    "SEAM_CURVE",
    "SHAPE_REPRESENTATION",
    "SHELL_BASED_SURFACE_MODEL",
    "SURFACE_CURVE",
    "UNIFORM_CURVE",
    "UNIFORM_SURFACE"};

template <class Names>
bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\0'; }

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads the numbers of entities: at the start of a statement that of its own, later those that it
/// refers to. On the way it refuses points, vertices and lists without what they consist of.
///
/// Texts, comments and the end are told from the rest as OpenCASCADE's step.lex does it.
class Entities {
 public:
  explicit Entities(std::string_view text) : text_(text) {}

  /// Throws   InvalidInput for what OpenCASCADE would crash at
  References read() {
    while (position_ < text_.size()) step();
    std::sort(defined_.begin(), defined_.end());
    const auto twice = std::adjacent_find(defined_.begin(), defined_.end());
    if (twice != defined_.end()) fail_as_damaged(fmt::format("#{} is defined twice", *twice));
    return resolved();
  }

 private:
  void step() {
    const char c = text_[position_];
    if (text_.substr(position_, 2) == "/*") return skip_comment();
    if (is_blank(c)) {
      ++position_;
    } else if (c == ')') {
      close();
    } else {
      take(c);
    }
  }

  void take(char c) {
    is_list_empty_ = false;
    if (is_defined_next_ && c != '=') {
      fail_as_damaged(fmt::format("#{} has no = behind it", defined_.back()));
    }
    is_defined_next_ = false;
    if (c == '\'') return skip_text();
    if (is_letter(c)) return take_word();
    if (c == '"') return skip_binary();
    if (is_digit(c) || c == '+' || c == '-' || c == '.') return take_real();
    ++position_;
    if (c == '(') open();
    if (c == ';') start_statement();
    if (c == '#') add_number();
    if (c == '=' || c == '(') is_at_start_ = false;
    word_ = {};
  }

  /// A text ends at a quote before a comma or a closing parenthesis; other quotes belong to it.
  void skip_text() {
    do {
      position_ = std::min(text_.find('\'', position_ + 1), text_.size());
    } while (position_ < text_.size() && !is_end_of_text());
    if (position_ < text_.size()) ++position_;
    word_ = {};
  }

  /// The rule of step.lex is [']/[" "\n\r]*[\)\,], where a class in brackets has the double quote.
  bool is_end_of_text() const {
    const std::size_t next = text_.find_first_not_of("\" \n\r", position_ + 1);
    return next != std::string_view::npos && (text_[next] == ',' || text_[next] == ')');
  }

  void skip_comment() {
    const std::size_t end = text_.find("*/", position_ + 2);
    position_ = end == std::string_view::npos ? text_.size() : end + 2;
  }

  void take_word() {
    const std::size_t begin = position_;
    while (position_ < text_.size() &&
           (is_letter(text_[position_]) || is_digit(text_[position_]))) {
      ++position_;
    }
    word_ = text_.substr(begin, position_ - begin);
    const bool is_end = word_ == "END" && text_.substr(position_).starts_with("-ISO");
    if (is_end) position_ = text_.size();
  }

  std::size_t skip(std::string_view characters, std::size_t from) const {
    return std::min(text_.find_first_not_of(characters, from), text_.size());
  }

  /// Take a number, or the first point of a value between two.
  void take_real() {
    std::size_t end = skip("0123456789.", skip("+-", position_));
    if (end < text_.size() && (text_[end] == 'E' || text_[end] == 'e')) {
      end = skip("0123456789", skip("+-", end + 1));
    }
    const std::string_view number = text_.substr(position_, end - position_);
    if (is_too_large(cad_number(number).value_or(0))) {
      fail_as_damaged(
          fmt::format("#{}: {} is too large", defined_.empty() ? 0 : defined_.back(), number));
    }
    position_ = end;
    word_ = {};
  }

  /// A binary value: digits to the base 16 between quotes of two strokes.
  void skip_binary() {
    const std::size_t end = skip("0123456789ABCDEF", position_ + 1);
    position_ = end < text_.size() && text_[end] == '"' ? end + 1 : position_ + 1;
    word_ = {};
  }

  void start_statement() {
    is_at_start_ = true;
    names_.clear();
  }

  /// A parenthesis begins the values of the entity whose name is before it, or a list among them.
  void open() {
    is_list_empty_ = word_.empty();
    const bool is_alone = names_.empty();
    names_.push_back(!word_.empty() ? word_ : is_alone ? std::string_view() : names_.back());
    if (is_alone && has(kWithoutPlace, names_.back())) fail_at_entity("has no place in space");
  }

  void close() {
    if (is_list_empty_ && has(kWithFullLists, names_.back())) fail_at_entity("has an empty list");
    is_list_empty_ = false;
    if (!names_.empty()) names_.pop_back();
    ++position_;
    word_ = {};
  }

  [[noreturn]] void fail_at_entity(std::string_view what) const {
    const Number number = defined_.empty() ? 0 : defined_.back();
    fail_as_damaged(fmt::format("#{} {} {}", number, names_.back(), what));
  }

  void add_number() {
    Number number = 0;
    const char* begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), number);
    position_ += static_cast<std::size_t>(end - begin);
    if (end == begin) return;
    if (error != std::errc() || number > kMostNumber) {
      fail_as_damaged(fmt::format("#{} is too large a number of an entity",
                                  text_.substr(position_ - (end - begin), end - begin)));
    }
    if (is_at_start_) {
      defined_.push_back(number);
      is_defined_next_ = true;
    } else if (!defined_.empty()) {
      references_.push_back({number, defined_.back()});
    }
  }

  std::size_t index_of(Number number) const {
    const auto found = std::lower_bound(defined_.begin(), defined_.end(), number);
    return found != defined_.end() && *found == number
               ? static_cast<std::size_t>(found - defined_.begin())
               : defined_.size();
  }

  References resolved() const {
    References result = {defined_, std::vector<std::vector<std::size_t>>(defined_.size())};
    for (const Reference& reference : references_) {
      const std::size_t to = index_of(reference.to);
      if (to == defined_.size()) {
        fail_as_damaged(
            fmt::format("#{} refers to #{}, which is not in it", reference.from, reference.to));
      }
      result.targets[index_of(reference.from)].push_back(to);
    }
    return result;
  }

  std::string_view text_;
  std::size_t position_ = 0;
  bool is_at_start_ = true;
  bool is_defined_next_ = false;         ///< the number of a new entity was the last
  bool is_list_empty_ = false;           ///< nothing has come since a list began
  std::string_view word_;                ///< the last word, if only blanks or comments follow it
  std::vector<std::string_view> names_;  ///< of the entities whose parentheses are open
  std::vector<Number> defined_;
  std::vector<Reference> references_;
};

/// An entity on the way from where a walk along references began, and its next reference.
struct Step {
  std::size_t entity = 0;
  std::size_t next = 0;
};

/// Find an entity that leads back to itself.
class Walk {
 public:
  explicit Walk(References references)
      : references_(std::move(references)), states_(references_.numbers.size(), State::Unseen) {}

  void check() {
    for (std::size_t i = 0; i < states_.size(); ++i) walk_from(i);
  }

 private:
  enum class State : char { Unseen, OnTheWay, Done };

  void enter(std::size_t entity) {
    states_[entity] = State::OnTheWay;
    way_.push_back({entity, 0});
  }

  void walk_from(std::size_t start) {
    if (states_[start] == State::Unseen) enter(start);
    while (!way_.empty()) {
      Step& step = way_.back();
      const std::vector<std::size_t>& targets = references_.targets[step.entity];
      if (step.next == targets.size()) {
        states_[step.entity] = State::Done;
        way_.pop_back();
        continue;
      }
      const std::size_t target = targets[step.next++];
      if (states_[target] == State::OnTheWay) {
        fail_as_damaged(fmt::format("#{} refers to itself", references_.numbers[target]));
      }
      if (states_[target] == State::Unseen) enter(target);
    }
  }

  References references_;
  std::vector<State> states_;
  std::vector<Step> way_;
};

}  // namespace

void check_step_text(std::string_view text) { Walk(Entities(text).read()).check(); }

}  // namespace surfmesh
