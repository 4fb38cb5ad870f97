// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/smooth_regions.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/quad_topology.hh"
#include "surfmesh/quality/face_corners.hh"

namespace surfmesh {
namespace {

/// Rings of faces around a contour, or an edge between pieces, that may change.
constexpr int kRings = 3;

/// Cosine of the angle between two faces from which their edge stays: the surface is rounded there
/// within less than an element, as at a semi-sharp crease, and elements that do not follow the edge
/// would cut it off.
constexpr double kSharpEdge = 0.5;

/// Faces of a piece, about: enough that few lie at its border.
constexpr std::size_t kMostFaces = 8192;

/// How far from a side that is a pole, as a share of it, a corner counts as on it: the rounding of
/// parameters.
constexpr double kAtPole = 1e-9;

Vec3 normal_of(const PolyMesh& mesh, FaceHandle fh) {
  return detail::double_area_of(mesh, detail::corners_of(mesh, fh)).stableNormalized();
}

/// True if two faces make a sharp angle, or one ends there.
bool is_sharp(const PolyMesh& mesh, EdgeHandle eh) {
  if (mesh.is_boundary(eh)) return true;
  const FaceHandle a = mesh.face_handle(mesh.halfedge_handle(eh, 0));
  const FaceHandle b = mesh.face_handle(mesh.halfedge_handle(eh, 1));
  return normal_of(mesh, a).dot(normal_of(mesh, b)) < kSharpEdge;
}

/// Choose the faces around vertices, then around theirs, ring by ring.
void choose_rings(const PolyMesh& mesh, std::vector<char> is_near, std::vector<char>& is_chosen) {
  for (int ring = 0; ring < kRings; ++ring) {
    std::vector<FaceHandle> fresh;
    for (const FaceHandle fh : mesh.faces()) {
      if (is_chosen[index(fh)] != 0) continue;
      for_each_vertex_of(mesh, fh, [&](int vertex) {
        if (is_near[static_cast<std::size_t>(vertex)] != 0) is_chosen[index(fh)] = 1;
      });
      if (is_chosen[index(fh)] != 0) fresh.push_back(fh);
    }
    for (const FaceHandle fh : fresh) {
      for_each_vertex_of(mesh, fh,
                         [&](int vertex) { is_near[static_cast<std::size_t>(vertex)] = 1; });
    }
  }
}

/// A range of vertices as marks, by vertex.
std::vector<char> marked(const VertexRange& range, std::size_t count) {
  std::vector<char> is_marked(count, 0);
  std::fill(is_marked.begin() + range.first, is_marked.begin() + range.end, 1);
  return is_marked;
}

/// The sides of patches that are poles.
class PoleSides {
 public:
  explicit PoleSides(const Model& model) : sides_(model.patches.size()) {
    for (const Contour& contour : model.contours) {
      if (!contour.is_degenerate) continue;
      for (const ContourUse& use : contour.uses) {
        sides_[static_cast<std::size_t>(use.patch)].push_back(
            {use.curve->evaluate(0), use.curve->evaluate(1)});
      }
    }
  }

  bool is_on_pole(int patch, Uv uv) const {
    const auto& sides = sides_[static_cast<std::size_t>(patch)];
    return std::any_of(sides.begin(), sides.end(), [uv](const std::pair<Uv, Uv>& side) {
      const Uv along = side.second - side.first, to = uv - side.first;
      const double squared = along.u * along.u + along.v * along.v;
      const double share = (to.u * along.u + to.v * along.v) / squared;
      return share >= -kAtPole && share <= 1 + kAtPole &&
             std::abs(cross(along, to)) <= kAtPole * squared;
    });
  }

  bool empty(int patch) const { return sides_[static_cast<std::size_t>(patch)].empty(); }

 private:
  std::vector<std::vector<std::pair<Uv, Uv>>> sides_;  ///< by patch
};

void leave_out_poles(const PolyMesh& result, const Model& model, std::vector<char>& is_chosen) {
  const auto patch_of = require(result, keys::face_patch);
  const auto uv_of = require(result, keys::corner_uv);
  const PoleSides poles(model);
  for (const FaceHandle fh : result.faces()) {
    const int patch = result.property(patch_of, fh);
    if (poles.empty(patch)) continue;
    for_each_corner(result, fh, [&](HalfedgeHandle corner) {
      if (poles.is_on_pole(patch, result.property(uv_of, corner))) is_chosen[index(fh)] = 0;
    });
  }
}

void choose_patches(const PolyMesh& result, const Model& model,
                    const std::vector<char>& is_dissolved, std::vector<char>& is_chosen) {
  const auto patch_of = require(result, keys::face_patch);
  std::vector<char> is_open(model.patches.size(), 0);
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    if (is_dissolved[c] == 0) continue;
    for (const ContourUse& use : model.contours[c].uses) {
      is_open[static_cast<std::size_t>(use.patch)] = 1;
    }
  }
  for (const FaceHandle fh : result.faces()) {
    is_chosen[index(fh)] = is_open[static_cast<std::size_t>(result.property(patch_of, fh))];
  }
}

/// The faces that are left, in parts that edges connect which are not held.
std::vector<FacePiece> connected_parts(const PolyMesh& mesh, std::vector<char> is_left,
                                       const std::vector<char>& is_held) {
  std::vector<FacePiece> parts;
  for (const FaceHandle fh : mesh.faces()) {
    if (is_left[index(fh)] == 0) continue;
    FacePiece& part = parts.emplace_back(FacePiece{fh});
    is_left[index(fh)] = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for_each_corner(mesh, part[i], [&](HalfedgeHandle heh) {
        const FaceHandle beyond = mesh.face_handle(mesh.opposite_halfedge_handle(heh));
        if (!beyond.is_valid() || is_left[index(beyond)] == 0 ||
            is_held[index(mesh.edge_handle(heh))] != 0) {
          return;
        }
        is_left[index(beyond)] = 0;
        part.push_back(beyond);
      });
    }
  }
  return parts;
}

/// A face and where it is.
struct PlacedFace {
  FaceHandle face;
  Vec3 middle;
};

using PlacedFaces = std::vector<PlacedFace>::iterator;

/// Halve faces along the longest side of their box until they are few.
void halve(PlacedFaces first, PlacedFaces last, std::vector<FacePiece>& pieces) {
  const auto count = static_cast<std::size_t>(last - first);
  if (count <= kMostFaces) {
    FacePiece& piece = pieces.emplace_back();
    for (auto it = first; it != last; ++it) piece.push_back(it->face);
    return;
  }
  Eigen::AlignedBox3d box;
  for (auto it = first; it != last; ++it) box.extend(it->middle);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle = first + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(first, middle, last, [axis](const PlacedFace& a, const PlacedFace& b) {
    return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.face < b.face;
  });
  halve(first, middle, pieces);
  halve(middle, last, pieces);
}

}  // namespace

SmoothRegions choose_regions(const PolyMesh& result, const Model& model,
                             const std::vector<char>& is_dissolved,
                             const VertexRange& between_tiles) {
  const auto contour_of = require(result, keys::edge_contour);
  SmoothRegions regions;
  regions.is_held.assign(result.n_edges(), 0);
  regions.is_chosen.assign(result.n_faces(), 0);
  std::vector<char> is_near(result.n_vertices(), 0);
  for (const EdgeHandle eh : result.edges()) {
    const int contour = result.property(contour_of, eh);
    if (contour < 0) continue;
    if (is_dissolved[static_cast<std::size_t>(contour)] == 0 || is_sharp(result, eh)) {
      regions.is_held[index(eh)] = 1;
      continue;
    }
    const HalfedgeHandle heh = result.halfedge_handle(eh, 0);
    is_near[index(result.from_vertex_handle(heh))] = 1;
    is_near[index(result.to_vertex_handle(heh))] = 1;
  }
  if (has_quads(result)) {
    choose_patches(result, model, is_dissolved, regions.is_chosen);
    choose_rings(result, marked(between_tiles, result.n_vertices()), regions.is_chosen);
  } else {
    choose_rings(result, std::move(is_near), regions.is_chosen);
  }
  leave_out_poles(result, model, regions.is_chosen);
  return regions;
}

SmoothRegions choose_all(const PolyMesh& result, const Model& model) {
  const auto contour_of = require(result, keys::edge_contour);
  SmoothRegions regions;
  regions.is_chosen.assign(result.n_faces(), 1);
  for (const EdgeHandle eh : result.edges()) {
    regions.is_held.push_back(result.property(contour_of, eh) >= 0);
  }
  leave_out_poles(result, model, regions.is_chosen);
  return regions;
}

std::vector<FacePiece> divide_in_pieces(const PolyMesh& result, const SmoothRegions& regions) {
  std::vector<FacePiece> pieces;
  FacePiece small;
  for (FacePiece& part : connected_parts(result, regions.is_chosen, regions.is_held)) {
    if (part.size() > kMostFaces) {
      std::vector<PlacedFace> faces;
      for (const FaceHandle fh : part) {
        faces.push_back({fh, to_eigen(result.calc_face_centroid(fh))});
      }
      halve(faces.begin(), faces.end(), pieces);
      continue;
    }
    small.insert(small.end(), part.begin(), part.end());
    if (small.size() < kMostFaces) continue;
    pieces.push_back(std::move(small));
    small.clear();
  }
  if (!small.empty()) pieces.push_back(std::move(small));
  for (FacePiece& piece : pieces) std::sort(piece.begin(), piece.end());
  return pieces;
}

std::vector<FacePiece> parts_of(const PolyMesh& result, const FacePiece& piece,
                                const std::vector<char>& is_held) {
  std::vector<char> is_left(result.n_faces(), 0);
  for (const FaceHandle fh : piece) is_left[index(fh)] = 1;
  std::vector<FacePiece> parts = connected_parts(result, std::move(is_left), is_held);
  for (FacePiece& part : parts) std::sort(part.begin(), part.end());
  return parts;
}

std::vector<FacePiece> pieces_along(const PolyMesh& result, const std::vector<char>& is_chosen,
                                    const std::vector<char>& is_held,
                                    const std::vector<VertexHandle>& seam) {
  std::vector<char> is_near(result.n_vertices(), 0), is_taken(result.n_faces(), 0);
  for (const VertexHandle vh : seam) is_near[index(vh)] = 1;
  choose_rings(result, std::move(is_near), is_taken);
  for (std::size_t f = 0; f < is_taken.size(); ++f) is_taken[f] &= is_chosen[f];
  std::vector<FacePiece> pieces = connected_parts(result, std::move(is_taken), is_held);
  for (FacePiece& piece : pieces) std::sort(piece.begin(), piece.end());
  return pieces;
}

}  // namespace surfmesh
