// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "surfmesh/quality/statistics.hh"

namespace surfmesh::detail {

inline nlohmann::ordered_json histogram_json(const std::vector<HistogramBin>& bins) {
  auto json = nlohmann::ordered_json::array();
  for (const HistogramBin& bin : bins) {
    json.push_back({{"from", bin.from}, {"to", bin.to}, {"count", bin.count}});
  }
  return json;
}

inline nlohmann::ordered_json edges_json(const EdgeStatistics& edges) {
  return {{"count", edges.count},
          {"mean", edges.mean},
          {"stddev", edges.stddev},
          {"min", edges.min},
          {"max", edges.max},
          {"unit_fraction", edges.unit_fraction},
          {"histogram", histogram_json(edges.histogram)}};
}

}  // namespace surfmesh::detail
