// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Prefix of the names of all our properties.
inline constexpr std::string_view kPropertyPrefix = "surf:";

/// The one way to name a mesh property: element, value type and name belong together.
///
/// For one name with two value types, OpenMesh silently makes two properties. It neither copies nor
/// saves names that begin with v:, e:, f: or h:, hence the prefix surf:.
template <class ElementHandle, class ValueType>
struct PropertyKey {
  using Handle = typename OpenMesh::PropHandle<ElementHandle>::template type<ValueType>;
  using Value = ValueType;

  const char* name;    ///< the name in OpenMesh and in .om files
  const char* writer;  ///< the stage that makes it
};

namespace keys {

/// Parameters of a vertex of a domain or control mesh.
inline constexpr PropertyKey<VertexHandle, Uv> vertex_uv{"surf:uv", "control, refine"};
/// Metric of a vertex of a domain mesh, kept from its one query of the metric field.
inline constexpr PropertyKey<VertexHandle, Metric> vertex_metric{"surf:metric", "refine"};
/// Size tensor of a control node.
inline constexpr PropertyKey<VertexHandle, SizeTensor> vertex_size{"surf:size", "control"};
/// Sizes M that hold in the disc of a control node of an extended form; unset for other nodes.
inline constexpr PropertyKey<VertexHandle, SizeTensor> vertex_inner_size{"surf:inner_size",
                                                                         "control"};
/// Radius r of the disc of a control node of an extended form, 0 for other nodes.
inline constexpr PropertyKey<VertexHandle, double> vertex_radius{"surf:radius", "control"};
/// Width r′ of the ring around that disc in which sizes change, 0 for other nodes.
inline constexpr PropertyKey<VertexHandle, double> vertex_outer_radius{"surf:outer_radius",
                                                                       "control"};
/// How a triangle of a control mesh interpolates: 0 from one vertex (V_s), 1 from its three (V_t),
/// 2 from all whose circumcircles contain the point (V_o), 4 linearly.
inline constexpr PropertyKey<FaceHandle, int> face_class{"surf:class", "control"};
/// 1 on edges that are segments of a contour: never swapped, never crossed by a cavity. A char,
/// because OpenMesh packs bool into bits, which the kernel reads more slowly.
inline constexpr PropertyKey<EdgeHandle, char> edge_constrained{"surf:constrained", "delaunay"};
/// Patch of a face of the result.
inline constexpr PropertyKey<FaceHandle, int> face_patch{"surf:patch", "assemble"};
/// Contour of an edge of the result, or of the finished mesh of a patch; -1 inside patches.
inline constexpr PropertyKey<EdgeHandle, int> edge_contour{"surf:contour", "patch_mesh, assemble"};
/// Parameters of a corner of the result, at the tip of the halfedge, in the patch of its face.
inline constexpr PropertyKey<HalfedgeHandle, Uv> corner_uv{"surf:uv", "assemble"};
/// Metric of a corner of the result, at the tip of the halfedge, in the patch of its face.
inline constexpr PropertyKey<HalfedgeHandle, Metric> corner_metric{"surf:metric", "assemble"};
/// 1 for a corner of the result whose (u,v) go on beyond the domain of the patch of its face, as
/// its tangent planes at the other corners do, and whose metric is the one that sees the sides of
/// the face as the vertex does; else 0. Only where elements have crossed contours.
inline constexpr PropertyKey<HalfedgeHandle, int> corner_beyond{"surf:beyond", "across"};
/// Texture coordinates of a corner of the result, at the tip of the halfedge, as the input has them
/// there; NaN where it has none. Made on wish.
inline constexpr PropertyKey<HalfedgeHandle, Uv> corner_texture{"surf:texture", "pipeline"};
/// Normal of the surface at a corner of the result, at the tip of the halfedge, on the side from
/// which the face goes around counter-clockwise. Made on wish.
inline constexpr PropertyKey<HalfedgeHandle, Normal> corner_normal{"surf:normal", "assemble"};

/// Distance between a face of the result and the surface, both ways, in model units. Only of runs
/// that were asked for a sag.
inline constexpr PropertyKey<FaceHandle, double> face_sag{"surf:sag", "pipeline"};

/// The vertex of which a vertex of the result is a copy, where a half-edge mesh cannot have one
/// vertex for all patches (at contours of three and more); its own number for others. Only where
/// there are such copies. Formats of indexed vertices write the original.
inline constexpr PropertyKey<VertexHandle, int> vertex_original{"surf:original", "assemble"};

/// Names of patches and groups in .om files, a property of the mesh as a whole there.
inline constexpr std::string_view mesh_names = "surf:names";

}  // namespace keys

/// Add the property, persistent (so that .om files store it), and set it to `initial` on every
/// element.
/// Throws   InvalidInput if the mesh has it already
template <class Mesh, class Element, class Value>
auto attach(Mesh& mesh, const PropertyKey<Element, Value>& key, const Value& initial = Value()) {
  typename PropertyKey<Element, Value>::Handle handle;
  if (mesh.get_property_handle(handle, key.name)) {
    throw Error(ErrorCode::InvalidInput,
                std::string("the mesh has a property ") + key.name + " already");
  }
  mesh.add_property(handle, key.name);
  mesh.property(handle).set_persistent(true);
  auto& values = mesh.property(handle).data_vector();
  values.assign(values.size(), initial);
  return handle;
}

/// Look up the property. The handle is invalid if the mesh does not have it.
template <class Mesh, class Element, class Value>
auto find(const Mesh& mesh, const PropertyKey<Element, Value>& key) {
  typename PropertyKey<Element, Value>::Handle handle;
  if (!mesh.get_property_handle(handle, key.name)) handle.invalidate();
  return handle;
}

/// Look up a property that an earlier stage must have made.
/// Throws   MissingProperty, naming the property and the stage that makes it
template <class Mesh, class Element, class Value>
auto require(const Mesh& mesh, const PropertyKey<Element, Value>& key) {
  auto handle = find(mesh, key);
  if (!handle.is_valid()) {
    throw Error(ErrorCode::MissingProperty, std::string("the mesh has no property ") + key.name +
                                                ", which the stage " + key.writer + " makes");
  }
  return handle;
}

/// Remove the property if the mesh has it.
template <class Mesh, class Element, class Value>
void detach(Mesh& mesh, const PropertyKey<Element, Value>& key) {
  auto handle = find(mesh, key);
  if (handle.is_valid()) mesh.remove_property(handle);
}

}  // namespace surfmesh
