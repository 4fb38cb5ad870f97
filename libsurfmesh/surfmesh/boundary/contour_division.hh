// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "surfmesh/boundary/contour_nodes.hh"
#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/core/run_context.hh"

namespace surfmesh {

/// One contour while its nodes are placed: the t of each node on each use.
///
/// The use in whose metric the contour is longest, the selected one, places the nodes; the others
/// follow it.
class ContourDivision {
 public:
  using Parameters = std::vector<std::vector<double>>;  ///< by use, then by node

  /// `fields` holds the metric of each patch. The context must outlive this; every member that
  /// makes segments throws Cancelled.
  ContourDivision(const Model& model, const Contour& contour,
                  const std::vector<const MetricField*>& fields, const RunContext& context);

  /// Place the nodes at equal metric arcs: as many segments as the length, or the sag, asks for.
  /// `more` is a factor of the latter.
  void divide(int least, int multiple, std::optional<double> sag, double more = 1);

  /// Halve the segments that are too long for some patch.
  /// Returns  true if there were any
  bool halve_long_segments();

  /// Spread the nodes evenly over what the finest patch wants at each place, if halving has made
  /// more segments than that takes.
  void even_out(int least, int multiple);

  /// Halve segments whose straight line in the parameters of a patch with a pole makes a detour
  /// around it.
  void halve_detours();

  /// Halve a segment that crosses another one where that is possible.
  /// Returns  true if it was
  bool halve_crossing(std::size_t i);

  /// Halve the longest segments until their number is a multiple.
  void round_up_to(int multiple);

  /// Sum of the segments' lengths, each in the metric in which it is longest.
  double longest_sum() const { return longest_sums().back(); }

  /// Place the nodes anew with one segment more or less; with one more where that fails.
  void change_count(int by);

  const Parameters& parameters() const { return parameters_; }
  void set_parameters(Parameters parameters) { parameters_ = std::move(parameters); }

  std::size_t segment_count() const { return parameters_[selected_].size() - 1; }

  /// A node as a use sees it.
  Uv uv(std::size_t use, std::size_t node) const {
    return contour_.uses[use].curve->evaluate(parameters_[use][node]);
  }

  ContourNodes nodes() const;

  /// Queries of the metric fields so far.
  QueryCounts queries() const;

 private:
  void measure(const ContourUse& use, const MetricField& field);
  void step();
  double on_use(std::size_t use, double t) const;
  void append(double t);
  void spread(const std::vector<double>& sums, long count);
  bool is_increasing() const;
  double longest(std::size_t i) const;
  std::vector<double> longest_sums() const;
  void halve_longest();
  bool can_halve(std::size_t i, double shortest) const;
  void halve(std::size_t i);

  template <class IsHalved>
  void halve_where(IsHalved is_halved);

  const Model& model_;
  const Contour& contour_;
  const RunContext& context_;
  std::size_t steps_ = 0;        ///< since the context was asked
  std::vector<MetricArc> arcs_;  ///< by use
  std::size_t selected_ = 0;
  Parameters parameters_;
};

}  // namespace surfmesh
