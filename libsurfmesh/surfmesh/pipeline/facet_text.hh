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

/// How far a mesh and the faces of its cages are from each other; in the long style with places.
inline void add_facets(const FacetDistance& facets, TextTable& table) {
  if (!table.style().is_long) {
    return table.add("facets", fmt::format("from the faces of the input {:.3g} (mean {:.2g}), back "
                                           "{:.3g} ({:.2g})",
                                           facets.to_facets.max, facets.to_facets.mean,
                                           facets.from_facets.max, facets.from_facets.mean));
  }
  table.add("facets", "from the faces of the input: " + distance_text(facets.to_facets));
  table.add("", "of these from the mesh: " + distance_text(facets.from_facets));
}

}  // namespace surfmesh::detail
