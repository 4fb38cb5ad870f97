// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/copy_values.hh"

#include <cstddef>
#include <vector>

#include "surfmesh/assemble/piece_places.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {
namespace {

class ValueCopy {
 public:
  ValueCopy(const Piece& piece, const ResultArrays& result)
      : piece_(piece),
        mesh_(*piece.source.mesh),
        places_(piece),
        uv_(mesh_.property(require(mesh_, keys::vertex_uv)).data_vector()),
        metric_(mesh_.property(require(mesh_, keys::vertex_metric)).data_vector()),
        result_(result) {}

  void copy_points(const CommonVertices& common) const {
    for (const VertexHandle vh : mesh_.vertices()) {
      const int vertex = piece_.vertices(vh);
      if (common.is_on_contour(vertex) || !common.is_written_by(piece_.number, vertex)) continue;
      result_.point[static_cast<std::size_t>(vertex)] = mesh_.point(vh);
    }
  }

  void copy_corners() const {
    for (int h = 0; h < places_.row_end(); ++h) {
      const HalfedgeHandle heh(h);
      copy_corner(heh, places_.in_row(heh));
    }
    // Some of them fill places at which something else has been written now.
    places_.for_each_moved([&](HalfedgeHandle heh) { copy_corner(heh, places_(heh)); });
    places_.for_each_loose_face([&](const LooseFace& face, std::span<const HalfedgeHandle> sides) {
      for (std::size_t k = 0; k < face.count; ++k) {
        const CornerValue& tip = face.corners[k + 1 == face.count ? 0 : k + 1].value;
        result_.uv[index(sides[k])] = tip.uv;
        result_.metric[index(sides[k])] = tip.metric;
      }
    });
  }

  void write_patch() const {
    const auto first = result_.patch.begin() + piece_.first_face;
    std::fill(first, first + piece_.face_count(), piece_.source.boundary.patch);
  }

 private:
  void copy_corner(HalfedgeHandle heh, HalfedgeHandle to) const {
    const std::size_t tip = index(places_.tip(heh));
    result_.uv[index(to)] = uv_[tip];
    result_.metric[index(to)] = metric_[tip];
  }

  const Piece& piece_;
  const PolyMesh& mesh_;
  PiecePlaces places_;
  const std::vector<Uv>& uv_;          ///< by vertex of the piece's mesh
  const std::vector<Metric>& metric_;  ///< likewise
  const ResultArrays& result_;
};

}  // namespace

void copy_values(const Piece& piece, const CommonVertices& common, const ResultArrays& result) {
  const ValueCopy copy(piece, result);
  copy.copy_points(common);
  copy.copy_corners();
  copy.write_patch();
}

void release_values(PolyMesh& mesh) {
  detach(mesh, keys::vertex_uv);
  detach(mesh, keys::vertex_metric);
  detach(mesh, keys::edge_contour);
  detach(mesh, keys::edge_constrained);
  auto& points = mesh.property(mesh.points_property_handle()).data_vector();
  std::remove_reference_t<decltype(points)>().swap(points);
}

}  // namespace surfmesh::detail
