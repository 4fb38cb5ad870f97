// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <vector>

#include "surfmesh/quad/pair_triangles.hh"

namespace surfmesh {
namespace {

/// Score of a way that joins two vertices which are joined already.
constexpr double kForbidden = -10;

using Pentagon = std::array<VertexHandle, 5>;

/// Ways of faces from one triangle to the nearest other one.
class NearestTriangle {
 public:
  explicit NearestTriangle(const PolyMesh& mesh) : mesh_(mesh) {}

  /// The sides to be crossed from a triangle to the nearest other one, the first first; empty if
  /// there is none.
  std::vector<HalfedgeHandle> way_from(FaceHandle start) {
    begin(start);
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const FaceHandle fh = queue_[i];
      if (fh != start && mesh_.valence(fh) == 3) return way_to(fh, start);
      for (const HalfedgeHandle heh : mesh_.fh_range(fh)) visit(heh);
    }
    return {};
  }

 private:
  void begin(FaceHandle start) {
    seen_.resize(mesh_.n_faces(), 0);
    side_.resize(mesh_.n_faces());
    ++round_;
    queue_.assign(1, start);
    seen_[index(start)] = round_;
  }

  void visit(HalfedgeHandle heh) {
    const FaceHandle beyond = mesh_.face_handle(mesh_.opposite_halfedge_handle(heh));
    if (!beyond.is_valid() || seen_[index(beyond)] == round_) return;
    seen_[index(beyond)] = round_;
    side_[index(beyond)] = heh;
    queue_.push_back(beyond);
  }

  std::vector<HalfedgeHandle> way_to(FaceHandle fh, FaceHandle start) const {
    std::vector<HalfedgeHandle> way;
    for (; fh != start; fh = mesh_.face_handle(way.back())) way.push_back(side_[index(fh)]);
    std::reverse(way.begin(), way.end());
    return way;
  }

  const PolyMesh& mesh_;
  std::vector<int> seen_;             ///< by face: the round in which it was reached
  std::vector<HalfedgeHandle> side_;  ///< by face: through which it was reached
  int round_ = 0;
  std::vector<FaceHandle> queue_;
};

class Walk {
 public:
  Walk(PolyMesh& mesh, FaceEditor& editor, const QuadGeometry& geometry)
      : mesh_(mesh), editor_(editor), geometry_(geometry), nearest_(mesh) {}

  std::size_t run(const RunContext& context) {
    std::size_t left = 0;
    for (const FaceHandle start : triangles()) {
      context.throw_if_cancelled();
      if (!editor_.is_used(start) || mesh_.valence(start) != 3) continue;
      const std::vector<HalfedgeHandle> way = nearest_.way_from(start);
      if (way.empty()) {
        ++left;
      } else {
        go(way);
      }
    }
    return left;
  }

 private:
  std::vector<FaceHandle> triangles() const {
    std::vector<FaceHandle> triangles;
    for (std::size_t f = 0; f < editor_.face_bound(); ++f) {
      const FaceHandle fh(static_cast<int>(f));
      if (editor_.is_used(fh) && mesh_.valence(fh) == 3) triangles.push_back(fh);
    }
    return triangles;
  }

  /// The side that leads on stays while the two faces before it are cut anew.
  void go(const std::vector<HalfedgeHandle>& way) {
    for (std::size_t i = 0; i + 1 < way.size(); ++i) pass(way[i], way[i + 1]);
    merge(way.back());
  }

  std::array<FaceHandle, 2> faces_at(HalfedgeHandle heh) const {
    return {mesh_.face_handle(heh), mesh_.face_handle(mesh_.opposite_halfedge_handle(heh))};
  }

  void merge(HalfedgeHandle side) {
    const HalfedgeHandle beyond = mesh_.opposite_halfedge_handle(side);
    fresh_.clear();
    fresh_.add({mesh_.to_vertex_handle(side),
                mesh_.to_vertex_handle(mesh_.next_halfedge_handle(side)),
                mesh_.from_vertex_handle(side),
                mesh_.to_vertex_handle(mesh_.next_halfedge_handle(beyond))});
    editor_.replace(faces_at(side), fresh_, made_);
  }

  /// Move the triangle at `side` through the quad behind it, to the quad's side `exit`.
  void pass(HalfedgeHandle side, HalfedgeHandle exit) {
    const HalfedgeHandle beyond = mesh_.opposite_halfedge_handle(side);
    const HalfedgeHandle after = mesh_.next_halfedge_handle(beyond);
    const VertexHandle p = mesh_.from_vertex_handle(side), q = mesh_.to_vertex_handle(side);
    const VertexHandle x = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(side));
    const VertexHandle y = mesh_.to_vertex_handle(after);
    const VertexHandle z = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(after));
    // A vertex of these two faces alone, between two common sides, goes.
    if (mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(side)) == after) {
      return drop(side, p, {y, z, q});
    }
    if (mesh_.opposite_halfedge_handle(mesh_.next_halfedge_handle(side)) ==
        mesh_.prev_halfedge_handle(beyond)) {
      return drop(side, q, {p, y, z});
    }
    const std::array<FaceHandle, 2> old = faces_at(side);
    const Pentagon pentagon = {x, p, y, z, q};
    const auto at = static_cast<std::size_t>(
        std::find(pentagon.begin(), pentagon.end(), mesh_.from_vertex_handle(exit)) -
        pentagon.begin());
    const double first = cut(old, pentagon, (at + 4) % 5);
    const std::array<FaceHandle, 2> made = {made_[0], made_[1]};
    if (const double second = cut(made, pentagon, at); second >= first) return;
    cut({{made_[0], made_[1]}}, pentagon, (at + 4) % 5);
  }

  using Triangle = std::array<VertexHandle, 3>;

  /// The triangle takes the quad up where the two share two sides; the vertex between goes.
  void drop(HalfedgeHandle side, VertexHandle between, const Triangle& triangle) {
    fresh_.clear();
    fresh_.add(triangle);
    editor_.replace(faces_at(side), fresh_, made_);
    editor_.free_vertex(between);
  }

  /// Cut a pentagon into the triangle of three corners in a row, from `first` on, and a quad.
  /// Returns  how good both are
  double cut(const std::array<FaceHandle, 2>& old, const Pentagon& p, std::size_t first) {
    const auto corner = [&](std::size_t k) { return p[(first + k) % 5]; };
    fresh_.clear();
    fresh_.add({corner(0), corner(1), corner(2)});
    fresh_.add({corner(2), corner(3), corner(4), corner(0)});
    editor_.replace(old, fresh_, made_);
    if (count_edges(corner(0), corner(2)) > 1) return kForbidden;
    return std::min(geometry_.measure(made_[0]).least_jacobian,
                    geometry_.measure(made_[1]).least_jacobian);
  }

  int count_edges(VertexHandle a, VertexHandle b) const {
    int count = 0;
    for (const VertexHandle vh : mesh_.vv_range(a)) count += vh == b ? 1 : 0;
    return count;
  }

  PolyMesh& mesh_;
  FaceEditor& editor_;
  const QuadGeometry& geometry_;
  NearestTriangle nearest_;
  FaceCycles fresh_;
  std::vector<FaceHandle> made_;
};

}  // namespace

std::size_t walk_triangles(PolyMesh& mesh, FaceEditor& editor, const QuadGeometry& geometry,
                           const RunContext& context) {
  return Walk(mesh, editor, geometry).run(context);
}

}  // namespace surfmesh
