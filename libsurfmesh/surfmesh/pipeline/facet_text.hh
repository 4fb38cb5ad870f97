// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>

#include "surfmesh/core/notice.hh"
#include "surfmesh/pipeline/text_table.hh"
#include "surfmesh/quality/facet_distance.hh"

namespace surfmesh::detail {

inline std::string distance_text(const OneWayDistance& distance) {
  return fmt::format("greatest {:.3g} at {}, mean {:.3g}", distance.max,
                     point_text(distance.max_at), distance.mean);
}

/// How far a mesh and the faces of its cages are from each other.
inline void add_facets(const FacetDistance& facets, TextTable& table) {
  table.add("facets", "from the faces of the input: " + distance_text(facets.to_facets));
  table.add("", "of these from the mesh: " + distance_text(facets.from_facets));
}

}  // namespace surfmesh::detail
