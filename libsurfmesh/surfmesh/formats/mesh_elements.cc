// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/mesh_elements.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/shared_vertices.hh"
#include "surfmesh/formats/split_face.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/quality/face_corners.hh"

namespace surfmesh {
namespace {

/// A file has one entity for each patch or contour up to the greatest, whose number must fit.
constexpr int kMostEntities = 10'000'000;

/// Cosine of the angle between the normals of two faces above which their edge is not smooth: 30°.
/// Coarse meshes of smooth surfaces stay below, edges of machine parts are above.
constexpr double kSmoothCosine = 0.8660254037844387;

bool is_smooth(const PolyMesh& mesh, HalfedgeHandle heh) {
  const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(heh);
  if (mesh.is_boundary(heh) || mesh.is_boundary(opposite)) return true;
  const auto normal = [&](HalfedgeHandle side) {
    return detail::double_area_of(mesh, detail::corners_of(mesh, mesh.face_handle(side)));
  };
  const Vec3 a = normal(heh), b = normal(opposite);
  return a.dot(b) >= kSmoothCosine * a.norm() * b.norm();
}

/// Elements of one number of corners in the order of the mesh, with their patches.
template <std::size_t corners>
struct ElementList {
  std::vector<std::array<int, corners>> elements;
  std::vector<int> patches;

  void add(const std::array<int, corners>& element, int patch) {
    elements.push_back(element);
    patches.push_back(patch);
  }

  /// The place of a patch, behind all others for none.
  static std::size_t slot(int patch, std::size_t count) {
    return patch < 0 ? count : static_cast<std::size_t>(patch);
  }

  /// Bring the elements into the order of `count` patches. Returns the first of each, with the
  /// number of all at the end.
  std::vector<std::size_t> sort(std::size_t count) {
    std::vector<std::size_t> first(count + 2, 0);
    for (const int patch : patches) ++first[slot(patch, count) + 1];
    for (std::size_t s = 1; s < first.size(); ++s) first[s] += first[s - 1];
    const auto less = [&](int a, int b) { return slot(a, count) < slot(b, count); };
    if (std::is_sorted(patches.begin(), patches.end(), less)) return first;
    std::vector<std::size_t> next = first;
    std::vector<std::array<int, corners>> sorted(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      sorted[next[slot(patches[i], count)]++] = elements[i];
    }
    elements = std::move(sorted);
    return first;
  }
};

/// Collects the faces of a mesh as elements.
class FaceCollector {
 public:
  FaceCollector(const PolyMesh& mesh, std::string_view ending)
      : mesh_(mesh), patch_of_(find(mesh, keys::face_patch)) {
    triangles_.elements.reserve(mesh.n_faces());
    triangles_.patches.reserve(mesh.n_faces());
    for (const FaceHandle fh : mesh.faces()) add(fh);
    check_number(greatest_, "a face is of patch", ending);
  }

  void finish(MeshElements& result) {
    const SharedVertices vertices(mesh_);
    const auto count = static_cast<std::size_t>(greatest_ + 1);
    const auto triangles = triangles_.sort(count);
    const auto quads = quads_.sort(count);
    for (std::size_t s = 0; s <= count; ++s) {
      PatchElements patch{s == count ? -1 : static_cast<int>(s),
                          {triangles[s], triangles[s + 1]},
                          {quads[s], quads[s + 1]}};
      if (patch.size() > 0) result.patches.push_back(patch);
    }
    result.triangles = numbered(vertices, std::move(triangles_.elements));
    result.quads = numbered(vertices, std::move(quads_.elements));
  }

 private:
  void add(FaceHandle fh) {
    face_.clear();
    for_each_vertex_of(mesh_, fh, [&](int vertex) { face_.push_back(vertex); });
    const int patch = patch_of_.is_valid() ? std::max(-1, mesh_.property(patch_of_, fh)) : -1;
    greatest_ = std::max(greatest_, patch);
    if (face_.size() == 3) return triangles_.add({face_[0], face_[1], face_[2]}, patch);
    if (face_.size() == 4) return quads_.add({face_[0], face_[1], face_[2], face_[3]}, patch);
    parts_.clear();
    split_face(mesh_, face_, parts_);
    for (const auto& part : parts_) triangles_.add(part, patch);
  }

  template <class Elements>
  static Elements numbered(const SharedVertices& vertices, Elements elements) {
    for (auto& element : elements) {
      for (int& vertex : element) vertex = vertices.number(vertex);
    }
    return elements;
  }

  const PolyMesh& mesh_;
  decltype(keys::face_patch)::Handle patch_of_;
  ElementList<3> triangles_;
  ElementList<4> quads_;
  int greatest_ = -1;
  std::vector<int> face_;
  std::vector<std::array<int, 3>> parts_;
};

void collect_points(const PolyMesh& mesh, MeshElements& result) {
  const SharedVertices vertices(mesh);
  result.points.reserve(vertices.count());
  for (const VertexHandle vh : mesh.vertices()) {
    if (!vertices.is_first(vh)) continue;
    check_finite(mesh.point(vh), vh);
    result.points.push_back(to_eigen(mesh.point(vh)));
  }
}

/// Copies of vertices have copies of edges.
void collect_segments(const PolyMesh& mesh, std::string_view ending, MeshElements& result) {
  const auto contour_of = find(mesh, keys::edge_contour);
  if (!contour_of.is_valid()) return;
  const SharedVertices vertices(mesh);
  std::vector<ContourSegment>& segments = result.segments;
  for (const EdgeHandle eh : mesh.edges()) {
    const int contour = mesh.property(contour_of, eh);
    if (contour < 0) continue;
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    const int from = vertices.number(mesh.from_vertex_handle(heh).idx());
    const int to = vertices.number(mesh.to_vertex_handle(heh).idx());
    segments.push_back({contour, std::min(from, to), std::max(from, to), is_smooth(mesh, heh)});
  }
  std::sort(segments.begin(), segments.end());
  // Those that are not smooth come first.
  const auto is_same = [](const ContourSegment& a, const ContourSegment& b) {
    return std::tie(a.contour, a.from, a.to) == std::tie(b.contour, b.from, b.to);
  };
  segments.erase(std::unique(segments.begin(), segments.end(), is_same), segments.end());
  if (!segments.empty()) check_number(segments.back().contour, "an edge is on contour", ending);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (s == 0 || segments[s].contour != segments[s - 1].contour) {
      result.contours.push_back({segments[s].contour, {s, s}});
    }
    result.contours.back().segments.end = s + 1;
  }
}

}  // namespace

void check_number(int number, std::string_view what, std::string_view ending) {
  if (number <= kMostEntities) return;
  throw Error(ErrorCode::InvalidInput, fmt::format("{} {}, but {} files hold them up to {}", what,
                                                   number, ending, kMostEntities));
}

MeshElements mesh_elements(const PolyMesh& mesh, std::string_view ending) {
  MeshElements result;
  collect_points(mesh, result);
  FaceCollector(mesh, ending).finish(result);
  collect_segments(mesh, ending, result);
  return result;
}

std::vector<char> contour_ends(const MeshElements& elements) {
  std::vector<int> segments_at(elements.points.size(), 0);
  std::vector<int> contour_at(elements.points.size(), -1);
  std::vector<char> is_end(elements.points.size(), 0);
  for (const ContourSegment& segment : elements.segments) {
    for (const int vertex : {segment.from, segment.to}) {
      const auto v = static_cast<std::size_t>(vertex);
      if (segments_at[v]++ == 0) contour_at[v] = segment.contour;
      if (contour_at[v] != segment.contour) is_end[v] = 1;
    }
  }
  for (std::size_t v = 0; v < is_end.size(); ++v) {
    if (segments_at[v] > 0 && segments_at[v] != 2) is_end[v] = 1;
  }
  return is_end;
}

std::vector<int> nodes_of(const MeshElements& elements, const ContourElements& contour) {
  std::vector<int> nodes;
  for (std::size_t s = contour.segments.first; s < contour.segments.end; ++s) {
    nodes.push_back(elements.segments[s].from);
    nodes.push_back(elements.segments[s].to);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void add_lost_sets(const PolyMesh& mesh, const MeshNames& names, std::vector<std::string>& lost) {
  if (const auto contours = find(mesh, keys::edge_contour); contours.is_valid()) {
    lost.push_back("the contours of the edges, but for the vertices of those with names");
  }
  const auto patch_of = find(mesh, keys::face_patch);
  if (!patch_of.is_valid()) return;
  const std::vector<int>& of_faces = mesh.property(patch_of).data_vector();
  const std::unordered_set<int> used(of_faces.begin(), of_faces.end());
  std::size_t count = 0;
  for (std::size_t p = 0; p < names.patches.size(); ++p) {
    count += !names.patches[p].empty() && !used.contains(static_cast<int>(p)) ? 1 : 0;
  }
  for (const Group& group : names.groups) {
    const bool has_faces = std::any_of(group.patches.begin(), group.patches.end(),
                                       [&](int patch) { return used.contains(patch); });
    count += has_faces ? 0 : 1;
  }
  if (count > 0) lost.push_back(fmt::format("{} names of patches and groups without faces", count));
}

void add_lost_digits(const PolyMesh& mesh, std::size_t width, RealStyle style,
                     std::vector<std::string>& lost) {
  double greatest = 0, largest = 0;
  for (const VertexHandle vh : mesh.vertices()) {
    for (const double x : mesh.point(vh)) {
      if (!std::isfinite(x)) continue;  // is no mesh to write
      largest = std::max(largest, std::abs(x));
      greatest = std::max(greatest, std::abs(ShortReal(x, width, style).value() - x));
    }
  }
  if (!(greatest > std::numeric_limits<double>::epsilon() * largest)) return;
  lost.push_back(
      fmt::format("the digits of coordinates beyond {} characters: they change by up to {:.3g}",
                  width, greatest));
}

}  // namespace surfmesh
