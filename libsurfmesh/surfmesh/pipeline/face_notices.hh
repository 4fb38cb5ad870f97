// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/core/notice.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pipeline/report.hh"

namespace surfmesh::detail {

/// A face that a notice names.
struct ToldFace {
  int patch = -1;
  std::optional<Vec3> middle;
  bool is_at_contour = false;
};

/// The faces that notices name, where there are such.
struct ToldFaces {
  std::optional<ToldFace> worst;  ///< triangle
  std::optional<ToldFace> worst_quad, worst_quad_in_space;
  std::optional<ToldFace> triangle;  ///< any one
};

/// Find them in a mesh, by the statistics of its report.
ToldFaces told_faces(const PolyMesh& mesh, const Report& report);

/// What is wrong with faces of a mesh, by the figures of its report: flat triangles and quads,
/// quads that are inverted or folded, triangles among quads.
Notices notices_of_faces(const Model& model, const Report& report, const ToldFaces& faces);

}  // namespace surfmesh::detail
