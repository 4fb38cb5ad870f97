// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "surfmesh/formats/grid_file.hh"
#include "surfmesh/sizes/background_sizes.hh"

namespace surfmesh {

/// Make a background mesh of a grid, whose faces are divided into triangles.
///
/// The values are those with this name, or the only ones if it is empty. One number is a size. Six
/// or nine are a metric; nine must be symmetric. Three are xx, xy, yy of a metric in (u,v), and
/// four its rows; in space, three are only a metric of medit in two dimensions, whose lengths
/// across the plane are the mean of those in it.
///
/// Throws   InvalidInput for other values, naming those that are there
BackgroundMesh background_mesh(const GridFile& grid, const std::string& values, BackgroundIn in);

/// Read a background mesh from a .msh, .vtu, .mesh, .meshb, .sol or .solb file.
///
/// Throws   as read_grid and background_mesh, naming the file
BackgroundMesh read_background(const std::filesystem::path& path, const std::string& values = {},
                               BackgroundIn in = BackgroundIn::Space);

}  // namespace surfmesh
