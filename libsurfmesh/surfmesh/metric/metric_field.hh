// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/core/random_bits.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {

/// How queries of a metric field were answered.
struct QueryCounts {
  std::size_t single = 0;    ///< by V_s
  std::size_t triangle = 0;  ///< by V_t
  std::size_t circles = 0;   ///< by V_o
  std::size_t linear = 0;    ///< linearly in a triangle
  std::size_t lattice = 0;   ///< bilinearly in a cell of a lattice
  std::size_t extended = 0;  ///< by an extended node alone
  std::size_t reused = 0;    ///< by the last answer
  std::size_t walks = 0;     ///< searches for the triangle of a point: no answers by themselves
  std::size_t steps = 0;     ///< from triangle to triangle in all walks

  std::size_t total() const {
    return single + triangle + circles + linear + lattice + extended + reused;
  }
  QueryCounts& operator+=(const QueryCounts& other);
  friend bool operator==(const QueryCounts&, const QueryCounts&) = default;
};

/// What a caller keeps between queries of a metric field. Each caller has its own, so that several
/// threads can query one field.
struct QueryHint {
  int element = -1;  ///< triangle or cell of the last point: a point near it is found fast
  /// True where an answer is used once and not kept, so that the last one may do: see
  /// MetricField::at_unkept().
  bool can_reuse = false;
  RandomBits random;
  Uv last_uv;  ///< where the last answer was computed
  SizeTensor last_size;
  Metric last_metric;
  QueryCounts answers;
  // Scratch space of V_o, kept here so that a query does not allocate: the triangles around a
  // point, their nodes, and the values to average.
  std::vector<int> cavity;
  std::vector<int> cavity_nodes;
  std::vector<SizeTensor> sizes;
  std::vector<double> squared_distances;
};

/// The metric of one patch as the meshing stages see it.
///
/// Queries are const and may come from several threads, each with a hint of its own.
class MetricField {
 public:
  virtual ~MetricField() = default;

  /// Metric at a point of the domain.
  virtual Metric at(Uv uv, QueryHint& hint) const = 0;

  /// The same for an answer that is used once and not kept: it may be that of the last point, if
  /// that is near. Metrics that are kept, compared or summed up would have steps then.
  /// Source   paper, section 4, item 1 (R)
  Metric at_unkept(Uv uv, QueryHint& hint) const {
    hint.can_reuse = true;
    const Metric metric = at(uv, hint);
    hint.can_reuse = false;
    return metric;
  }

  /// The same for a caller that has evaluated the surface there to first order.
  virtual Metric at_jet(Uv uv, const Jet& jet, QueryHint& hint) const {
    static_cast<void>(jet);
    return at(uv, hint);
  }

  /// Points that every mesh must resolve, even among large elements, with their metrics.
  virtual std::span<const MetricCorner> required_points() const { return {}; }
};

}  // namespace surfmesh
