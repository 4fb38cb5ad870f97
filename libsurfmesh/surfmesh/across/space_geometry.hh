// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "surfmesh/across/vertex_chart.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/quad/quad_geometry.hh"

namespace surfmesh {

/// Cosine of the angle between the normals of two corners of a quad beyond which no move leads:
/// elements would leave an edge of the surface that is rounded within less than an element.
inline constexpr double kBentSide = 0.3;

/// The geometry of quads that lie on several patches: in space, with the metrics of their vertices.
/// Vertices at the border of the mesh stay where they are.
class SpaceGeometry : public QuadGeometry {
 public:
  /// `charts` are those of the vertices of the mesh. All must outlive this.
  SpaceGeometry(const PolyMesh& mesh, std::vector<VertexChart>& charts, ChartMaker& maker);

  bool is_free(VertexHandle vh) const override {
    return index(vh) >= is_held_.size() || is_held_[index(vh)] == 0;
  }
  bool may_join(VertexHandle a, VertexHandle b) const override {
    return a != b && (is_free(a) || is_free(b));
  }
  bool collect(VertexHandle vh, std::vector<CornerTerms>& star) const override;
  bool move(VertexHandle vh, ChartStep step) override;
  void put_between(VertexHandle vh, std::span<const VertexHandle> others) override;
  FaceMeasure measure(FaceHandle fh) const override;
  void begin_trial() override { is_trial_ = true; }
  void keep_trial() override;
  void undo_trial() override;

 private:
  const VertexChart& chart(VertexHandle vh) const { return charts_[index(vh)]; }
  bool turns_away(VertexHandle vh, const VertexChart& moved) const;
  void set(VertexHandle vh, const VertexChart& chart);

  const PolyMesh& mesh_;
  std::vector<VertexChart>& charts_;
  ChartMaker& maker_;
  std::vector<char> is_held_;
  bool is_trial_ = false;
  std::vector<std::pair<VertexHandle, VertexChart>> before_;  ///< charts that a trial has changed
};

}  // namespace surfmesh
