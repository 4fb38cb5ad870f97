// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>  // targets are of either kind
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <cmath>
#include <string>
#include <type_traits>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace detail {

template <class Handles>
void check_not_deleted(const PolyMesh& result, bool has_status, Handles handles, const char* name) {
  if (!has_status) return;
  for (const auto handle : handles) {
    if (!result.status(handle).deleted()) continue;
    throw Error(ErrorCode::InvalidInput,
                std::string(name) + " " + std::to_string(handle.idx()) +
                    " of the result is deleted; call garbage_collection() first");
  }
}

/// Check, before anything is changed, that a mesh type can hold the faces and positions.
template <class Mesh>
void check_fits(const PolyMesh& result) {
  check_not_deleted(result, result.has_vertex_status(), result.all_vertices(), "vertex");
  check_not_deleted(result, result.has_edge_status(), result.all_edges(), "edge");
  check_not_deleted(result, result.has_face_status(), result.all_faces(), "face");
  using Scalar = typename OpenMesh::vector_traits<typename Mesh::Point>::value_type;
  for (const VertexHandle vh : result.all_vertices()) {
    for (const double x : result.point(vh)) {
      if (std::isfinite(static_cast<double>(static_cast<Scalar>(x)))) continue;
      throw Error(ErrorCode::InvalidInput, "vertex " + std::to_string(vh.idx()) +
                                               " of the result: points of the target cannot hold " +
                                               std::to_string(x));
    }
  }
  if constexpr (Mesh::is_trimesh()) {
    for (const FaceHandle fh : result.all_faces()) {
      const auto corners = result.valence(fh);
      if (corners == 3) continue;
      throw Error(ErrorCode::InvalidInput, "face " + std::to_string(fh.idx()) +
                                               " of the result has " + std::to_string(corners) +
                                               " corners; the target holds triangles only");
    }
  }
}

/// Copy the connectivity, index by index. OpenMesh's own assign_connectivity loses track of the
/// status that the target has requested (test CopyResult.ReplacesWhatTheTargetHeld).
template <class Mesh>
void copy_connectivity(const PolyMesh& result, Mesh& target) {
  target.clear();
  target.resize(result.n_vertices(), result.n_edges(), result.n_faces());
  for (const HalfedgeHandle heh : result.all_halfedges()) {
    target.set_vertex_handle(heh, result.to_vertex_handle(heh));
    target.set_next_halfedge_handle(heh, result.next_halfedge_handle(heh));
    target.set_face_handle(heh, result.face_handle(heh));
  }
  for (const VertexHandle vh : result.all_vertices()) {
    target.set_halfedge_handle(vh, result.halfedge_handle(vh));
  }
  for (const FaceHandle fh : result.all_faces()) {
    target.set_halfedge_handle(fh, result.halfedge_handle(fh));
  }
}

template <class Mesh>
void copy_points(const PolyMesh& result, Mesh& target) {
  using Scalar = typename OpenMesh::vector_traits<typename Mesh::Point>::value_type;
  for (const VertexHandle vh : result.all_vertices()) {
    typename Mesh::Point point;
    for (unsigned k = 0; k < 3; ++k) point[k] = static_cast<Scalar>(result.point(vh)[k]);
    target.set_point(vh, point);
  }
}

/// Copy a property, replacing the one that the target has under this key.
template <class Mesh, class Element, class Value>
void copy_property(const PolyMesh& result, Mesh& target, const PropertyKey<Element, Value>& key) {
  const auto from = require(result, key);
  detach(target, key);
  const auto to = attach(target, key);
  target.property(to).data_vector() = result.property(from).data_vector();
}

/// Those of the cage, if they were asked for, else the parameters; 0 where a corner has none.
template <class Mesh>
void copy_texture_coordinates(const PolyMesh& result, Mesh& target) {
  using TexCoord = typename Mesh::TexCoord2D;
  using Scalar = typename OpenMesh::vector_traits<TexCoord>::value_type;
  const auto texture_of = find(result, keys::corner_texture);
  const auto uv_of = texture_of.is_valid() ? texture_of : require(result, keys::corner_uv);
  for (const HalfedgeHandle heh : result.all_halfedges()) {
    Uv uv = result.is_boundary(heh) ? Uv{0, 0} : result.property(uv_of, heh);
    if (texture_of.is_valid() && std::isnan(uv.u)) uv = {0, 0};
    TexCoord coordinates;
    coordinates[0] = static_cast<Scalar>(uv.u);
    coordinates[1] = static_cast<Scalar>(uv.v);
    target.set_texcoord2D(heh, coordinates);
  }
}

/// Normals of the surface at the corners, in place of those of the triangles.
template <class Mesh>
void copy_corner_normals(const PolyMesh& result, Mesh& target) {
  using Scalar = typename OpenMesh::vector_traits<typename Mesh::Normal>::value_type;
  const auto normal_of = require(result, keys::corner_normal);
  for (const HalfedgeHandle heh : result.all_halfedges()) {
    if (result.is_boundary(heh)) continue;
    const Normal& n = result.property(normal_of, heh);
    target.set_normal(heh, typename Mesh::Normal(static_cast<Scalar>(n.x), static_cast<Scalar>(n.y),
                                                 static_cast<Scalar>(n.z)));
  }
}

/// Vertex and halfedge normals are computed from face normals, which are requested temporarily.
template <class Mesh>
void update_normals(Mesh& target) {
  if (!target.has_face_normals() && !target.has_vertex_normals() &&
      !target.has_halfedge_normals()) {
    return;
  }
  target.request_face_normals();
  target.update_normals();
  target.release_face_normals();
}

}  // namespace detail

/// Copy a result into an OpenMesh mesh of any type: TriMesh_ArrayKernelT or PolyMesh_ArrayKernelT,
/// with points of three numbers of any type and any traits.
///
/// The connectivity is the same: vertices, halfedges, edges and faces have the same indices. The
/// target's elements are replaced. Its own properties stay, but their values are those of new
/// elements.
///
/// Reads    surf:patch (face), surf:contour (edge), surf:uv and surf:metric (halfedge);
///          surf:normal, surf:beyond and surf:texture (halfedge) if they are there
/// Writes   the same, and what the target has requested: texture coordinates of halfedges, from
///          surf:texture if it is there, else from surf:uv, 0 on the boundary's; normals of
///          halfedges, from surf:normal if it is there; other normals, of the triangles
/// Error    none if the target has double points; else positions are rounded to its type
/// Cost     O(elements)
/// Throws   MissingProperty; InvalidInput, naming the element, for a face with more than three
///          corners if the target holds triangles only, and for a position that is not finite in
///          the target's type. In that case the target is unchanged
template <class Mesh>
void copy_result(const PolyMesh& result, Mesh& target) {
  static_assert(OpenMesh::vector_traits<typename Mesh::Point>::size_ == 3,
                "a result lies in space: points need three coordinates");
  if (static_cast<const void*>(&result) == static_cast<const void*>(&target)) return;
  require(result, keys::face_patch);
  require(result, keys::edge_contour);
  require(result, keys::corner_uv);
  require(result, keys::corner_metric);
  detail::check_fits<Mesh>(result);
  detail::copy_connectivity(result, target);
  detail::copy_points(result, target);
  detail::copy_property(result, target, keys::face_patch);
  detail::copy_property(result, target, keys::edge_contour);
  detail::copy_property(result, target, keys::corner_uv);
  detail::copy_property(result, target, keys::corner_metric);
  detach(target, keys::corner_beyond);
  if (find(result, keys::corner_beyond).is_valid()) {
    detail::copy_property(result, target, keys::corner_beyond);
  }
  if (find(result, keys::corner_normal).is_valid()) {
    detail::copy_property(result, target, keys::corner_normal);
  }
  detach(target, keys::corner_texture);
  if (find(result, keys::corner_texture).is_valid()) {
    detail::copy_property(result, target, keys::corner_texture);
  }
  if (target.has_halfedge_texcoords2D()) detail::copy_texture_coordinates(result, target);
  detail::update_normals(target);
  if (target.has_halfedge_normals() && find(result, keys::corner_normal).is_valid()) {
    detail::copy_corner_normals(result, target);
  }
}

}  // namespace surfmesh
