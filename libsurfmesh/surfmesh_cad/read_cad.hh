// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "surfmesh/model/cad_input.hh"

namespace surfmesh {

/// Read a STEP, IGES or BREP file (.step, .stp, .iges, .igs, .brep) with OpenCASCADE.
///
/// Faces become patches, edges contours, whatever their surfaces are. STEP and IGES lengths come
/// out in millimetres, whatever unit the file has; BREP files have no unit. A face has the name
/// that the file gives it, or is called face1, face2, ... in the order of the file, after the name
/// of its part if there are several ("bolt:face3"). Groups are the parts of an assembly, bodies,
/// and colours ("colour #ff0000"). What is sewn, mended or left out is told in the model's notices.
/// How far curves are from each other is measured: it is Contour::tolerance where it counts.
///
/// Files are read one at a time, for OpenCASCADE keeps the options of its readers in variables of
/// the whole program; they are as before afterwards. Its messages are not printed: while a file
/// is read, nothing is by std::cout. It installs no handlers of signals.
///
/// Cost     reading the file takes most of the time; about 30 times its size in memory
/// Throws   Io if the file cannot be read; InvalidInput if it is damaged, of another kind or has
///          no faces; Geometry if no face of it can be used; Limit for one above 512 MB, or if
///          memory runs out
Model read_cad(const std::filesystem::path& path, const CadOptions& options = {});

/// The version of OpenCASCADE that the library was built with: "7.6.3".
std::string cad_version();

}  // namespace surfmesh
