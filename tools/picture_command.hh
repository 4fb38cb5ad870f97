// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "pictures/mesh_picture.hh"

namespace surfmesh {

struct MeshFile;

/// `surfmesh picture`: draw a mesh.
class PictureCommand {
 public:
  /// Add the subcommand to the program. The object must outlive the parsing.
  void add_to(CLI::App& app);

  /// Do what the parsed arguments say. Returns an exit status; prints its errors itself.
  int run() const;

 private:
  void add_view(CLI::App& command);
  void add_style(CLI::App& command);
  PictureOptions options_for(const MeshFile& file) const;
  int draw() const;

  std::string mesh_;
  std::string output_;
  std::string colour_;  ///< empty for what suits the mesh
  std::string plane_;   ///< name or number of a patch; empty for a view in space
  std::string fit_;     ///< patch or group that fills the picture; empty for all
  std::string size_ = "900x600";
  std::vector<double> look_at_;  ///< empty, or a point
  std::string edges_ = "on";
  std::string contours_ = "on";
  std::string key_ = "on";
  std::string up_ = "z";
  std::string background_ = "white";
  double line_width_ = 0;     ///< 0 for what suits the size
  double contour_width_ = 0;  ///< likewise
  bool is_perspective_ = false;
  bool has_ellipses_ = false;
  bool is_quiet_ = false;
  Camera camera_ = {.azimuth = -60, .elevation = 30};
  double zoom_ = 1;
};

}  // namespace surfmesh
