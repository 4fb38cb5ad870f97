// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "surfmesh/core/at_location.hh"

namespace surfmesh {

/// Where a source is given, for messages: its file and JSON pointer, or in C++ its list of Sources
/// and its index there, as "sources.near[3]".
template <class Source>
std::string place_of(const Source& source, std::string_view list, std::size_t index) {
  return source.origin.empty() ? fmt::format("sources.{}[{}]", list, index) : source.origin;
}

/// Run `body`. Its errors get the origin of the source in front, if it has one.
template <class Source, class Body>
auto at_source(const Source& source, Body body) {
  return source.origin.empty() ? body() : at_location(source.origin, body);
}

}  // namespace surfmesh
