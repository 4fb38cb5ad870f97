// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/smooth_normals.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/quality/face_corners.hh"

namespace surfmesh {
namespace {

/// A corner at a vertex, and whether the mesh is smooth on from it.
struct CornerAround {
  HalfedgeHandle corner;
  bool is_smooth_on;
};

class NormalEstimate {
 public:
  explicit NormalEstimate(const PolyMesh& mesh)
      : mesh_(mesh),
        contour_of_(find(mesh, keys::edge_contour)),
        patch_of_(find(mesh, keys::face_patch)),
        of_faces_(mesh.n_faces()) {
    share_ranges(of_faces_.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t f = first; f < end; ++f) {
        of_faces_[f] = area_of(FaceHandle(static_cast<int>(f))).stableNormalized();
      }
    });
  }

  void estimate(VertexHandle vh, std::vector<CornerAround>& corners,
                std::vector<Vec3>& normals) const {
    collect(vh, corners);
    // Begin behind a contour, if there is one.
    const auto last = std::find_if(corners.rbegin(), corners.rend(),
                                   [](const CornerAround& c) { return !c.is_smooth_on; });
    std::rotate(corners.begin(), last.base() == corners.begin() ? corners.begin() : last.base(),
                corners.end());
    for (std::size_t first = 0; first < corners.size();) {
      std::size_t end = first + 1;
      while (end < corners.size() && corners[end - 1].is_smooth_on) ++end;
      Vec3 sum = Vec3::Zero();
      for (std::size_t i = first; i < end; ++i) sum += weighted(corners[i].corner);
      const double length = sum.norm();
      const Vec3 normal = length > 0 ? Vec3(sum / length) : Vec3::UnitZ();
      for (; first < end; ++first) normals[index(corners[first].corner)] = normal;
    }
  }

 private:
  Vec3 area_of(FaceHandle fh) const {
    Vec3 area = Vec3::Zero();
    const Vec3 start = detail::point_of(mesh_, mesh_.halfedge_handle(fh));
    Vec3 before = Vec3::Zero();
    for_each_corner(mesh_, fh, [&](HalfedgeHandle heh) {
      const Vec3 here = detail::point_of(mesh_, heh) - start;
      area += before.cross(here);
      before = here;
    });
    return area;
  }

  /// The corners around a vertex, counter-clockwise.
  void collect(VertexHandle vh, std::vector<CornerAround>& corners) const {
    corners.clear();
    const HalfedgeHandle start = mesh_.halfedge_handle(vh);
    if (!start.is_valid()) return;
    HalfedgeHandle out = start;
    do {
      const HalfedgeHandle in = mesh_.prev_halfedge_handle(out);
      if (!mesh_.is_boundary(in)) corners.push_back({in, is_smooth(in)});
      out = mesh_.opposite_halfedge_handle(in);
    } while (out != start);
  }

  bool is_smooth(HalfedgeHandle heh) const {
    const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(heh);
    if (mesh_.is_boundary(opposite)) return false;
    if (contour_of_.is_valid()) return mesh_.property(contour_of_, mesh_.edge_handle(heh)) < 0;
    return !patch_of_.is_valid() || mesh_.property(patch_of_, mesh_.face_handle(heh)) ==
                                        mesh_.property(patch_of_, mesh_.face_handle(opposite));
  }

  /// The normal of a face times its angle at a corner.
  Vec3 weighted(HalfedgeHandle corner) const {
    const Vec3 here = detail::point_of(mesh_, corner);
    const Vec3 a = detail::point_of(mesh_, mesh_.next_halfedge_handle(corner)) - here;
    const Vec3 b = detail::point_of(mesh_, mesh_.prev_halfedge_handle(corner)) - here;
    return std::atan2(a.cross(b).norm(), a.dot(b)) * of_faces_[index(mesh_.face_handle(corner))];
  }

  const PolyMesh& mesh_;
  decltype(keys::edge_contour)::Handle contour_of_;
  decltype(keys::face_patch)::Handle patch_of_;
  std::vector<Vec3> of_faces_;
};

}  // namespace

std::vector<Vec3> smooth_normals(const PolyMesh& mesh) {
  const NormalEstimate estimate(mesh);
  std::vector<Vec3> normals(mesh.n_halfedges(), Vec3::Zero());
  share_ranges(mesh.n_vertices(), [&](std::size_t first, std::size_t end) {
    std::vector<CornerAround> corners;
    for (std::size_t v = first; v < end; ++v) {
      estimate.estimate(VertexHandle(static_cast<int>(v)), corners, normals);
    }
  });
  return normals;
}

}  // namespace surfmesh
