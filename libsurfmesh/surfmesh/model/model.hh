// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

struct Cage;

/// A contour as one patch sees it: a curve in that patch's parameters.
struct ContourUse {
  int patch = -1;
  /// t = 0 is the contour's start, t = 1 its end, on every patch.
  std::shared_ptr<const Curve> curve;
  /// True if the patch lies on the left of the contour's direction in its own parameters.
  bool is_forward = true;
  /// True if equal t on this use and on the contour's first use give the same point in space; false
  /// if t has to be found by projection.
  bool is_same_speed = true;
};

/// A curve of the boundary, shared by all patches that meet there; it has one list of nodes.
struct Contour {
  std::string name;
  int start = -1;  ///< vertex
  int end = -1;    ///< vertex; the start again for a closed contour
  std::vector<ContourUse> uses;
  /// True for a side that is one point in space (a pole): start and end are the same vertex.
  bool is_degenerate = false;
  bool is_smooth = true;  ///< false on true boundaries and sharp creases, where normals may jump
  /// The t between the parts it consists of (edges of a cage, spans of a spline), ascending and in
  /// (0,1). Each may hold as much detail as another whole contour: sample every part.
  std::vector<double> breaks = {};
  /// True for one that was given by name, as trims are, that loops name, or along which sizes are
  /// asked for: a line that the user wants to see in the mesh, be it smooth or not.
  bool is_named = false;
  /// How far its curves may be from each other and from its vertices, model units. 0 is 1e-6 of the
  /// diagonal; files of CAD programs bring tolerances of their own.
  double tolerance = 0;

  int part_count() const { return static_cast<int>(breaks.size()) + 1; }
};

/// One contour use of a loop, as indices into Model::contours and Contour::uses.
struct LoopEntry {
  int contour = -1;
  int use = -1;
};

/// Contour uses end to end with the patch on their left. A use that is not forward is traversed
/// from its end to its start.
using PatchLoop = std::vector<LoopEntry>;

/// A piece of surface with its boundary.
struct Patch {
  std::string name;
  std::shared_ptr<const Surface> surface;
  std::vector<PatchLoop> loops;  ///< the outer loop first, then the holes
  /// Faces of the cage that the patch covers, completely or in part; ascending.
  std::vector<int> cage_faces = {};
  /// The cage as given, whose faces these are; null if there is none.
  std::shared_ptr<const Cage> cage = {};
  /// True if the cage is a mesh whose points the surface passes through, so that its faces are
  /// facets of the surface.
  bool is_interpolating = false;
  /// Where it is given (a file, or a file and a JSON pointer), for messages; empty if in C++.
  std::string origin = {};
  /// True if the outside of the model is where p_u × p_v does not point. Patches that are joined
  /// are oriented alike; where these flags differ, most of them decide.
  bool is_reversed = false;
  /// The number of the solid whose boundary it is a part of, with is_reversed as that has it; -1
  /// for none. Decides which patches are joined where more than two meet, see joined_uses.
  int solid = -1;
};

/// A point where contours end.
struct ModelVertex {
  Vec3 position = Vec3::Constant(kUnset);
  /// How far ends of contours may be from it, model units; 0 as for Contour::tolerance.
  double tolerance = 0;
};

/// An option by which a model, or a part of it, was made.
struct MadeWith {
  std::string option;     ///< its name, as for set_option
  std::string value;      ///< as for set_option
  std::string part = {};  ///< what the names of its patches begin with ("knob:"); empty for all

  friend bool operator==(const MadeWith&, const MadeWith&) = default;
};

/// How near the surface of a part keeps to the mesh that it interpolates, and how smooth it is.
struct SurfaceFit {
  std::string part = {};     ///< what the names of its patches begin with; empty for all
  std::size_t vertices = 0;  ///< that it interpolates
  double fit = 0;            ///< how far it was allowed to stay from them, model units
  double distance = 0;  ///< greatest one of a vertex from its point of the surface, model units
  double mean_distance = 0;  ///< root of the mean square of these distances
  double greatest_move = 0;  ///< of a point of the cage from its vertex, model units
  int moved_vertex = -1;     ///< that of the greatest move
  std::size_t creases = 0;   ///< edges that became creases by their angle
  std::size_t corners = 0;   ///< vertices that became corners by the angle of lines
  double wavy_share = 0;  ///< of the edges without creases: the surface turns more than the faces
  double greatest_wave = 0;  ///< by which it turns more, degrees
  double noisy_share = 0;    ///< of the inner vertices: the faces zigzag there

  friend bool operator==(const SurfaceFit&, const SurfaceFit&) = default;
};

/// Patches and the contours and vertices they share.
///
/// The accessors expect indices within the model; check() verifies those of the model itself.
struct Model {
  std::vector<ModelVertex> vertices;
  std::vector<Contour> contours;
  std::vector<Patch> patches;
  std::vector<Group> groups;
  Eigen::AlignedBox3d box;  ///< of the cage's used points, or of samples of the patches
  double diagonal = 0;      ///< of the box
  double joining = 0;       ///< sides nearer than this are one contour, model units
  Notices notices;          ///< from its construction
  /// The options of CageOptions and JoinOptions that it was made with, where they are not the
  /// defaults. Those options do nothing afterwards, so mesh_model warns of others.
  std::vector<MadeWith> made_with = {};
  std::vector<SurfaceFit> fits = {};  ///< of its parts that interpolate a mesh

  const Contour& contour(int index) const { return contours[static_cast<std::size_t>(index)]; }
  const Contour& contour(const LoopEntry& entry) const { return contour(entry.contour); }
  const ContourUse& use(const LoopEntry& entry) const {
    return contour(entry).uses[static_cast<std::size_t>(entry.use)];
  }
  const Patch& patch(int index) const { return patches[static_cast<std::size_t>(index)]; }
  const Patch& patch(const ContourUse& use) const { return patch(use.patch); }
  const Surface& surface(int patch_index) const { return *patch(patch_index).surface; }
  const Surface& surface(const ContourUse& use) const { return surface(use.patch); }

  /// The position of a vertex.
  const Vec3& position(int vertex) const {
    return vertices[static_cast<std::size_t>(vertex)].position;
  }

  /// The point of a contour in space, on the patch of a use.
  Vec3 point(const ContourUse& use, double t) const {
    return surface(use).evaluate(use.curve->evaluate(t), Order::Position).point;
  }

  Contour& contour(int index) { return contours[static_cast<std::size_t>(index)]; }
  ContourUse& use(const LoopEntry& entry) {
    return contour(entry.contour).uses[static_cast<std::size_t>(entry.use)];
  }
  Patch& patch(int index) { return patches[static_cast<std::size_t>(index)]; }
};

/// A patch for messages: "patch wing", after its origin if it has one.
std::string label(const Patch& patch);

/// The names of the patches and contours, and the groups that have patches. Groups of the same name
/// become one. They are in the order of their first patch.
MeshNames mesh_names(const Model& model);

/// The index of the contour of a name; -1 if there is none.
int find_contour(const Model& model, std::string_view name);

/// The index of the patch of a name.
///
/// Throws   InvalidInput if there is none, with the name that was probably meant
int find_patch(const Model& model, std::string_view name);

/// The indices of the patches of a group, ascending; of all groups that have the name.
///
/// Throws   InvalidInput if there is none, with the name that was probably meant
std::vector<int> find_group(const Model& model, std::string_view name);

/// How far the ends of two contours that follow each other in a loop may be apart in space: 1e-6 of
/// the diagonal, or the tolerances of both and of the vertex between them.
double allowed_gap(const Model& model, const Contour& before, const Contour& after);

/// The greatest tolerance of contours and vertices, model units; 0 if none has one.
double greatest_tolerance(const Model& model);

/// Check that all indices are valid, and that patches and uses have surfaces and curves.
///
/// Throws   InvalidInput, naming the patch or the contour
void check_indices(const Model& model);

/// Check that indices are valid, that the diagonal is between 1e-70 and 1e70 and no less than 1e-11
/// of the distance from the origin, and that all loops close in space, to 1e-6 of the diagonal or
/// the tolerances of the model, if those are greater.
///
/// Throws   InvalidInput or Geometry, naming the patch and the contour
/// Cost     O(contour uses), two surface evaluations each
void check(const Model& model);

}  // namespace surfmesh
