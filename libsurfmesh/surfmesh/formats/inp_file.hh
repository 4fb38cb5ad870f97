// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// Shells for Abaqus and CalculiX, to be included in an analysis: S3 and S4 elements, numbered
/// patch by patch.
///
/// Each patch with elements is an element set of its name ("PATCH_3" for the third one without), so
/// is each group, and each named contour is a node set. Names become words of letters, digits, _
/// and -, which differ in more than case; comments have them as they were. The element set SURFACE
/// has all elements. Coordinates have up to 20 characters, the width that CalculiX reads: that are
/// all digits of most, and otherwise 14 or more.
MeshFormat inp_format();

}  // namespace surfmesh
