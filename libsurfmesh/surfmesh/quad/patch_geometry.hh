// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "surfmesh/core/properties.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/quad/quad_geometry.hh"

namespace surfmesh {

/// The geometry of the quads of one patch, in its (u,v). Vertices of the boundary stay where they
/// are.
///
/// Reads, writes  surf:uv, surf:metric (vertex)
class PatchGeometry : public QuadGeometry {
 public:
  /// The first `fixed` vertices are those of the boundary. Mesh and field must outlive this.
  PatchGeometry(PolyMesh& mesh, const MetricField& field, std::size_t fixed);

  bool is_free(VertexHandle vh) const override { return index(vh) >= fixed_; }
  bool collect(VertexHandle vh, std::vector<CornerTerms>& star) const override;
  bool move(VertexHandle vh, ChartStep step) override;
  void put_between(VertexHandle vh, std::span<const VertexHandle> others) override;
  FaceMeasure measure(FaceHandle fh) const override;
  void begin_trial() override { is_trial_ = true; }
  void keep_trial() override;
  void undo_trial() override;

  Metric metric_at(Uv uv) { return field_.at(uv, hint_); }

  /// Queries of the metric field so far.
  const QueryCounts& queries() const { return hint_.answers; }

 protected:
  struct Place {
    Uv uv;
    Metric metric;
  };

  void set(VertexHandle vh, const Place& place);

 private:
  double density(VertexHandle vh) const { return densities_[index(vh)]; }
  bool put(VertexHandle vh, Uv uv);
  std::optional<Metric> find_metric(Uv uv);
  bool is_in_bounds(Uv uv) const;

  PolyMesh& mesh_;
  const MetricField& field_;
  decltype(keys::vertex_uv)::Handle uv_;
  decltype(keys::vertex_metric)::Handle metric_;
  std::size_t fixed_;
  Uv lower_, upper_;               ///< of the boundary
  std::vector<double> densities_;  ///< √det M by vertex
  QueryHint hint_;
  bool is_trial_ = false;
  std::vector<std::pair<VertexHandle, Place>> before_;  ///< places that a trial has changed
};

}  // namespace surfmesh
