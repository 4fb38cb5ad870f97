// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/project_mesh.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include "surfmesh/core/properties.hh"
#include "surfmesh/quality/face_corners.hh"

namespace surfmesh {
namespace {

using detail::corners_of;
using detail::point_of;

/// Share of the diagonal that is rounding.
constexpr double kRounding = 1e-10;

/// Rounds in which corners learn from neighbours. A region of a wrong sheet shrinks by a row of
/// faces a round.
constexpr int kMostRounds = 100;

/// A name as it is in OBJ files, where blanks are not part of words.
std::string as_word(std::string name) {
  for (char& c : name) c = static_cast<unsigned char>(c) <= ' ' ? '_' : c;
  return name;
}

/// The patches of a model that have the name, or are in the group of the name.
std::vector<int> patches_named(const Model& model, const std::string& name) {
  std::vector<int> patches;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    if (as_word(model.patches[p].name) == as_word(name)) patches.push_back(static_cast<int>(p));
  }
  for (const Group& group : model.groups) {
    if (!patches.empty() || as_word(group.name) != as_word(name)) continue;
    patches = group.patches;
  }
  return patches;
}

class MeshProjection {
 public:
  MeshProjection(PolyMesh& mesh, const std::vector<std::string>& patch_names, const Model& model,
                 const SurfaceSearch& search)
      : mesh_(mesh),
        model_(model),
        search_(search),
        on_surface_(surface_tolerance(mesh, model)),
        meets_itself_(model.patches.size(), 0),
        distances_(mesh.n_halfedges(), 0) {
    for (const std::string& name : patch_names) allowed_.push_back(patches_named(model, name));
    for (const Contour& contour : model.contours) {
      if (contour.uses.size() != 2 || contour.uses[0].patch != contour.uses[1].patch) continue;
      // Where the two sides of a seam are turned against each other, faces end.
      const bool is_oriented = contour.uses[0].is_forward != contour.uses[1].is_forward;
      if (!contour.is_smooth || !is_oriented) continue;
      meets_itself_[static_cast<std::size_t>(contour.uses[0].patch)] = 1;
    }
    has_patches_ = find(mesh, keys::face_patch).is_valid();
    patch_of_ = has_patches_ ? find(mesh, keys::face_patch) : attach(mesh, keys::face_patch);
    detach(mesh, keys::corner_uv);
    uv_of_ = attach(mesh, keys::corner_uv);
    detach(mesh, keys::corner_beyond);
    beyond_ = attach(mesh, keys::corner_beyond, 0);
  }

  void run(const RunContext& context) {
    for (const FaceHandle fh : mesh_.faces()) {
      if (index(fh) % kSearchesBetweenCancellation == 0) context.throw_if_cancelled();
      project(fh);
    }
    learn_from_neighbours(context);
    for (const FaceHandle fh : mesh_.faces()) {
      if (index(fh) % kSearchesBetweenCancellation == 0) context.throw_if_cancelled();
      go_beyond(fh);
    }
  }

 private:
  double& distance(HalfedgeHandle corner) { return distances_[index(corner)]; }

  void take(HalfedgeHandle corner, const NearPoint& near) {
    mesh_.property(uv_of_, corner) = near.uv;
    distance(corner) = near.distance;
  }

  void project(FaceHandle fh) {
    const std::vector<int> all;
    const int group = has_patches_ ? mesh_.property(patch_of_, fh) : -1;
    const bool has_name = group >= 0 && static_cast<std::size_t>(group) < allowed_.size();
    const std::vector<HalfedgeHandle> corners = corners_of(mesh_, fh);
    const NearPoint middle =
        search_.nearest(detail::middle_of(mesh_, corners),
                        has_name ? allowed_[static_cast<std::size_t>(group)] : all);
    mesh_.property(patch_of_, fh) = middle.patch;
    for (const HalfedgeHandle corner : corners) take(corner, project_corner(corner, middle));
  }

  /// A corner of a face: from the face's middle, unless it is much nearer elsewhere on the patch.
  /// At an extraordinary vertex the search from the middle ends short of it; the vertex itself may
  /// be found on the wrong side of a seam.
  NearPoint project_corner(HalfedgeHandle corner, const NearPoint& middle) const {
    const Vec3 point = point_of(mesh_, corner);
    const NearPoint near = find_near_point(model_.surface(middle.patch), point, middle.uv);
    if (near.distance <= on_surface_) return near;
    const NearPoint other = search_.nearest(point, {middle.patch});
    return other.distance < 0.5 * near.distance ? other : near;
  }

  void learn_from_neighbours(const RunContext& context) {
    std::vector<HalfedgeHandle> off;
    for (const HalfedgeHandle heh : mesh_.halfedges()) {
      if (!mesh_.is_boundary(heh) && distance(heh) > on_surface_) off.push_back(heh);
    }
    for (int round = 0; round < kMostRounds; ++round) {
      const std::size_t before = off.size();
      std::size_t asked = 0;
      std::erase_if(off, [&](HalfedgeHandle corner) {
        if (asked++ % kSearchesBetweenCancellation == 0) context.throw_if_cancelled();
        return search_from_neighbours(corner);
      });
      if (off.size() == before) return;
    }
  }

  /// Returns true if the corner is found on the surface.
  bool search_from_neighbours(HalfedgeHandle corner) {
    const FaceHandle fh = mesh_.face_handle(corner);
    const int patch = mesh_.property(patch_of_, fh);
    for (const HalfedgeHandle own : corners_of(mesh_, fh)) {
      if (search_from(own, corner)) return true;
      const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(own);
      if (mesh_.is_boundary(opposite)) continue;
      const FaceHandle beside = mesh_.face_handle(opposite);
      if (mesh_.property(patch_of_, beside) != patch) continue;
      for (const HalfedgeHandle other : corners_of(mesh_, beside)) {
        if (search_from(other, corner)) return true;
      }
    }
    return false;
  }

  /// Search from a corner that lies on the surface.
  bool search_from(HalfedgeHandle start, HalfedgeHandle corner) {
    if (distance(start) > on_surface_) return false;
    const int patch = mesh_.property(patch_of_, mesh_.face_handle(corner));
    const NearPoint near = find_near_point(model_.surface(patch), point_of(mesh_, corner),
                                           mesh_.property(uv_of_, start), {.enough = on_surface_});
    if (near.distance > on_surface_) return false;
    take(corner, near);
    return true;
  }

  /// Corners that lie on another patch than the rest of their face, or beyond a seam of it, get the
  /// (u,v) to which the tangent planes at the others lead.
  void go_beyond(FaceHandle fh) {
    const std::vector<HalfedgeHandle> corners = corners_of(mesh_, fh);
    const auto first = std::find_if(corners.begin(), corners.end(), [this](HalfedgeHandle corner) {
      return distance(corner) <= on_surface_;
    });
    if (first == corners.end()) return;
    const auto is_off = [&](HalfedgeHandle corner) {
      return distance(corner) > on_surface_ || is_beyond_seam(*first, corner);
    };
    const auto off = std::count_if(corners.begin(), corners.end(), is_off);
    if (off == 0) return;
    const int patch = mesh_.property(patch_of_, fh);
    const Surface& surface = model_.surface(patch);
    std::vector<HalfedgeHandle> on;
    std::remove_copy_if(corners.begin(), corners.end(), std::back_inserter(on), is_off);
    for (const HalfedgeHandle corner : corners) {
      const Vec3 point = point_of(mesh_, corner);
      if (!is_off(corner) ||
          search_.nearest_around(point, std::span(&patch, 1), on_surface_).distance > on_surface_) {
        continue;
      }
      Uv sum{0, 0};
      for (const HalfedgeHandle from : on) sum = sum + continued(surface, from, point);
      mesh_.property(uv_of_, corner) = 1 / static_cast<double>(on.size()) * sum;
      mesh_.property(beyond_, corner) = 1;
    }
  }

  /// True if two corners of a face are more than half of the domain apart, of a patch that meets
  /// itself at a smooth contour.
  bool is_beyond_seam(HalfedgeHandle a, HalfedgeHandle b) const {
    const int patch = mesh_.property(patch_of_, mesh_.face_handle(a));
    if (meets_itself_[static_cast<std::size_t>(patch)] == 0) return false;
    const Domain domain = model_.surface(patch).domain();
    const Uv step = mesh_.property(uv_of_, b) - mesh_.property(uv_of_, a);
    return std::abs(step.u) > 0.5 * (domain.u1 - domain.u0) ||
           std::abs(step.v) > 0.5 * (domain.v1 - domain.v0);
  }

  /// Where the tangent plane at a corner leads to a point; the corner itself if there is none.
  Uv continued(const Surface& surface, HalfedgeHandle from, const Vec3& point) const {
    const Uv uv = mesh_.property(uv_of_, from);
    const Jet jet = surface.evaluate(uv, Order::First);
    const Vec3 step = point - jet.point;
    const double e = jet.du.squaredNorm(), f = jet.du.dot(jet.dv), g = jet.dv.squaredNorm();
    const double determinant = e * g - f * f;
    if (!(determinant > 0)) return uv;
    const double a = jet.du.dot(step), b = jet.dv.dot(step);
    return uv + Uv{(g * a - f * b) / determinant, (e * b - f * a) / determinant};
  }

  PolyMesh& mesh_;
  const Model& model_;
  const SurfaceSearch& search_;
  double on_surface_;
  std::vector<char> meets_itself_;  ///< by patch
  std::vector<double> distances_;   ///< of corners from the surface, by halfedge
  std::vector<std::vector<int>> allowed_;
  bool has_patches_ = false;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  decltype(keys::corner_beyond)::Handle beyond_;
};

}  // namespace

double surface_tolerance(const PolyMesh& mesh, const Model& model) {
  constexpr double single = std::numeric_limits<float>::epsilon();
  double greatest = 0;
  for (const VertexHandle vh : mesh.vertices()) {
    const Vec3 point = to_eigen(mesh.point(vh));
    if (point.cast<float>().cast<double>() != point) return kRounding * model.diagonal;
    greatest = std::max(greatest, point.cwiseAbs().maxCoeff());
  }
  return std::max(kRounding * model.diagonal, 2 * single * greatest);
}

void project_mesh(PolyMesh& mesh, const std::vector<std::string>& patch_names, const Model& model,
                  const SurfaceSearch& search, const RunContext& context) {
  MeshProjection(mesh, patch_names, model, search).run(context);
}

}  // namespace surfmesh
