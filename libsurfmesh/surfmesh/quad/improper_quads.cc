// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/improper_quads.hh"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/quad_topology.hh"
#include "surfmesh/patch_mesh/chord_counts.hh"
#include "surfmesh/quad/compact_patch.hh"
#include "surfmesh/quad/patch_geometry.hh"
#include "surfmesh/quad/smooth_quads.hh"

namespace surfmesh {
namespace {

/// One round is enough: new edges have new vertices. The next one finds nothing.
constexpr int kMaxRounds = 3;

constexpr int kSmoothings = 8;

/// Puts rings of quads into one patch.
class PatchMending {
 public:
  PatchMending(PatchMesh& patch, const MetricField& field)
      : patch_(patch),
        editor_(*patch.mesh),
        geometry_(*patch.mesh, field, boundary_vertices(patch.boundary).size()) {}

  /// Shrink the two quads at an edge, whose edge then has new ends.
  bool mend(EdgeHandle eh) {
    const HalfedgeHandle heh = mesh().halfedge_handle(eh, 0);
    const HalfedgeHandle opposite = mesh().opposite_halfedge_handle(heh);
    if (!is_at_quad(mesh(), heh) || !is_at_quad(mesh(), opposite)) return false;
    const auto [a, b, c, d] = quad_vertices(mesh(), heh);
    const auto [b2, a2, e, f] = quad_vertices(mesh(), opposite);
    const std::array<VertexHandle, 6> outer = {a, e, f, b, c, d};
    const std::vector<VertexHandle> inner = ring_inside(outer);
    fresh_.add({inner[0], inner[3], inner[4], inner[5]});
    fresh_.add({inner[0], inner[1], inner[2], inner[3]});
    replace({mesh().face_handle(heh), mesh().face_handle(opposite)}, inner);
    return true;
  }

  bool mend(FaceHandle fh) {
    const HalfedgeHandle heh = mesh().halfedge_handle(fh);
    if (!is_at_quad(mesh(), heh)) return false;
    const std::vector<VertexHandle> inner = ring_inside(quad_vertices(mesh(), heh));
    fresh_.add(inner);
    replace({fh}, inner);
    return true;
  }

  /// Hand the patch back.
  void close(const Surface& surface) {
    compact_patch(mesh(), editor_);
    patch_ = finish_patch(std::move(patch_.boundary), std::move(patch_.mesh), surface);
  }

 private:
  PolyMesh& mesh() { return *patch_.mesh; }

  /// Begin with a ring of quads along a cycle of vertices, inside it.
  /// Returns  its inner vertices
  template <std::size_t n>
  std::vector<VertexHandle> ring_inside(const std::array<VertexHandle, n>& outer) {
    std::vector<VertexHandle> inner;
    for (std::size_t k = 0; k < n; ++k) {
      inner.push_back(editor_.add_vertex());
      std::vector<VertexHandle> others(outer.begin(), outer.end());
      others.insert(others.end(), n, outer[k]);
      geometry_.put_between(inner.back(), others);
    }
    fresh_.clear();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      fresh_.add({outer[k], outer[next], inner[next], inner[k]});
    }
    return inner;
  }

  void replace(const std::vector<FaceHandle>& old, const std::vector<VertexHandle>& inner) {
    editor_.replace(old, fresh_, made_);
    QuadSmoother smoother(geometry_);
    for (int round = 0; round < kSmoothings; ++round) {
      for (const VertexHandle vh : inner) smoother.smooth(vh, {.size = 0.1});
    }
  }

  PatchMesh& patch_;
  FaceEditor editor_;
  PatchGeometry geometry_;
  FaceCycles fresh_;
  std::vector<FaceHandle> made_;
};

/// Finds what is improper and opens patches for it.
class Mending {
 public:
  Mending(std::vector<PatchMesh>& patches, const std::vector<const MetricField*>& fields)
      : patches_(patches), fields_(fields) {}

  struct Count {
    std::size_t found = 0, mended = 0;  ///< places
  };

  Count run() {
    // All places are found before any patch changes. A face goes only once.
    const std::vector<detail::Chord> chords = detail::ImproperChords(patches_).offending();
    const std::vector<Place> places = doubled_corners();
    Count count{chords.size() + places.size(), 0};
    for (const detail::Chord& chord : chords) {
      if (is_free(chord) && open(chord.patch).mend(chord.edge)) ++count.mended;
    }
    for (const Place& place : places) {
      if (take(place.patch, place.face) && open(place.patch).mend(place.face)) ++count.mended;
    }
    return count;
  }

  void close(const Model& model) {
    for (auto& [p, mending] : open_) mending->close(model.surface(patches_[p].boundary.patch));
  }

 private:
  struct Place {
    std::size_t patch;
    FaceHandle face;
  };

  /// The quads with a vertex twice, which are opposite corners.
  std::vector<Place> doubled_corners() const {
    const detail::VertexNumbers number(patches_);
    std::vector<Place> places;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      const PolyMesh& mesh = *patches_[p].mesh;
      const auto boundary_count = static_cast<int>(number.boundary_count(p));
      for (int v = 0; v < boundary_count; ++v) {
        for (const HalfedgeHandle heh : mesh.voh_range(VertexHandle(v))) {
          if (mesh.is_boundary(heh)) continue;
          const VertexHandle opposite = mesh.to_vertex_handle(mesh.next_halfedge_handle(heh));
          if (opposite.idx() > v && number(p, opposite) == number(p, VertexHandle(v))) {
            places.push_back({p, mesh.face_handle(heh)});
          }
        }
      }
    }
    return places;
  }

  bool is_free(const detail::Chord& chord) {
    const PolyMesh& mesh = *patches_[chord.patch].mesh;
    const FaceHandle first = mesh.face_handle(mesh.halfedge_handle(chord.edge, 0));
    const FaceHandle second = mesh.face_handle(mesh.halfedge_handle(chord.edge, 1));
    if (taken_.contains({chord.patch, first}) || taken_.contains({chord.patch, second})) {
      return false;
    }
    return take(chord.patch, first) && take(chord.patch, second);
  }

  /// False if the face has been replaced already.
  bool take(std::size_t patch, FaceHandle fh) { return taken_.emplace(patch, fh).second; }

  PatchMending& open(std::size_t patch) {
    std::unique_ptr<PatchMending>& mending = open_[patch];
    if (!mending) {
      PatchMesh& mesh = patches_[patch];
      mending = std::make_unique<PatchMending>(mesh, *fields_[mesh.patch()]);
    }
    return *mending;
  }

  std::vector<PatchMesh>& patches_;
  const std::vector<const MetricField*>& fields_;
  std::set<std::pair<std::size_t, FaceHandle>> taken_;
  std::map<std::size_t, std::unique_ptr<PatchMending>> open_;
};

}  // namespace

std::size_t mend_improper_quads(std::vector<PatchMesh>& patches, const Model& model,
                                const std::vector<const MetricField*>& fields) {
  std::size_t mended = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    Mending mending(patches, fields);
    const auto count = mending.run();
    mending.close(model);
    mended += count.mended;
    if (count.found == 0) return mended;
    if (count.mended == 0) break;
  }
  throw Error(ErrorCode::Geometry,
              "the boundary is too coarse: quads between its nodes keep joining the same vertices");
}

}  // namespace surfmesh
