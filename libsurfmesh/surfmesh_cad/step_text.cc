// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/step_text.hh"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
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

/// Reads the numbers of entities: at the start of a statement that of its own, later those that it
/// refers to.
class Entities {
 public:
  explicit Entities(std::string_view text) : text_(text) {}

  References read() {
    while (position_ < text_.size()) step();
    std::sort(defined_.begin(), defined_.end());
    return resolved();
  }

 private:
  void step() {
    const char c = text_[position_];
    if (c == '\'' || c == '"') return skip_past(text_.substr(position_, 1), 1);
    if (text_.substr(position_, 2) == "/*") return skip_past("*/", 2);
    ++position_;
    if (c == ';') is_at_start_ = true;
    if (c == '#') add_number();
    if (c == '=' || c == '(') is_at_start_ = false;
  }

  void skip_past(std::string_view end, std::size_t begin) {
    const std::size_t at = text_.find(end, position_ + begin);
    position_ = at == std::string_view::npos ? text_.size() : at + end.size();
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
