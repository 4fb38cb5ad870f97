// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "support/tiled_model.hh"
#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/assemble/vertex_copies.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/shared_vertices.hh"
#include "surfmesh/patch/mesh_patch.hh"
#include "surfmesh/patch_mesh/improper_chords.hh"
#include "surfmesh/pieces/shared_numbers.hh"
#include "surfmesh/pieces/tile_part.hh"
#include "surfmesh/quad/improper_quads.hh"

/// Models as tiles that are meshed, for the tests of pieces.
namespace surfmesh::testing {

struct TiledCase {
  std::string name;
  MakeModel model;
  double size;
  double most = 0;  ///< triangles of a tile; 0 leaves patches whole
  bool has_quads = false;
};

inline void PrintTo(const TiledCase& a, std::ostream* out) { *out << a.name; }

inline Model inwards_sphere() {
  Model model = sphere_of(1);
  model.patches[0].is_reversed = true;
  return model;
}

/// All kinds of patches: with holes, seams, poles, turned ones, and where a half-edge mesh has
/// copies of vertices; whole and in tiles, of triangles and of quads.
inline std::vector<TiledCase> tiled_cases() {
  const std::vector<TiledCase> models = {
      {"Square", unit_square, 0.06},
      {"SquareWithAHole", [] { return square_with_hole(0.4); }, 0.12},
      {"OppositeSquares", opposite_squares, 0.08},
      {"ThreeSquares", three_squares, 0.1},
      {"Sphere", [] { return sphere_of(1); }, 0.2},
      {"SphereInwards", inwards_sphere, 0.2},
      {"SphereOfThree", [] { return sphere_of(3); }, 0.2},
      {"Torus", [] { return torus_of(1); }, 0.4},
      {"TorusOfTwo", [] { return torus_of(2); }, 0.4},
      {"Cone", [] { return cone_of(1); }, 0.12},
      {"MobiusBand", mobius_band, 0.1}};
  std::vector<TiledCase> cases;
  for (const bool has_quads : {false, true}) {
    for (const double most : {0.0, 100.0}) {
      for (TiledCase a : models) {
        a.name += has_quads ? "OfQuads" : "";
        a.name += most > 0 ? "InTiles" : "";
        a.most = most;
        a.has_quads = has_quads;
        cases.push_back(std::move(a));
      }
    }
  }
  return cases;
}

/// Those without a contour along which a half-edge mesh has to be cut.
inline std::vector<TiledCase> orientable_cases() {
  std::vector<TiledCase> cases = tiled_cases();
  std::erase_if(cases, [](const TiledCase& a) { return a.name.starts_with("MobiusBand"); });
  return cases;
}

/// A model in tiles that can be meshed.
class MeshedTiles {
 public:
  explicit MeshedTiles(const TiledCase& a)
      : tiled(a.model(), sizes_of(a.size), {.most = a.most, .multiple = a.has_quads ? 2 : 1}),
        has_quads_(a.has_quads) {
    for (const Tiles& of_patch : tiled.of_patches) {
      tiles.insert(tiles.end(), of_patch.tiles.begin(), of_patch.tiles.end());
    }
    is_turned = orient_patches(tiled.model).is_turned;
  }

  /// The results of all tiles by themselves: the same each time.
  std::vector<PatchResult> results() const {
    std::vector<PatchResult> made;
    for (const Tile& tile : tiles) {
      const auto p = static_cast<std::size_t>(tile.boundary.patch);
      made.push_back(mesh_patch({.surface = *tiled.model.patches[p].surface,
                                 .field = tiled.fields[p],
                                 .boundary = tile.boundary,
                                 .quads = {.is_on = has_quads_}}));
    }
    return made;
  }

  /// Their meshes, proper together.
  std::vector<PatchMesh> meshes() const {
    std::vector<PatchMesh> made;
    for (PatchResult& result : results()) made.push_back(std::move(result.mesh));
    std::vector<const MetricField*> fields;
    for (const FunctionField& field : tiled.fields) fields.push_back(&field);
    if (has_quads_) {
      mend_improper_quads(made, tiled.model, fields);
    } else {
      split_improper_chords(made, tiled.model, fields);
    }
    return made;
  }

  std::vector<TilePart> parts() const {
    std::vector<TilePart> made;
    for (PatchMesh& mesh : meshes()) {
      const bool turned = is_turned[mesh.patch()] != 0;
      made.push_back(part_of(surveyed(std::move(mesh), tiled.numbers, turned), number_count()));
    }
    return made;
  }

  PolyMesh assembled() const {
    PolyMesh mesh;
    assemble(mesh, tiled.model, tiled.nodes, tiled.numbers, meshes());
    mark_copies(mesh, tiled.model);
    return mesh;
  }

  /// All that is known of shared vertices if tiles are dealt to pieces.
  SharedNumbers shared(const std::vector<int>& piece_of,
                       const std::vector<int>& rank_of_piece) const {
    std::vector<const PatchBoundary*> boundaries;
    for (const Tile& tile : tiles) boundaries.push_back(&tile.boundary);
    return {tiled.model, tiled.nodes, tiled.numbers, boundaries, piece_of, rank_of_piece};
  }

  SharedNumbers shared() const { return shared(std::vector<int>(tiles.size(), 0), {0}); }

  int number_count() const { return tiled.numbers.count(); }

  TiledModel tiled;
  std::vector<Tile> tiles;  ///< of all patches
  std::vector<char> is_turned;

 private:
  bool has_quads_;
};

/// The position of a vertex of a part, as the result has it.
inline Vec3 point_of(const TilePart& part, int vertex, const SharedNumbers& shared) {
  const auto v = static_cast<std::size_t>(vertex);
  const bool is_on_contour = v < part.shared.size() && shared.is_on_contour(part.shared[v]);
  return is_on_contour ? shared.point(part.shared[v]) : part.points[v];
}

}  // namespace surfmesh::testing
