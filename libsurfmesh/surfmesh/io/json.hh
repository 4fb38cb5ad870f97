// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Not for public headers: nlohmann-json stays inside of the library.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"

namespace surfmesh {

/// The allocator of std::allocator, by whose name the JSON values of this library have a type of
/// their own.
template <class T>
struct JsonAllocator : std::allocator<T> {
  using std::allocator<T>::allocator;
  template <class Other>
  struct rebind {
    using other = JsonAllocator<Other>;
  };
};

/// A JSON value, with the keys of objects in their order.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                  std::int64_t, std::uint64_t, double, JsonAllocator>;

/// Delete an object, an array or a text that was made by its allocator; null where memory ran out
/// before it was made.
template <class Value>
void delete_json_part(Value* part) {
  if (!part) return;
  JsonAllocator<Value> allocator;
  std::destroy_at(part);
  allocator.deallocate(part, 1);
}

}  // namespace surfmesh

// What follows takes the place of members of nlohmann-json 3.11.2 that are not safe where memory
// runs out. They are private to it: with any other version it is used as it is.
#if NLOHMANN_JSON_VERSION_MAJOR == 3 && NLOHMANN_JSON_VERSION_MINOR == 11 && \
    NLOHMANN_JSON_VERSION_PATCH == 2

/// Make an object of a list of pairs whose first is a text, else an array.
///
/// That of nlohmann-json leaks the object if an entry of it cannot be made. Here the value is
/// complete before, so that it is destroyed then.
template <>
inline surfmesh::Json::basic_json(initializer_list_t init, bool deduces_type, value_t wanted)
    : basic_json() {
  const bool are_pairs = std::all_of(init.begin(), init.end(), [](const auto& element) {
    return element->is_array() && element->size() == 2 && (*element)[0].is_string();
  });
  if (!deduces_type && wanted == value_t::object && !are_pairs) {
    throw surfmesh::Error(surfmesh::ErrorCode::InvalidInput, "a list of no pairs is no object");
  }
  if (!are_pairs || (!deduces_type && wanted == value_t::array)) {
    *this = basic_json(value_t::array);
    m_value.array->reserve(init.size());
    for (const auto& element : init) m_value.array->push_back(element.moved_or_copied());
    return;
  }
  *this = basic_json(value_t::object);
  m_value.object->reserve(init.size());
  for (const auto& element : init) {
    basic_json pair = element.moved_or_copied();
    m_value.object->emplace(std::move(*pair[0].m_value.string), std::move(pair[1]));
  }
}

/// Destroy a value with those in it.
///
/// That of nlohmann-json allocates a stack for the values inside, against nesting without end. It
/// is called by destructors, so where memory runs out in it the whole program would end. Here calls
/// are nested as deep as values are, which parse_json bounds.
template <>
inline void surfmesh::Json::json_value::destroy(value_t kind) {
  if (kind == value_t::object) surfmesh::delete_json_part(object);
  if (kind == value_t::array) surfmesh::delete_json_part(array);
  if (kind == value_t::string) surfmesh::delete_json_part(string);
  if (kind == value_t::binary) surfmesh::delete_json_part(binary);
}

#endif
