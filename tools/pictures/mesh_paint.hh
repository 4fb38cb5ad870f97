// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pictures/picture_key.hh"
#include "pictures/scene.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/quality/mesh_field.hh"

namespace surfmesh {

/// The colours of a mesh, and what they mean.
struct PaintedMesh {
  MeshPaint paint;
  PictureKey key;
};

/// Colour a mesh by a field, or in one colour without one.
///
/// The scale of amounts is that of the faces that are shown, by their index, and of all vertices.
///
/// Throws   as measure_field
PaintedMesh paint_mesh(const PolyMesh& mesh, const MeshNames& names, std::optional<MeshField> field,
                       const std::vector<char>& shown, const Rgb& plain);

}  // namespace surfmesh
