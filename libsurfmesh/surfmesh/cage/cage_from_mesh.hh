// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// Where a tag of the elements of a mesh comes from: nowhere, the property of that name, or a
/// function.
template <class Handle, class Value>
using ElementTag = std::variant<std::monostate, std::string, std::function<Value(Handle)>>;

/// Where cage_from_mesh finds the subdivision tags.
struct CageFromMeshOptions {
  /// Sharpness of edges: 0 (smooth) or more, infinite from 10; properties of double or float.
  ElementTag<OpenMesh::EdgeHandle, double> creases = {};
  /// Sharpness of vertices, likewise.
  ElementTag<OpenMesh::VertexHandle, double> corners = {};
  /// Faces that are left out of the surface but shape it; properties of bool, char or int: not 0.
  ElementTag<OpenMesh::FaceHandle, bool> holes = {};
  BoundaryRule boundary = BoundaryRule::EdgeOnly;  ///< at the boundary of the mesh
  bool is_chaikin = false;           ///< crease method for sharpness that changes along a crease
  bool is_smooth_triangles = false;  ///< of Catmull-Clark, for cages with many triangles
};

namespace detail {

inline const char* element_name(OpenMesh::VertexHandle) { return "vertex"; }
inline const char* element_name(OpenMesh::EdgeHandle) { return "edge"; }
inline const char* element_name(OpenMesh::FaceHandle) { return "face"; }

/// "edge 7 of the mesh", for messages.
template <class Handle>
std::string element_in_mesh(Handle handle) {
  return std::string(element_name(handle)) + " " + std::to_string(handle.idx()) + " of the mesh";
}

/// A function that reads the property of that name, of the first type T that the mesh has it with.
/// Throws   MissingProperty, naming it, if there is none
template <class Value, class T, class... More, class Mesh, class Handle>
std::function<Value(Handle)> property_reader(const Mesh& mesh, const std::string& name, Handle) {
  typename OpenMesh::PropHandle<Handle>::template type<T> property;
  if (mesh.get_property_handle(property, name)) {
    return [&mesh, property](Handle handle) {
      return static_cast<Value>(mesh.property(property, handle));
    };
  }
  if constexpr (sizeof...(More) > 0) {
    return property_reader<Value, More...>(mesh, name, Handle());
  } else {
    throw Error(
        ErrorCode::MissingProperty,
        std::string("the mesh has no ") + element_name(Handle()) + " property " + name +
            (std::is_same_v<Value, bool> ? " of bool, char or int" : " of double or float"));
  }
}

/// The tag as a function, empty for no tag.
template <class Value, class... Types, class Mesh, class Handle>
std::function<Value(Handle)> reader_of(const Mesh& mesh, const ElementTag<Handle, Value>& tag) {
  if (const auto* name = std::get_if<std::string>(&tag)) {
    return property_reader<Value, Types...>(mesh, *name, Handle());
  }
  const auto* function = std::get_if<std::function<Value(Handle)>>(&tag);
  return function ? *function : nullptr;
}

/// Collects a cage from a mesh, element by element. Deleted elements get no number.
template <class Mesh>
class CageCollector {
 public:
  explicit CageCollector(const Mesh& mesh) : mesh_(mesh) {}

  Cage collect(const CageFromMeshOptions& options) {
    const auto crease = reader_of<double, double, float>(mesh_, options.creases);
    const auto corner = reader_of<double, double, float>(mesh_, options.corners);
    const auto hole = reader_of<bool, bool, char, int>(mesh_, options.holes);
    for (const auto vh : mesh_.all_vertices()) add(vh, corner);
    for (const auto eh : mesh_.all_edges()) add(eh, crease);
    for (const auto fh : mesh_.all_faces()) add(fh, hole);
    if (cage_.faces.empty()) throw Error(ErrorCode::InvalidInput, "the mesh has no faces");
    cage_.boundary = options.boundary;
    cage_.is_chaikin = options.is_chaikin;
    cage_.is_smooth_triangles = options.is_smooth_triangles;
    return std::move(cage_);
  }

 private:
  void add(OpenMesh::VertexHandle vh, const std::function<double(OpenMesh::VertexHandle)>& corner) {
    numbers_.push_back(-1);
    if (mesh_.has_vertex_status() && mesh_.status(vh).deleted()) return;
    numbers_.back() = static_cast<int>(cage_.points.size());
    const auto& p = mesh_.point(vh);
    cage_.points.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]),
                              static_cast<double>(p[2]));
    if (!cage_.points.back().allFinite()) {
      throw Error(ErrorCode::InvalidInput, element_in_mesh(vh) + ": its position is not finite");
    }
    const double sharpness = sharpness_of(vh, corner);
    if (sharpness > 0) cage_.corners.push_back({numbers_.back(), sharpness});
  }

  void add(OpenMesh::EdgeHandle eh, const std::function<double(OpenMesh::EdgeHandle)>& crease) {
    if (mesh_.has_edge_status() && mesh_.status(eh).deleted()) return;
    const double sharpness = sharpness_of(eh, crease);
    if (!(sharpness > 0)) return;
    const auto heh = mesh_.halfedge_handle(eh, 0);
    cage_.creases.push_back(
        {{number(mesh_.from_vertex_handle(heh)), number(mesh_.to_vertex_handle(heh))}, sharpness});
  }

  void add(OpenMesh::FaceHandle fh, const std::function<bool(OpenMesh::FaceHandle)>& hole) {
    if (mesh_.has_face_status() && mesh_.status(fh).deleted()) return;
    std::vector<int>& face = cage_.faces.emplace_back();
    for (auto v = mesh_.cfv_ccwbegin(fh); v != mesh_.cfv_ccwend(fh); ++v)
      face.push_back(number(*v));
    if (hole && hole(fh)) cage_.holes.push_back(static_cast<int>(cage_.faces.size()) - 1);
  }

  template <class Handle>
  double sharpness_of(Handle handle, const std::function<double(Handle)>& tag) const {
    const double sharpness = tag ? tag(handle) : 0;
    if (!(sharpness >= 0)) {
      throw Error(ErrorCode::InvalidInput, element_in_mesh(handle) + ": its sharpness is " +
                                               std::to_string(sharpness) + ", not 0 or more");
    }
    return sharpness;
  }

  int number(OpenMesh::VertexHandle vh) const { return numbers_[index(vh)]; }

  const Mesh& mesh_;
  Cage cage_;
  std::vector<int> numbers_;  ///< vertex of the cage by vertex of the mesh, -1 for none
};

}  // namespace detail

/// Make a cage from an OpenMesh mesh: a TriMesh_ArrayKernelT or PolyMesh_ArrayKernelT with any
/// traits, whose points have three coordinates of any type.
///
/// Vertices and faces keep their order, and each face keeps its first vertex. Deleted elements are
/// left out, so those after them get smaller numbers. Otherwise numbers are those of the mesh, also
/// in Patch::cage_faces.
///
/// Reads    the properties that the options name
/// Units    positions are in model units and are not changed
/// Cost     O(elements), one function call each
/// Throws   InvalidInput for no faces, a position that is not finite, a sharpness that is negative
///          or NaN, naming the element; MissingProperty, naming the property
template <class Mesh>
Cage cage_from_mesh(const Mesh& mesh, const CageFromMeshOptions& options = {}) {
  static_assert(OpenMesh::vector_traits<typename Mesh::Point>::size_ == 3,
                "a cage lies in space: points need three coordinates");
  return detail::CageCollector<Mesh>(mesh).collect(options);
}

}  // namespace surfmesh
