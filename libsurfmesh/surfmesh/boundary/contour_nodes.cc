// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/contour_nodes.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/boundary/contour_division.hh"
#include "surfmesh/boundary/contour_memory.hh"
#include "surfmesh/boundary/even_counts.hh"
#include "surfmesh/boundary/segment_counts.hh"
#include "surfmesh/boundary/uncrossing.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

void check(const ContourDemands& demands) {
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
        multiple_(demands.parity == SegmentParity::EvenContours ? 2 : 1),
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

  /// Give contours further nodes where loops cross, and every patch an even number if that is asked
  /// for. Each may spoil what the other did.
  void settle() {
    uncross(model_, divisions_, multiple_, context_);
    if (demands_.parity != SegmentParity::EvenPatches) return;
    for (int round = 0; round < kMostRounds && has_odd_patch(); ++round) {
      make_patches_even(model_, least_, round == 0 && !demands_.sag, divisions_);
      uncross(model_, divisions_, multiple_, context_);
    }
  }

  ContourDivisions& divisions() { return divisions_; }

  /// What the contours took that were not known.
  QueryCounts queries() const {
    QueryCounts sum;
    for (const QueryCounts& count : queries_) sum += count;
    return sum;
  }

 private:
  static constexpr int kMostRounds = 10;

  bool has_odd_patch() const {
    const std::vector<char> is_odd = odd_patches(model_, divisions_);
    return std::find(is_odd.begin(), is_odd.end(), 1) != is_odd.end();
  }

  double more(std::size_t c) const {
    return demands_.more_segments.empty() ? 1 : demands_.more_segments[c];
  }

  void divide(std::size_t c) {
    const Contour& contour = model_.contours[c];
    ContourDivision& division = divisions_[c].emplace(model_, contour, fields_, context_);
    division.divide(least_(contour), multiple_, demands_.sag, more(c));
    if (division.halve_long_segments() && !demands_.sag) {
      division.even_out(least_(contour), multiple_);
    }
    division.halve_detours();
    division.round_up_to(multiple_);
    queries_[c] = division.queries();
  }

  const Model& model_;
  const std::vector<const MetricField*>& fields_;
  const ContourDemands& demands_;
  const RunContext& context_;
  const ContourMemory* memory_;
  int multiple_;  ///< of the number of segments of every contour
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
  divider.settle();
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
