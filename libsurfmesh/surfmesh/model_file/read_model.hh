// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// A cage that a model file names.
struct CageInput {
  std::string name;
  std::filesystem::path file;
  Scheme scheme = Scheme::Auto;
  PatchKind patches = PatchKind::Auto;
  std::string origin;  ///< JSON pointer
};

/// A source of sizes in all patches of a group.
struct GroupSource {
  std::string group;  ///< a group of a cage's file, a cage, or a patch
  Size size;
  std::string origin;  ///< JSON pointer
};

/// A source of sizes along a contour or side, in the patch that names it.
struct AlongContour {
  int patch = -1;
  std::string contour;
  LocalSize wish;
  std::string origin;  ///< JSON pointer
};

/// An entry of `sizing` or `options`; only the pipeline knows what options there are.
struct FileOption {
  std::string name;
  std::string value;  ///< JSON text
  bool is_in_sizing = false;
  std::string origin;  ///< JSON pointer
};

/// What a model file holds.
struct ModelFile {
  std::vector<PatchInput> patches;  ///< formula surfaces on rectangles, with their loops
  std::vector<ContourInput> contours;
  std::vector<CageInput> cages;
  Sources sources;                  ///< `patch` is an index into patches
  std::vector<GroupSource> groups;  ///< sources of groups
  std::vector<AlongContour> along_contours;
  std::vector<FileOption> options;  ///< those of `sizing` first, not checked
};

/// Read a model file (JSON).
///
/// Angles are degrees in the file and radians in the result. Domains, constants and the places of
/// `at` may be numbers or constant expressions of the constants before them. Options are taken as
/// they are: load_model reads them.
/// Throws   Io if the file cannot be read; InvalidInput as parse_model
ModelFile read_model(const std::filesystem::path& path);

/// Read a model from JSON text; `name` stands before the place in messages, and cages are relative
/// to its folder. The files of cages are not looked at, those of tables are read.
///
/// Throws   InvalidInput: with name:line:column where the text is not JSON; with the JSON pointer
///          for an unknown, missing or doubled key, a value of the wrong type or outside of its
///          range, a formula that cannot be read, a name that is not known or there twice
ModelFile parse_model(std::string_view text, const std::string& name);

}  // namespace surfmesh
