// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "surfmesh/io/json.hh"
#include "surfmesh/io/key_places.hh"

namespace surfmesh {

/// Parse JSON text that a person wrote.
///
/// Throws   InvalidInput with "name:line:column: reason" for bad syntax, "name: /pointer: reason"
///          for a key that an object has twice, a number beyond the range of doubles, and nesting
///          that no file needs
Json parse_json(std::string_view text, const std::string& name);

/// A value of a JSON file and its place, so that every fault names the file and the JSON pointer.
/// The JSON value must outlive it. All its functions throw InvalidInput for what does not fit.
class JsonNode {
 public:
  /// `places` may be null, and must outlive all nodes.
  JsonNode(const Json& json, std::string file, std::string pointer = "",
           const KeyPlaces* places = nullptr)
      : json_(&json), file_(std::move(file)), pointer_(std::move(pointer)), places_(places) {}

  /// Throw InvalidInput with "file: /pointer: reason".
  [[noreturn]] void fail(std::string_view reason) const;

  const Json& json() const { return *json_; }
  /// The JSON pointer of this value.
  const std::string& pointer() const { return pointer_; }
  /// The file and the pointer: "a.json: /sources/2".
  std::string place() const { return file_ + ": " + pointer_; }

  /// Fail unless this is an object with no other keys than these; tell where another one belongs,
  /// or what was probably meant.
  void expect_keys(std::initializer_list<std::string_view> known) const;
  bool has(std::string_view key) const { return json_->contains(key); }
  std::optional<JsonNode> find(std::string_view key) const;
  JsonNode at(std::string_view key) const;
  /// Keys and values of an object, in the order of the file.
  std::vector<std::pair<std::string, JsonNode>> members() const;

  std::vector<JsonNode> elements() const;
  /// Fail unless this is an array of `count` elements.
  std::vector<JsonNode> elements(std::size_t count) const;

  std::string text() const;
  double number() const;
  bool boolean() const;

 private:
  JsonNode child(const Json& json, const std::string& token) const;
  [[noreturn]] void fail_type(std::string_view wanted) const;
  std::string advice_for(std::string_view key, std::initializer_list<std::string_view> known) const;

  const Json* json_;
  std::string file_;
  std::string pointer_;
  const KeyPlaces* places_;
};

}  // namespace surfmesh
