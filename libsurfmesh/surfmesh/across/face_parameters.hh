// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/across/vertex_chart.hh"

namespace surfmesh {

/// A vertex as a patch sees it.
struct InPatch {
  int patch = -1;
  Uv uv;
  Metric metric;
};

/// A face with its corners in the parameters of one patch.
struct FaceInPatch {
  int patch = -1;
  std::array<Uv, 4> uvs;
  std::array<Metric, 4> metrics;
  std::array<bool, 4> is_beyond{};  ///< the corner does not lie on the patch
};

/// A corner of a face: its vertex, and what patches it lies on.
struct FaceCornerSites {
  const VertexChart* chart = nullptr;
  std::vector<InPatch> sites;
  bool is_singular = false;  ///< at a singular point, where (u,v) has no metric
};

/// Puts faces whose vertices lie on several patches into the parameters of one of them.
///
/// That is the patch on which most of the corners lie, the first one of several. The (u,v) of other
/// corners go on beyond its domain as its tangent planes at the corners on the patch do, in the
/// mean. The metric of a corner whose vertex has its chart on another patch is the one that sees
/// the sides of the face as the vertex does: so lengths, areas and angles are those in space, by
/// which the face was improved. Likewise the metric at a singular point of the surface, where (u,v)
/// has none. No surface is evaluated but for the charts of vertices on contours.
class FaceParameters {
 public:
  explicit FaceParameters(const ChartMaker& maker) : maker_(maker) {}

  /// The face of three or four corners, each with at least one site.
  FaceInPatch find(std::span<const FaceCornerSites> corners) const;

  /// Let each corner of a face see its sides as the vertex does.
  /// Returns  false if the face is somewhere not as convex in (u,v) as it is to the vertex
  bool set_metrics(std::span<const FaceCornerSites> corners, FaceInPatch& face) const;

 private:
  /// A corner on the patch of the face.
  struct Anchor {
    std::size_t corner = 0;
    VertexChart chart;
  };

  struct Attempt {
    FaceInPatch face;
    bool is_found = false;
  };

  Attempt find_on(int patch, std::span<const FaceCornerSites> corners) const;
  FaceInPatch flattened(int patch, std::span<const FaceCornerSites> corners,
                        FaceInPatch face) const;
  bool set_metric(std::span<const FaceCornerSites> corners, std::size_t k, FaceInPatch& face) const;
  std::vector<Anchor> anchors_on(int patch, std::span<const FaceCornerSites> corners) const;
  const InPatch* site_beside(const Anchor& anchor, const FaceCornerSites& corner) const;

  const ChartMaker& maker_;
};

}  // namespace surfmesh
