// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/Traits.hh>
#include <cstddef>

#include "surfmesh/core/storable.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// Double precision points. No status bits, which cost time and memory in every operation; an
/// application can request them on its own copy.
struct MeshTraits : public OpenMesh::DefaultTraitsDouble {
  FaceAttributes(OpenMesh::Attributes::None);
  VertexAttributes(OpenMesh::Attributes::None);
};

/// All meshes: those of control spaces, which consist of triangles, and those of patches and the
/// result, of triangles or quads.
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<MeshTraits>;

/// The index of an element in lists with one entry per element; its handle must be valid.
inline std::size_t index(OpenMesh::BaseHandle handle) {
  return static_cast<std::size_t>(handle.idx());
}

/// @{
/// The same point in the type of the other library.
inline Vec3 to_eigen(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }
inline OpenMesh::Vec3d to_openmesh(const Vec3& p) { return {p[0], p[1], p[2]}; }
/// @}

}  // namespace surfmesh
