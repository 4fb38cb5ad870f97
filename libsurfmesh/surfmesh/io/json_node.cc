// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/json_node.hh"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/nearest_word.hh"

namespace surfmesh {
namespace {

/// Model files need 7; more would only be made to exhaust the stack.
constexpr std::size_t kDeepestNesting = 64;

[[noreturn]] void fail_at(const std::string& file, const std::string& pointer,
                          std::string_view reason) {
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: {}{}{}", file, pointer, pointer.empty() ? "" : ": ", reason));
}

/// RFC 6901: ~ and / inside of a token are written ~0 and ~1.
std::string escaped(std::string_view token) {
  std::string text;
  for (const char c : token) {
    if (c == '~' || c == '/') {
      text += c == '~' ? "~0" : "~1";
    } else {
      text += c;
    }
  }
  return text;
}

/// Follows the parser through the text to find keys that come twice, which nlohmann-json lets
/// pass: the last one would win without a word.
class DuplicateCheck {
 public:
  explicit DuplicateCheck(const std::string& file) : file_(file) {}

  bool operator()(Json::parse_event_t event, const Json& value) {
    using Event = Json::parse_event_t;
    if (event == Event::object_start || event == Event::array_start) {
      open_.push_back({event == Event::array_start, 0, {}, {}});
      if (open_.size() > kDeepestNesting) fail_at(file_, pointer(), "the nesting is too deep");
    } else if (event == Event::key) {
      open_.back().key = value.get<std::string>();
      if (!open_.back().keys.insert(open_.back().key).second) {
        fail_at(file_, pointer(), "this key comes twice");
      }
    } else {
      if (event != Event::value) open_.pop_back();
      if (!open_.empty() && open_.back().is_array) ++open_.back().index;
    }
    return true;
  }

  /// Of the value that the parser has come to.
  std::string pointer() const {
    std::string text;
    for (const Level& level : open_) {
      if (level.is_array) {
        text += fmt::format("/{}", level.index);
      } else if (!level.keys.empty()) {
        text += fmt::format("/{}", escaped(level.key));
      }
    }
    return text;
  }

 private:
  struct Level {
    bool is_array = false;
    std::size_t index = 0;
    std::string key;
    std::set<std::string> keys;
  };

  const std::string& file_;
  std::vector<Level> open_;
};

/// What stands after "line 3, column 4: " in a message of the parser.
std::string_view reason_of(std::string_view message) {
  const std::size_t place = message.find("column ");
  const std::size_t colon = message.find(": ", place == message.npos ? 0 : place);
  return colon == message.npos ? message : message.substr(colon + 2);
}

[[noreturn]] void fail_syntax(std::string_view text, const std::string& name,
                              const Json::parse_error& error) {
  // The parser counts the byte that it stumbled over from 1; at the end it is one more.
  const std::size_t position = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
  const std::string_view before = text.substr(0, position);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("{}:{}:{}: {}", name, line, position - line_start + 1, reason_of(error.what())));
}

/// What stands after "[json.exception.out_of_range.406] " in a message of the parser.
std::string_view without_number(std::string_view message) {
  const std::size_t bracket = message.find("] ");
  return bracket == message.npos ? message : message.substr(bracket + 2);
}

std::string suggestion(std::string_view key, std::initializer_list<std::string_view> known) {
  const auto nearest = nearest_word(key, {known.begin(), known.size()});
  return nearest ? fmt::format(", did you mean {}?", *nearest) : "";
}

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
  DuplicateCheck check(name);
  try {
    return Json::parse(text, [&check](int, Json::parse_event_t event, Json& value) {
      return check(event, value);
    });
  } catch (const Json::parse_error& error) {
    fail_syntax(text, name, error);
  } catch (const Json::exception& error) {  // a number beyond the range of doubles
    fail_at(name, check.pointer(), without_number(error.what()));
  }
}

void JsonNode::fail(std::string_view reason) const { fail_at(file_, pointer_, reason); }

void JsonNode::fail_type(std::string_view wanted) const {
  fail(fmt::format("must be {}, not {}", wanted, json_->type_name()));
}

JsonNode JsonNode::child(const Json& json, const std::string& token) const {
  return {json, file_, fmt::format("{}/{}", pointer_, escaped(token)), places_};
}

std::string JsonNode::advice_for(std::string_view key,
                                 std::initializer_list<std::string_view> known) const {
  const auto place = places_ ? places_->find(key) : KeyPlaces::const_iterator();
  if (!places_ || place == places_->end()) return suggestion(key, known);
  return fmt::format(", {} belongs in {}", key, place->second);
}

void JsonNode::expect_keys(std::initializer_list<std::string_view> known) const {
  for (const auto& [key, node] : members()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    node.fail("unknown key" + advice_for(key, known));
  }
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  if (!json_->is_object()) fail_type("an object");
  const auto member = json_->find(key);
  if (member == json_->end()) return std::nullopt;
  return child(*member, std::string(key));
}

JsonNode JsonNode::at(std::string_view key) const {
  std::optional<JsonNode> node = find(key);
  if (!node) fail_at(file_, fmt::format("{}/{}", pointer_, escaped(key)), "this key is missing");
  return *node;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
  if (!json_->is_object()) fail_type("an object");
  std::vector<std::pair<std::string, JsonNode>> nodes;
  for (const auto& [key, value] : json_->items()) nodes.emplace_back(key, child(value, key));
  return nodes;
}

std::vector<JsonNode> JsonNode::elements() const {
  if (!json_->is_array()) fail_type("an array");
  std::vector<JsonNode> nodes;
  for (const Json& value : *json_) nodes.push_back(child(value, std::to_string(nodes.size())));
  return nodes;
}

std::vector<JsonNode> JsonNode::elements(std::size_t count) const {
  std::vector<JsonNode> nodes = elements();
  if (nodes.size() != count) {
    fail(fmt::format("must be an array of {} values, not {}", count, nodes.size()));
  }
  return nodes;
}

std::string JsonNode::text() const {
  if (!json_->is_string()) fail_type("a string");
  return json_->get<std::string>();
}

double JsonNode::number() const {
  if (!json_->is_number()) fail_type("a number");
  return json_->get<double>();
}

bool JsonNode::boolean() const {
  if (!json_->is_boolean()) fail_type("true or false");
  return json_->get<bool>();
}

}  // namespace surfmesh
