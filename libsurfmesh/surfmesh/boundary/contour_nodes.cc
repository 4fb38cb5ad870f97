// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/contour_nodes.hh"

#include <fmt/format.h>

#include <cmath>

#include "surfmesh/boundary/contour_division.hh"
#include "surfmesh/boundary/contour_memory.hh"
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

/// Divides the contours of a model one by one.
class Divider {
 public:
  Divider(const Model& model, const std::vector<const MetricField*>& fields,
          const ContourDemands& demands, const RunContext& context, const ContourMemory* memory)
      : model_(model),
        fields_(fields),
        demands_(demands),
        context_(context),
        memory_(memory),
        least_(model),
        divisions_(model.contours.size()),
        queries_(model.contours.size()) {}

  void run() {
    share_indices(divisions_.size(), [this](std::size_t c) {
      const Contour& contour = model_.contours[c];
      if (contour.uses.empty() || contour.is_degenerate) return;
      if (const ContourDivision* known = memory_ ? memory_->find(c, more(c)) : nullptr) {
        divisions_[c].emplace(*known);
      } else {
        divide(c);
      }
    });
  }

  ContourDivisions& divisions() { return divisions_; }

  /// What the contours took that were not known.
  QueryCounts queries() const {
    QueryCounts sum;
    for (const QueryCounts& count : queries_) sum += count;
    return sum;
  }

 private:
  double more(std::size_t c) const {
    return demands_.more_segments.empty() ? 1 : demands_.more_segments[c];
  }

  void divide(std::size_t c) {
    const Contour& contour = model_.contours[c];
    ContourDivision& division = divisions_[c].emplace(model_, contour, fields_, context_);
    division.divide(least_(contour), demands_.multiple, demands_.sag, more(c));
    if (division.halve_long_segments() && !demands_.sag) {
      division.even_out(least_(contour), demands_.multiple);
    }
    division.halve_detours();
    division.round_up_to(demands_.multiple);
    queries_[c] = division.queries();
  }

  const Model& model_;
  const std::vector<const MetricField*>& fields_;
  const ContourDemands& demands_;
  const RunContext& context_;
  const ContourMemory* memory_;
  LeastSegments least_;
  ContourDivisions divisions_;
  std::vector<QueryCounts> queries_;  ///< by contour
};

}  // namespace

BoundaryNodes place_contour_nodes(const Model& model, const std::vector<const MetricField*>& fields,
                                  const ContourDemands& demands, const RunContext& context,
                                  ContourMemory* memory) {
  check(demands);
  Divider divider(model, fields, demands, context, memory);
  divider.run();
  ContourDivisions& divisions = divider.divisions();
  if (memory) memory->keep(divisions, demands.more_segments);
  uncross(model, divisions, demands.multiple, context);
  BoundaryNodes result;
  result.report.queries = divider.queries();
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    if (divisions[c]) {
      result.contours.push_back(divisions[c]->nodes());
    } else if (model.contours[c].is_degenerate && !model.contours[c].uses.empty()) {
      result.contours.push_back(degenerate_nodes(model, model.contours[c]));
    } else {
      result.contours.emplace_back();
    }
  }
  return result;
}

}  // namespace surfmesh
