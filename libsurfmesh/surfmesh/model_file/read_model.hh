// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/cage/creases.hh"
#include "surfmesh/io/key_places.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/sizes/background_sizes.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// Edges of a cage that a model file makes a crease: those of a chain of vertices, or those at the
/// border of a group.
struct CreaseInput {
  std::vector<int> vertices = {};  ///< from 0, one after the other along edges
  std::string group = {};
  double sharpness = kSharp;
  std::string origin = {};  ///< JSON pointer
};

/// A cage that a model file names.
struct CageInput {
  std::string name;
  std::filesystem::path file;
  Scheme scheme = Scheme::Auto;
  PatchKind patches = PatchKind::Auto;
  std::optional<Length> weld = {};  ///< 0 is off
  std::optional<bool> orient = {};
  std::optional<double> crease_angle = {};  ///< degrees, 0 is off
  SurfaceKind surface = SurfaceKind::Auto;
  std::optional<Length> fit = {};  ///< 0 is off
  std::vector<CreaseInput> creases = {};
  std::string origin;  ///< JSON pointer
};

/// A STEP, IGES or BREP file that a model file names.
struct CadFileInput {
  std::string name;  ///< may be empty, if there is only one
  std::filesystem::path file;
  std::optional<Length> sew = {};  ///< 0 is off
  std::string origin;              ///< JSON pointer
};

/// Sizes of a background mesh.
struct BackgroundInput {
  std::shared_ptr<const BackgroundSizes> sizes;
  std::optional<double> precision = {};
};

/// A source of sizes in all patches of the model, or in those of a group.
struct SpaceSource {
  std::string group;   ///< a group of a cage's file, a cage, or a patch; empty for all patches
  std::string origin;  ///< JSON pointer
  /// A size everywhere, a field of x, y and z, a place, a box or a background mesh. Their patches
  /// are not set.
  std::variant<Size, FieldSource, NearSource, BoxSource, BackgroundInput> wish;
  int patch = -1;  ///< the one patch where it applies; -1 for those above
};

/// A NURBS patch of a model file that is divided at its creases.
struct DividedPatch {
  std::string name;
  std::vector<int> pieces;  ///< indices of ModelFile::patches
};

/// A source of sizes along a contour or side, in the patch that names it or, if the model does, in
/// all patches there.
struct AlongContour {
  int patch = -1;  ///< -1 for all
  std::string contour;
  LocalSize wish;
  std::string origin;  ///< JSON pointer
};

/// An entry of `sizing` or `options`; only the pipeline knows which options exist.
struct FileOption {
  std::string name;
  std::string value;  ///< JSON text
  bool is_in_sizing = false;
  std::string origin;  ///< JSON pointer
};

/// The contents of a model file.
struct ModelFile {
  /// Formula and NURBS surfaces on rectangles, with their loops; the pieces of divided ones.
  std::vector<PatchInput> patches;
  std::vector<DividedPatch> divided;
  std::vector<ContourInput> contours;
  std::vector<CageInput> cages;
  std::vector<CadFileInput> cad;
  std::vector<std::filesystem::path> tables;  ///< their files, and those of background meshes
  Sources sources;                            ///< `patch` is an index into patches
  std::vector<SpaceSource> space_sources;
  std::vector<AlongContour> along_contours;
  std::vector<FileOption> options;  ///< those of `sizing` first, not checked
};

/// Read a model file (JSON).
///
/// Angles are in degrees in the file and in radians in the result. Domains, constants and the
/// points of `at` may be numbers, or expressions of the constants defined before. Options are kept
/// as text; load_model reads them. A NURBS patch with creases inside becomes several patches that
/// share them, `name[0,0]`, `name[1,0]`, ... along u, then along v. `options` tells where they
/// belong, for messages. Throws   Io if the file cannot be read; InvalidInput as parse_model
ModelFile read_model(const std::filesystem::path& path, const KeyPlaces& options = {});

/// Read a model from JSON text. Messages begin with `name`, and paths of cages are relative to its
/// folder. The files of cages are not read, those of tables are.
///
/// Throws   InvalidInput with name:line:column if the text is not JSON; with the JSON pointer for
///          an unknown, missing or repeated key, a value of the wrong type or out of its range, a
///          formula that cannot be read, a name that is unknown or used twice
ModelFile parse_model(std::string_view text, const std::string& name,
                      const KeyPlaces& options = {});

}  // namespace surfmesh
