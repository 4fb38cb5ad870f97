// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"

namespace surfmesh {

/// What the elements of a mesh are coloured by in pictures and pages, and what files for viewers
/// hold of them.
enum class MeshField { Patch, Group, Quality, Shape, Size, Stretch, Length, Valence, Sag };

/// What has a value of a field.
enum class FieldOf { Faces, Vertices };

/// A field by its name in options and files.
struct FieldDescription {
  MeshField field;
  std::string_view name;  ///< "quality"
  std::string_view text;  ///< "quality in the metric, 1 is best"
  FieldOf of = FieldOf::Faces;
  bool is_category = false;  ///< values are indices with names, not amounts
};

/// All fields, in the order of MeshField.
std::span<const FieldDescription> mesh_fields();

/// Its row among mesh_fields().
const FieldDescription& describe(MeshField field);

/// The field of a name.
/// Throws   InvalidInput, with the names that there are
const FieldDescription& find_mesh_field(std::string_view name);

/// True if a mesh has what the field is measured from.
///
/// Reads    surf:patch, surf:sag (face), surf:uv, surf:metric (halfedge), all optional
/// Cost     O(corners) for fields of the metric, else O(1)
bool has_field(const PolyMesh& mesh, const MeshNames& names, MeshField field);

/// Measure a field, by the index of its faces or vertices; NaN where there is no value.
///
/// patch     index of the patch
/// group     index in the names of the first group of the patch; NaN for none
/// quality   of triangles in the metric (triangle_qualities), of quads the scaled Jacobian there
/// shape     of triangles in space, of quads the scaled Jacobian there: 1 is best; NaN for others
/// size      side of an equilateral triangle, or of a square, that has the area the metric asks
///           for, model units
/// stretch   ratio of the two sizes that the metric asks for, at least 1
/// length    metric length of the side that is farthest from 1, by ratio
/// valence   number of edges at a vertex
/// sag       distance from the surface, model units, where a run measured it
///
/// Error    size and stretch are taken with the flat face for the surface
/// Cost     O(corners), at most 0.2 µs a face
/// Throws   MissingProperty where has_field is false
std::vector<double> measure_field(const PolyMesh& mesh, const MeshNames& names, MeshField field);

}  // namespace surfmesh
