// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/contour_nodes.hh"

#include <fmt/format.h>

#include <cmath>

#include "surfmesh/boundary/contour_division.hh"
#include "surfmesh/boundary/segment_counts.hh"
#include "surfmesh/boundary/uncrossing.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

void check(const ContourDemands& demands) {
  if (demands.multiple < 1) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("the number of segments cannot be a multiple of {}", demands.multiple));
  }
  for (const double factor : demands.more_segments) {
    if (factor >= 1 && std::isfinite(factor)) continue;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("a factor of segments of {} is not 1 or above", factor));
  }
  if (demands.sag && !(*demands.sag > 0)) {
    throw Error(ErrorCode::InvalidInput, fmt::format("a sag of {} is not above 0", *demands.sag));
  }
}

ContourNodes degenerate_nodes(const Model& model, const Contour& contour) {
  ContourNodes nodes;
  nodes.points.assign(2, model.position(contour.start));
  for (const ContourUse& use : contour.uses) {
    nodes.uv.push_back({use.curve->evaluate(0), use.curve->evaluate(1)});
  }
  return nodes;
}

}  // namespace

BoundaryNodes place_contour_nodes(const Model& model, const std::vector<const MetricField*>& fields,
                                  const ContourDemands& demands, const RunContext& context) {
  check(demands);
  const LeastSegments least(model);
  ContourDivisions divisions(model.contours.size());
  share_indices(model.contours.size(), [&](std::size_t c) {
    const Contour& contour = model.contours[c];
    if (contour.uses.empty() || contour.is_degenerate) return;
    ContourDivision& division = divisions[c].emplace(model, contour, fields, context);
    division.divide(least(contour), demands.multiple, demands.sag,
                    demands.more_segments.empty() ? 1 : demands.more_segments[c]);
    if (division.halve_long_segments() && !demands.sag) {
      division.even_out(least(contour), demands.multiple);
    }
    division.halve_detours();
    division.round_up_to(demands.multiple);
  });
  uncross(model, divisions, demands.multiple, context);
  BoundaryNodes result;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    if (divisions[c]) {
      result.contours.push_back(divisions[c]->nodes());
      result.report.queries += divisions[c]->queries();
    } else if (model.contours[c].is_degenerate && !model.contours[c].uses.empty()) {
      result.contours.push_back(degenerate_nodes(model, model.contours[c]));
    } else {
      result.contours.emplace_back();
    }
  }
  return result;
}

}  // namespace surfmesh
