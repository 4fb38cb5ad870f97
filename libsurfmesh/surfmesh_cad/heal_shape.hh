// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/cad_input.hh"
#include "surfmesh_cad/cad_shape.hh"

namespace surfmesh {

/// Take out faces without a surface, and those more than kMostTurns away from its start:
/// OpenCASCADE's own healing would crash, or not end. Tells it as ignored input.
void drop_damaged_faces(CadShape& cad);

/// Sew faces that are in no solid: always with a tolerance given, else if no two faces of the shape
/// are in one shell. Shells that are closed then become solids, or hollows of those around them.
void sew_faces(CadShape& cad, const CadOptions& options);

/// Divide faces and edges of splines where they have corners inside: elements would cut those off.
void divide_at_corners(CadShape& cad);

/// Merge edges shorter than 1e-7 of the diagonal, or than the tolerance of their vertices, and
/// faces as narrow, with their neighbours. What is less closed or less valid than before is not
/// taken.
void merge_small_edges(CadShape& cad);

/// Mend wires, seams and curves of faces, for shapes of which faces cannot be used as they are.
/// Returns  whether anything is different; a notice tells where OpenCASCADE would crash
bool mend_faces(CadShape& cad);

/// The others tell what they did as notices of the kind HealedShape, and keep the facts of faces.

}  // namespace surfmesh
