// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unordered_map>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/cage/cage_surface.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// The face of a cage that a point of a result lies on, and the shares of its corners there.
struct CageShares {
  const Cage* cage = nullptr;  ///< null on a patch of no cage
  int face = -1;
  std::vector<double> weights;  ///< by the corners of the face as given, with the sum 1
};

/// Finds the places of a result on the cages of its model.
///
/// A corner of a face of the result lies on the face of the cage that its own face has there: where
/// contours separate two faces of a cage, each side has its own. So seams stay where contours were
/// kept. Where a face of the result lies across an edge of the cage, its corners are on the faces
/// on both sides.
class ResultPlaces {
 public:
  /// Mesh and model must outlive this.
  ///
  /// Reads    surf:patch (face), surf:uv (halfedge), surf:beyond (halfedge; optional)
  /// Cost     none, unless a vertex is on no patch of its faces: then a few evaluations a contour,
  ///          and of surfaces where such vertices are hard to find
  /// Throws   MissingProperty; InvalidInput for a patch that the model does not have
  ResultPlaces(const PolyMesh& result, const Model& model);

  /// Where a vertex lies; on the border of two faces of the cage, on one of them.
  ///
  /// Cost     0.2 µs; in regions of faces, four evaluations of a face
  CageShares of_vertex(VertexHandle vertex) const;

  /// Where a corner lies, seen from its face; `corner` is the halfedge that leads to it, in a face.
  ///
  /// Error    rounding; where the surface of a patch is not made of single faces, 1e-12 of these,
  /// and
  ///          1e-9 in regions
  /// Cost     0.3 µs, in regions of faces eight evaluations of a face; an evaluation more where the
  /// face lies across the contour at the corner
  CageShares of_corner(HalfedgeHandle corner) const;

 private:
  struct PatchPoint {
    int patch = -1;
    Uv uv;

    friend bool operator==(const PatchPoint&, const PatchPoint&) = default;
  };

  /// A point of a patch, and the step in its parameters to the middle of a face.
  struct Start {
    PatchPoint place;
    Uv inward{0, 0};
  };

  int patch_of(HalfedgeHandle corner) const;
  Uv middle_of(FaceHandle face) const;
  bool is_beyond(HalfedgeHandle corner) const;
  bool is_on_patch(VertexHandle vertex) const;
  void find_vertices_on_no_patch();
  std::vector<PatchPoint> places_of(VertexHandle vertex) const;
  Start start_at(HalfedgeHandle corner) const;
  Uv step_to(const PatchPoint& from, const Vec3& point) const;
  bool stays_inside(const Start& start) const;
  CagePlace place_at(int patch, Uv uv) const;
  CageShares shares_at(int patch, const CagePlace& place) const;

  const PolyMesh& mesh_;
  const Model& model_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  decltype(keys::corner_beyond)::Handle beyond_;
  std::unordered_map<int, PatchPoint> found_;  ///< of vertices on no patch of their faces
};

}  // namespace surfmesh
