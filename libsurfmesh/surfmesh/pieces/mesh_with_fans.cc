// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/mesh_with_fans.hh"

#include <cstddef>
#include <vector>

#include "surfmesh/assemble/loose_faces.hh"
#include "surfmesh/core/copy_mesh.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {
namespace {

class FanAdder {
 public:
  FanAdder(PolyMesh& mesh, const PatchBoundary& boundary, const Model& model)
      : mesh_(mesh),
        boundary_(boundary),
        model_(model),
        uv_(require(mesh, keys::corner_uv)),
        metric_(require(mesh, keys::corner_metric)),
        patch_(require(mesh, keys::face_patch)),
        node_uv_(require(mesh, keys::vertex_uv)),
        node_metric_(require(mesh, keys::vertex_metric)) {}

  void add(const PoleFan& fan) {
    const Vec3& position = model_.vertices[static_cast<std::size_t>(fan.pole)].position;
    const VertexHandle pole = mesh_.add_vertex(to_openmesh(position));
    const auto step = static_cast<std::size_t>(fan.segments_per_face);
    for (std::size_t i = 0; i + step < fan.ring.size(); i += step) add_face(fan, i, pole);
  }

 private:
  /// The face at the segments of the ring from node `i` on.
  void add_face(const PoleFan& fan, std::size_t i, VertexHandle pole) {
    const auto step = static_cast<std::size_t>(fan.segments_per_face);
    std::vector<VertexHandle> corners = {pole};
    for (std::size_t k = 0; k <= step; ++k) corners.emplace_back(fan.ring[i + step - k]);
    const FaceHandle fh = mesh_.add_face(corners);
    if (!fh.is_valid()) return;  // it would make the mesh improper
    mesh_.property(patch_, fh) = boundary_.patch;
    const CornerValue at_pole = value_at_pole(fan, i, mesh_.property(node_metric_, corners.back()),
                                              mesh_.property(node_metric_, corners[1]));
    for (const HalfedgeHandle heh : mesh_.fh_range(fh)) {
      const VertexHandle tip = mesh_.to_vertex_handle(heh);
      mesh_.property(uv_, heh) = tip == pole ? at_pole.uv : mesh_.property(node_uv_, tip);
      mesh_.property(metric_, heh) =
          tip == pole ? at_pole.metric : mesh_.property(node_metric_, tip);
    }
  }

  PolyMesh& mesh_;
  const PatchBoundary& boundary_;
  const Model& model_;
  decltype(keys::corner_uv)::Handle uv_;
  decltype(keys::corner_metric)::Handle metric_;
  decltype(keys::face_patch)::Handle patch_;
  decltype(keys::vertex_uv)::Handle node_uv_;
  decltype(keys::vertex_metric)::Handle node_metric_;
};

}  // namespace

std::unique_ptr<PolyMesh> mesh_with_fans(const PatchMesh& tile, const Model& model) {
  auto mesh = copy_of(*tile.mesh);
  FanAdder adder(*mesh, tile.boundary, model);
  for (const PoleFan& fan : tile.boundary.fans) adder.add(fan);
  return mesh;
}

}  // namespace surfmesh::detail
