// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/step_text.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

using Number = std::uint64_t;

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

/// Entities of these kinds without what makes them have no place in space.
constexpr std::array<std::string_view, 2> kWithoutPlace = {"POINT", "VERTEX"};

/// Ends of the names of entities whose lists have at least one element (ISO 10303-42), which
/// OpenCASCADE takes for granted. Lists of others, as of tessellations, may be empty.
constexpr std::array<std::string_view, 12> kWithFullLists = {"SHAPE_REPRESENTATION",
                                                             "_SHELL",
                                                             "_LOOP",
                                                             "_FACE_SET",
                                                             "_EDGE_SET",
                                                             "_MODEL",
                                                             "_CURVE",
                                                             "POLYLINE",
                                                             "_SURFACE",
                                                             "DIRECTION",
                                                             "_POINT",
                                                             "_WITH_KNOTS"};

bool has_full_lists(std::string_view name) {
  return std::any_of(kWithFullLists.begin(), kWithFullLists.end(),
                     [&](std::string_view end) { return name.ends_with(end); });
}

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }

/// Reads the numbers of entities: at the start of a statement that of its own, later those that it
/// refers to. Texts and comments are told from the rest as by OpenCASCADE.
class Entities {
 public:
  explicit Entities(std::string_view text) : text_(text) {}

  /// Throws   InvalidInput for what OpenCASCADE would fall over
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
    if (c == '\'') return skip_text();
    if (text_.substr(position_, 2) == "/*") return skip_comment();
    if (is_letter(c)) return take_word();
    ++position_;
    if (is_blank(c)) return;
    if (c == '(') open_list();
    if (c == ')') --depth_;
    if (c == ';') start_statement();
    if (c == '#') add_number();
    if (c == '=' || c == '(') is_at_start_ = false;
    word_ = {};
  }

  /// A text ends at a quote before a comma or a closing parenthesis: others belong to it.
  void skip_text() {
    do {
      position_ = std::min(text_.find('\'', position_ + 1), text_.size());
    } while (position_ < text_.size() && !is_end_of_text());
    if (position_ < text_.size()) ++position_;
  }

  bool is_end_of_text() const {
    std::size_t next = position_ + 1;
    while (next < text_.size() && is_blank(text_[next])) ++next;
    return next < text_.size() && (text_[next] == ',' || text_[next] == ')');
  }

  void skip_comment() {
    const std::size_t end = text_.find("*/", position_ + 2);
    position_ = end == std::string_view::npos ? text_.size() : end + 2;
  }

  void take_word() {
    const std::size_t begin = position_;
    while (position_ < text_.size() &&
           (is_letter(text_[position_]) || (text_[position_] >= '0' && text_[position_] <= '9'))) {
      ++position_;
    }
    word_ = text_.substr(begin, position_ - begin);
  }

  void start_statement() {
    is_at_start_ = true;
    depth_ = 0;
    entity_ = {};
  }

  /// The values of an entity, of which the name stands before them, or a list among these.
  void open_list() {
    ++depth_;
    if (!word_.empty()) {
      entity_ = word_;
      const bool is_alone = depth_ == 1;
      if (is_alone &&
          std::find(kWithoutPlace.begin(), kWithoutPlace.end(), entity_) != kWithoutPlace.end()) {
        fail_at_entity("has no place in space");
      }
      return;
    }
    std::size_t next = position_;
    while (next < text_.size() && is_blank(text_[next])) ++next;
    if (next < text_.size() && text_[next] == ')' && has_full_lists(entity_)) {
      fail_at_entity("has an empty list");
    }
  }

  [[noreturn]] void fail_at_entity(std::string_view what) const {
    fail_as_damaged(
        fmt::format("#{} {} {}", defined_.empty() ? 0 : defined_.back(), entity_, what));
  }

  void add_number() {
    Number number = 0;
    const char* begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), number);
    position_ += static_cast<std::size_t>(end - begin);
    if (error != std::errc()) return;
    if (is_at_start_) {
      defined_.push_back(number);
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
  int depth_ = 0;            ///< of parentheses
  std::string_view word_;    ///< that was read last, if blanks alone came after it
  std::string_view entity_;  ///< the name before the values being read
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
