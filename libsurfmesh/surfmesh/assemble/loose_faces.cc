// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/loose_faces.hh"

#include <cstddef>

#include "surfmesh/core/properties.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh::detail {
namespace {

/// Leave out corners that are the same vertex as the next one: of a side that is a pole.
void drop_collapsed_corners(LooseFace& face) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < face.count; ++k) {
    const std::size_t next = k + 1 == face.count ? 0 : k + 1;
    if (face.corners[k].vertex != face.corners[next].vertex) face.corners[kept++] = face.corners[k];
  }
  face.count = kept;
}

/// Go around the other way, from the same corner on.
void turn(LooseFace& face) {
  const auto before = face.corners;
  for (std::size_t k = 0; k < face.count; ++k) {
    face.corners[k] = before[(face.count - k) % face.count];
    face.corners[k].contour = before[face.count - 1 - k].contour;
  }
}

class LooseFaceMaker {
 public:
  explicit LooseFaceMaker(Piece& piece)
      : piece_(piece),
        mesh_(*piece.source.mesh),
        uv_(require(mesh_, keys::vertex_uv)),
        metric_(require(mesh_, keys::vertex_metric)),
        contour_(require(mesh_, keys::edge_contour)) {}

  void add_collapsed(FaceHandle fh) {
    const bool is_kept = add(copy_of(fh), fh.idx() - dropped_);
    if (!is_kept) ++dropped_;
    piece_.collapsed.push_back({fh, !is_kept, dropped_});
  }

  /// After all that collapse.
  void add_fans() {
    piece_.face_count = static_cast<int>(mesh_.n_faces()) - dropped_;
    for (const PoleFan& fan : piece_.source.boundary.fans) {
      const auto step = static_cast<std::size_t>(fan.segments_per_face);
      for (std::size_t i = 0; i + step < fan.ring.size(); i += step) {
        if (add(face_of_fan(fan, i), piece_.face_count)) ++piece_.face_count;
      }
    }
  }

 private:
  /// Returns  false if less than a triangle is left
  bool add(LooseFace face, int number) {
    drop_collapsed_corners(face);
    if (face.count < 3) return false;
    if (piece_.is_turned) turn(face);
    face.number = number;
    piece_.loose_faces.push_back(face);
    return true;
  }

  LooseFace copy_of(FaceHandle fh) const {
    LooseFace face;
    for (const HalfedgeHandle heh : mesh_.fh_range(fh)) {
      LooseCorner& corner = face.corners[face.count++];
      corner = corner_at(mesh_.from_vertex_handle(heh));
      corner.contour = mesh_.property(contour_, mesh_.edge_handle(heh));
    }
    return face;
  }

  /// The face of a fan at the segments of the ring from node `i` on.
  LooseFace face_of_fan(const PoleFan& fan, std::size_t i) const {
    const std::size_t count = fan.ring.size() - 1;
    const auto step = static_cast<std::size_t>(fan.segments_per_face);
    LooseFace face;
    face.count = step + 2;
    for (std::size_t k = 0; k <= step; ++k) {
      face.corners[k + 1] = corner_at(VertexHandle(fan.ring[i + step - k]));
    }
    face.corners[0] = {
        fan.pole, i + step == count ? fan.contour_from : -1,
        value_at_pole(fan, i, face.corners[step + 1].value.metric, face.corners[1].value.metric)};
    if (i == 0) face.corners[step + 1].contour = fan.contour_to;
    return face;
  }

  LooseCorner corner_at(VertexHandle vh) const {
    return {piece_.vertices(vh), -1, {mesh_.property(uv_, vh), mesh_.property(metric_, vh)}};
  }

  Piece& piece_;
  int dropped_ = 0;  ///< faces of which nothing is left
  const PolyMesh& mesh_;
  decltype(keys::vertex_uv)::Handle uv_;
  decltype(keys::vertex_metric)::Handle metric_;
  decltype(keys::edge_contour)::Handle contour_;
};

}  // namespace

CornerValue value_at_pole(const PoleFan& fan, std::size_t i, const Metric& first,
                          const Metric& last) {
  const auto count = static_cast<double>(fan.ring.size() - 1);
  const double share = (static_cast<double>(i) + 0.5 * fan.segments_per_face) / count;
  return {point_on_pole(fan, share), mean(first, last)};
}

void make_loose_faces(Piece& piece, const std::vector<FaceHandle>& collapsed) {
  LooseFaceMaker maker(piece);
  for (const FaceHandle fh : collapsed) maker.add_collapsed(fh);
  maker.add_fans();
}

}  // namespace surfmesh::detail
