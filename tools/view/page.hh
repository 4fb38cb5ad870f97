// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/io/output_file.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/report.hh"

namespace surfmesh {

/// What a page shows. It refers to what its maker owns.
struct PageContents {
  std::string title;       ///< what is shown, as the user called it
  std::string model = {};  ///< the file of the model; empty for none
  const PolyMesh& mesh;    ///< with any of the properties of a result, or none
  const MeshNames& names;
  const Notices& notices;
  const Report* report = nullptr;          ///< of the run that made the mesh; null for none
  const ControlSpaces* control = nullptr;  ///< of all patches; null for none
};

/// Write a page that shows a mesh: one HTML file that needs nothing else, and asks for nothing.
///
/// `script` is that of read_viewer_script. Names and texts stand in the page as JSON in which "<"
/// is escaped: whatever they are, they are never markup.
///
/// Patches have numbers that check_patch_numbers lets pass.
///
/// Reads    surf:patch, surf:sag (face), surf:contour (edge), surf:uv, surf:metric (halfedge), all
///          optional; of the control meshes surf:uv, surf:size, surf:class
/// Cost     about 2 µs and 40 bytes a triangle
/// Throws   Io; Limit where memory runs out
/// Returns  the number of bytes that were written
std::size_t write_page(const PageContents& contents, const std::string& script, OutputFile& file);

}  // namespace surfmesh
