// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/result_arrays.hh"

#include <array>
#include <functional>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {
namespace {

/// The values of a property that is attached to a mesh without elements.
template <class Key>
auto& attached_values(PolyMesh& mesh, const Key& key) {
  return mesh.property(attach(mesh, key)).data_vector();
}

}  // namespace

ResultArrays make_result_arrays(PolyMesh& mesh, const ElementCounts& counts) {
  ResultArrays result{
      mesh.property(mesh.points_property_handle()).data_vector(),
      attached_values(mesh, keys::face_patch), attached_values(mesh, keys::edge_contour),
      attached_values(mesh, keys::corner_uv), attached_values(mesh, keys::corner_metric)};
  // The mesh itself would resize one after the other.
  const std::array<std::function<void()>, 5> resize = {
      [&] { result.metric.resize(2 * counts.edges); }, [&] { result.uv.resize(2 * counts.edges); },
      [&] { result.point.resize(counts.vertices); },
      [&] { result.contour.resize(counts.edges, -1); }, [&] { result.patch.resize(counts.faces); }};
  share_indices(resize.size(), [&](std::size_t i) { resize[i](); });
  return result;
}

}  // namespace surfmesh::detail
