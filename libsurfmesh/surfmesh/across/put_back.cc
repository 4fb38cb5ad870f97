// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/put_back.hh"

#include <cassert>
#include <numeric>
#include <utility>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"

namespace surfmesh {
namespace {

/// Stands for the result in place of the number of a region.
constexpr int kOfResult = -1;

/// A face of the new result.
struct FaceSource {
  FaceHandle face;
  int region = kOfResult;
  int patch = -1;
};

/// A region on its way back, with the numbers of its vertices and corners in the new result.
class ReturningRegion {
 public:
  explicit ReturningRegion(const RegionWork& work) : work_(work), mesh_(*work.region.mesh) {}

  const PolyMesh& mesh() const { return mesh_; }
  std::size_t face_bound() const { return work_.editor->face_bound(); }
  bool is_used(FaceHandle fh) const { return work_.editor->is_used(fh); }
  const FaceInPatch& in_patch(FaceHandle fh) const { return work_.faces[index(fh)]; }

  /// Call `visit(vertex, origin, moved)` for each vertex that is left: the vertex of the result
  /// that it was, -1 for a new one, and its chart, null if it is where it was.
  template <class Visit>
  void for_each_vertex(Visit visit) const {
    for (std::size_t v = 0; v < work_.editor->vertex_bound(); ++v) {
      const VertexHandle vh(static_cast<int>(v));
      if (!work_.editor->is_used(vh)) continue;
      visit(vh, work_.origin(vh), work_.is_moved(vh) ? &work_.charts[v] : nullptr);
    }
  }

  /// The halfedge of the result that a side at the border was; invalid for other sides.
  HalfedgeHandle rim(HalfedgeHandle heh) const {
    if (!mesh_.is_boundary(mesh_.opposite_halfedge_handle(heh))) return HalfedgeHandle();
    return work_.region.rim[index(mesh_.edge_handle(heh))];
  }

  std::vector<int> vertex_numbers;  ///< of the new result, by vertex
  std::vector<int> corner_numbers;  ///< of the new result, by halfedge

 private:
  const RegionWork& work_;
  const PolyMesh& mesh_;
};

/// Builds the new result.
class PutBack {
 public:
  PutBack(std::span<const RegionWork> regions, const std::vector<char>& is_held, PolyMesh& result)
      : is_held_(is_held),
        result_(result),
        patch_of_(require(result, keys::face_patch)),
        contour_of_(require(result, keys::edge_contour)),
        uv_of_(require(result, keys::corner_uv)),
        metric_of_(require(result, keys::corner_metric)),
        beyond_(attach_if_new(result)),
        is_taken_(result.n_faces(), 0) {
    for (const RegionWork& work : regions) {
      regions_.emplace_back(work);
      for (const FaceHandle fh : work.region.faces) is_taken_[index(fh)] = 1;
    }
  }

  PutBackReport run() {
    order_faces();
    number_vertices();
    collect_faces();
    find_twins();
    rebuild();
    return {std::move(vertices_), std::move(places_)};
  }

 private:
  static decltype(keys::corner_beyond)::Handle attach_if_new(PolyMesh& result) {
    const auto handle = find(result, keys::corner_beyond);
    return handle.is_valid() ? handle : attach(result, keys::corner_beyond, 0);
  }

  ReturningRegion& region(int r) { return regions_[static_cast<std::size_t>(r)]; }
  const ReturningRegion& region(int r) const { return regions_[static_cast<std::size_t>(r)]; }

  const PolyMesh& mesh_of(const FaceSource& source) const {
    return source.region == kOfResult ? result_ : region(source.region).mesh();
  }

  /// Call `visit` with the faces that were not taken, then with those of the regions.
  template <class Visit>
  void for_each_source(Visit visit) const {
    for (const FaceHandle fh : result_.faces()) {
      if (is_taken_[index(fh)] == 0) {
        visit(FaceSource{fh, kOfResult, result_.property(patch_of_, fh)});
      }
    }
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      for (std::size_t f = 0; f < regions_[r].face_bound(); ++f) {
        const FaceHandle fh(static_cast<int>(f));
        if (!regions_[r].is_used(fh)) continue;
        visit(FaceSource{fh, static_cast<int>(r), regions_[r].in_patch(fh).patch});
      }
    }
  }

  /// List the faces in the order of their patches.
  void order_faces() {
    std::vector<std::size_t> next(1, 0);  // by patch: how many faces there are before, and so far
    for_each_source([&](const FaceSource& source) {
      const auto patch = static_cast<std::size_t>(source.patch);
      if (patch + 2 > next.size()) next.resize(patch + 2, 0);
      ++next[patch + 1];
    });
    std::partial_sum(next.begin(), next.end(), next.begin());
    order_.resize(next.back());
    for_each_source([&](const FaceSource& source) {
      order_[next[static_cast<std::size_t>(source.patch)]++] = source;
    });
  }

  /// Vertices that were there keep their order; new ones come last.
  void number_vertices() {
    vertices_.assign(result_.n_vertices(), -1);
    for (const FaceHandle fh : result_.faces()) {
      if (is_taken_[index(fh)] != 0) continue;
      for_each_vertex_of(result_, fh,
                         [this](int vertex) { vertices_[static_cast<std::size_t>(vertex)] = 0; });
    }
    for (const ReturningRegion& returning : regions_) {
      returning.for_each_vertex([this](VertexHandle, int origin, const VertexChart*) {
        if (origin >= 0) vertices_[static_cast<std::size_t>(origin)] = 0;
      });
    }
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (vertices_[v] < 0) continue;
      vertices_[v] = static_cast<int>(points_.size());
      points_.push_back(result_.point(VertexHandle(static_cast<int>(v))));
    }
    places_.resize(points_.size());
    for (ReturningRegion& returning : regions_) {
      returning.vertex_numbers.assign(returning.mesh().n_vertices(), -1);
      returning.for_each_vertex([&](VertexHandle vh, int origin, const VertexChart* moved) {
        int& number = returning.vertex_numbers[index(vh)];
        number = origin >= 0 ? vertices_[static_cast<std::size_t>(origin)]
                             : static_cast<int>(points_.size());
        if (origin < 0) {
          points_.emplace_back();
          places_.emplace_back();
        }
        if (!moved) return;
        points_[static_cast<std::size_t>(number)] = to_openmesh(moved->point);
        places_[static_cast<std::size_t>(number)] = moved->place;
      });
    }
  }

  int vertex_of(const FaceSource& source, HalfedgeHandle heh) const {
    const std::size_t v = index(mesh_of(source).from_vertex_handle(heh));
    return source.region == kOfResult ? vertices_[v] : region(source.region).vertex_numbers[v];
  }

  /// List the faces, with what their corners and sides hold.
  void collect_faces() {
    corner_of_.assign(result_.n_halfedges(), -1);
    for (ReturningRegion& returning : regions_) {
      returning.corner_numbers.assign(returning.mesh().n_halfedges(), -1);
    }
    reserve();
    std::vector<int> cycle;
    for (const FaceSource& source : order_) {
      cycle.clear();
      for_each_corner(mesh_of(source), source.face, [&](HalfedgeHandle heh) {
        add_corner(source, heh, cycle.size());
        cycle.push_back(vertex_of(source, heh));
      });
      faces_.add(cycle);
    }
  }

  void reserve() {
    std::size_t corners = result_.n_halfedges();
    for (const ReturningRegion& returning : regions_) corners += returning.mesh().n_halfedges();
    faces_.reserve(order_.size(), corners);
    uvs_.reserve(corners);
    metrics_.reserve(corners);
    is_beyond_.reserve(corners);
    contours_.reserve(corners);
  }

  /// Add what a face holds at the origin of its k-th side, and that side.
  void add_corner(const FaceSource& source, HalfedgeHandle heh, std::size_t k) {
    const auto corner = static_cast<int>(uvs_.size());
    HalfedgeHandle old = heh;
    if (source.region == kOfResult) {
      const HalfedgeHandle before = result_.prev_halfedge_handle(heh);
      uvs_.push_back(result_.property(uv_of_, before));
      metrics_.push_back(result_.property(metric_of_, before));
      is_beyond_.push_back(result_.property(beyond_, before));
    } else {
      ReturningRegion& returning = region(source.region);
      const FaceInPatch& face = returning.in_patch(source.face);
      uvs_.push_back(face.uvs[k]);
      metrics_.push_back(face.metrics[k]);
      is_beyond_.push_back(face.is_beyond[k] ? 1 : 0);
      returning.corner_numbers[index(heh)] = corner;
      old = returning.rim(heh);
    }
    // Neighbours across the border of a region know the side that it was.
    if (old.is_valid()) corner_of_[index(old)] = corner;
    const bool is_held = old.is_valid() && is_held_[index(result_.edge_handle(old))] != 0;
    contours_.push_back(is_held ? result_.property(contour_of_, result_.edge_handle(old)) : -1);
  }

  void find_twins() {
    twins_.reserve(uvs_.size());
    for (const FaceSource& source : order_) {
      for_each_corner(mesh_of(source), source.face,
                      [&](HalfedgeHandle heh) { twins_.push_back(twin_of(source, heh)); });
    }
  }

  int twin_of(const FaceSource& source, HalfedgeHandle heh) const {
    HalfedgeHandle old = heh;
    if (source.region != kOfResult) {
      const ReturningRegion& returning = region(source.region);
      old = returning.rim(heh);
      if (!old.is_valid()) {
        return returning.corner_numbers[index(returning.mesh().opposite_halfedge_handle(heh))];
      }
    }
    const HalfedgeHandle opposite = result_.opposite_halfedge_handle(old);
    return result_.is_boundary(opposite) ? kOpenSide : corner_of_[index(opposite)];
  }

  void rebuild() {
    result_.resize(0, 0, 0);
    [[maybe_unused]] const Separation separation =
        build_faces(result_, points_.size(), faces_, FirstSide::FromFirstCorner, twins_);
    assert(separation.copied.empty());  // no fan was taken apart
    for (std::size_t v = 0; v < points_.size(); ++v) {
      result_.set_point(VertexHandle(static_cast<int>(v)), points_[v]);
    }
    for (const EdgeHandle eh : result_.edges()) result_.property(contour_of_, eh) = -1;
    for (std::size_t f = 0; f < order_.size(); ++f) {
      const FaceHandle fh(static_cast<int>(f));
      result_.property(patch_of_, fh) = order_[f].patch;
      std::size_t corner = faces_.first_corner(f);
      for_each_corner(result_, fh, [&](HalfedgeHandle heh) {
        const HalfedgeHandle into = result_.prev_halfedge_handle(heh);
        result_.property(uv_of_, into) = uvs_[corner];
        result_.property(metric_of_, into) = metrics_[corner];
        result_.property(beyond_, into) = is_beyond_[corner];
        if (contours_[corner] >= 0) {
          result_.property(contour_of_, result_.edge_handle(heh)) = contours_[corner];
        }
        ++corner;
      });
    }
  }

  const std::vector<char>& is_held_;
  PolyMesh& result_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::edge_contour)::Handle contour_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  decltype(keys::corner_metric)::Handle metric_of_;
  decltype(keys::corner_beyond)::Handle beyond_;
  std::vector<char> is_taken_;  ///< by face of the result
  std::vector<ReturningRegion> regions_;
  std::vector<FaceSource> order_;        ///< by face of the new result
  std::vector<int> vertices_;            ///< of the new result, by vertex of the old one
  std::vector<PolyMesh::Point> points_;  ///< of the new result
  std::vector<SurfacePlace> places_;     ///< likewise, of moved vertices
  FaceList faces_;
  std::vector<int> corner_of_;  ///< by halfedge of the old result; -1 for none
  std::vector<Uv> uvs_;         ///< by corner of the new result, like the following
  std::vector<Metric> metrics_;
  std::vector<int> is_beyond_;
  std::vector<int> contours_;
  std::vector<int> twins_;
};

}  // namespace

PutBackReport put_back(std::span<const RegionWork> regions, const std::vector<char>& is_held,
                       PolyMesh& result) {
  return PutBack(regions, is_held, result).run();
}

}  // namespace surfmesh
