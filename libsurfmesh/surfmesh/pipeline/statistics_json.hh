// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/io/json.hh"
#include "surfmesh/quality/facet_distance.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh::detail {

inline Json histogram_json(const std::vector<HistogramBin>& bins) {
  auto json = Json::array();
  for (const HistogramBin& bin : bins) {
    json.push_back({{"from", bin.from}, {"to", bin.to}, {"count", bin.count}});
  }
  return json;
}

inline Json edges_json(const EdgeStatistics& edges) {
  return {{"count", edges.count},
          {"mean", edges.mean},
          {"stddev", edges.stddev},
          {"min", edges.min},
          {"max", edges.max},
          {"unit_fraction", edges.unit_fraction},
          {"histogram", histogram_json(edges.histogram)}};
}

inline Json distance_json(const OneWayDistance& distance) {
  return {{"max", distance.max},
          {"mean", distance.mean},
          {"max_at", {distance.max_at.x(), distance.max_at.y(), distance.max_at.z()}},
          {"max_face", distance.max_face}};
}

inline Json facets_json(const FacetDistance& facets) {
  return {{"to_facets", distance_json(facets.to_facets)},
          {"from_facets", distance_json(facets.from_facets)}};
}

}  // namespace surfmesh::detail
