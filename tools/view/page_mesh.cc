// SPDX-License-Identifier: BSD-3-Clause
#include "view/page_mesh.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "pictures/scene.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {
namespace {

/// The page holds some 100 bytes for each number up to the greatest: those of any mesh, but not
/// those of a file that is not sound.
constexpr std::size_t kMostPatches = 100'000;

std::uint32_t word(int number) { return static_cast<std::uint32_t>(number); }

/// What a node has besides its vertex.
struct NodeValue {
  int patch = -1;
  Uv uv = {0, 0};
  Metric metric = {0, 0, 0};

  friend bool operator==(const NodeValue&, const NodeValue&) = default;
};

/// Gives each vertex a node for each different value at its corners.
class Nodes {
 public:
  explicit Nodes(std::size_t vertices)
      : values_(vertices), next_(vertices, kNone), has_value_(vertices, 0) {}

  std::uint32_t find(VertexHandle vertex, const NodeValue& value) {
    std::size_t node = index(vertex);
    if (has_value_[node] == 0) {
      has_value_[node] = 1;
      values_[node] = value;
    }
    while (!(values_[node] == value)) {
      if (next_[node] == kNone) return add(node, vertex, value);
      node = next_[node];
    }
    return static_cast<std::uint32_t>(node);
  }

  const std::vector<NodeValue>& values() const { return values_; }
  std::vector<std::uint32_t> take_extra() { return std::move(extra_); }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::uint32_t add(std::size_t last, VertexHandle vertex, const NodeValue& value) {
    next_[last] = values_.size();
    values_.push_back(value);
    next_.push_back(kNone);
    extra_.push_back(word(vertex.idx()));
    return static_cast<std::uint32_t>(next_[last]);
  }

  std::vector<NodeValue> values_;
  std::vector<std::size_t> next_;  ///< the next node of the same vertex
  std::vector<char> has_value_;    ///< of vertices
  std::vector<std::uint32_t> extra_;
};

/// Reads the values of corners, as far as the mesh has them.
class CornerValues {
 public:
  explicit CornerValues(const PolyMesh& mesh)
      : has_uv(has_parameters(mesh)),
        has_metric(has_uv && surfmesh::has_metric(mesh)),
        mesh_(mesh) {}

  NodeValue operator()(FaceHandle fh, HalfedgeHandle corner) const {
    NodeValue value;
    if (!has_uv) return value;
    value.patch = mesh_.property(patch_, fh);
    value.uv = mesh_.property(uv_, corner);
    if (has_metric) value.metric = mesh_.property(metric_, corner);
    return value;
  }

  const bool has_uv;
  const bool has_metric;

 private:
  const PolyMesh& mesh_;
  decltype(keys::face_patch)::Handle patch_ = find(mesh_, keys::face_patch);
  decltype(keys::corner_uv)::Handle uv_ = find(mesh_, keys::corner_uv);
  decltype(keys::corner_metric)::Handle metric_ = find(mesh_, keys::corner_metric);
};

void add_points(const PolyMesh& mesh, const PageOrigins& origins, PageArrays& arrays) {
  std::vector<float> numbers;
  numbers.reserve(3 * mesh.n_vertices());
  for (const VertexHandle vh : mesh.vertices()) {
    const Vec3 point = (to_eigen(mesh.point(vh)) - origins.centre) / origins.radius;
    for (const double x : point) numbers.push_back(static_cast<float>(x));
  }
  arrays.add("points", std::move(numbers));
}

void add_faces(const PolyMesh& mesh, PageArrays& arrays) {
  std::vector<std::uint32_t> sizes(mesh.n_faces());
  for (const FaceHandle fh : mesh.faces()) sizes[index(fh)] = mesh.valence(fh);
  const bool has_others = std::any_of(sizes.begin(), sizes.end(), [](auto n) { return n != 3; });
  if (has_others) arrays.add("sizes", std::move(sizes));
  const auto patch_of = find(mesh, keys::face_patch);
  if (!patch_of.is_valid()) return;
  std::vector<std::uint32_t> patches(mesh.n_faces());
  for (const FaceHandle fh : mesh.faces()) patches[index(fh)] = word(mesh.property(patch_of, fh));
  arrays.add("patch", std::move(patches));
}

void add_node_values(const std::vector<NodeValue>& values, const CornerValues& has,
                     const PageOrigins& origins, PageArrays& arrays) {
  if (!has.has_uv) return;
  std::vector<float> uv, metric;
  for (const auto& [patch, at, m] : values) {
    // Vertices without faces have no patch.
    const Uv origin = patch >= 0 ? origins.of_patches[static_cast<std::size_t>(patch)] : Uv{0, 0};
    for (const double x : {at.u - origin.u, at.v - origin.v}) uv.push_back(static_cast<float>(x));
    for (const double x : {m.m11, m.m12, m.m22}) metric.push_back(static_cast<float>(x));
  }
  arrays.add("uv", std::move(uv));
  if (has.has_metric) arrays.add_shown("metric", std::move(metric));
}

void add_lines(const PolyMesh& mesh, PageArrays& arrays) {
  const auto contour_of = find(mesh, keys::edge_contour);
  const std::vector<char> is_line = contour_edges(mesh);
  std::vector<std::uint32_t> ends, contours;
  for (const EdgeHandle eh : mesh.edges()) {
    if (is_line[index(eh)] == 0) continue;
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    ends.push_back(word(mesh.from_vertex_handle(heh).idx()));
    ends.push_back(word(mesh.to_vertex_handle(heh).idx()));
    if (contour_of.is_valid()) contours.push_back(word(mesh.property(contour_of, eh)));
  }
  arrays.add_steps("lines", std::move(ends));
  if (contour_of.is_valid()) arrays.add("line_contour", std::move(contours));
}

void take_least(Uv uv, Uv& least) {
  if (std::isfinite(uv.u)) least.u = std::isnan(least.u) ? uv.u : std::min(least.u, uv.u);
  if (std::isfinite(uv.v)) least.v = std::isnan(least.v) ? uv.v : std::min(least.v, uv.v);
}

std::vector<Uv> origins_of_patches(const PolyMesh& mesh) {
  std::vector<Uv> origins;
  if (!has_parameters(mesh)) return origins;
  const auto patch_of = find(mesh, keys::face_patch);
  const auto uv_of = find(mesh, keys::corner_uv);
  for (const FaceHandle fh : mesh.faces()) {
    if (mesh.property(patch_of, fh) < 0) continue;
    const auto patch = static_cast<std::size_t>(mesh.property(patch_of, fh));
    if (patch >= origins.size()) origins.resize(patch + 1);
    for (const HalfedgeHandle corner : mesh.fh_range(fh)) {
      take_least(mesh.property(uv_of, corner), origins[patch]);
    }
  }
  for (Uv& origin : origins) {
    if (std::isnan(origin.u) || std::isnan(origin.v)) origin = {0, 0};
  }
  return origins;
}

}  // namespace

void check_patch_numbers(const PolyMesh& mesh, const MeshNames& names) {
  const auto patch_of = find(mesh, keys::face_patch);
  if (!patch_of.is_valid()) return;
  const std::size_t most = std::max({kMostPatches, mesh.n_faces(), names.patches.size()});
  for (const FaceHandle fh : mesh.faces()) {
    const int patch = mesh.property(patch_of, fh);
    if (patch < 0 || static_cast<std::size_t>(patch) < most) continue;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("face {} is on patch {}: a page has no patch of a number above {}",
                            fh.idx(), patch, most - 1));
  }
}

PageOrigins page_origins(const PolyMesh& mesh) {
  PageOrigins origins;
  Eigen::AlignedBox3d box;
  for (const VertexHandle vh : mesh.vertices()) {
    const Vec3 point = to_eigen(mesh.point(vh));
    if (point.allFinite()) box.extend(point);
  }
  if (!box.isEmpty()) origins.centre = box.center();
  if (!box.isEmpty() && box.diagonal().norm() > 0) origins.radius = box.diagonal().norm() / 2;
  origins.of_patches = origins_of_patches(mesh);
  return origins;
}

void add_mesh(const PolyMesh& mesh, const PageOrigins& origins, PageArrays& arrays) {
  add_points(mesh, origins, arrays);
  const CornerValues value(mesh);
  Nodes nodes(mesh.n_vertices());
  std::vector<std::uint32_t> corners;
  corners.reserve(mesh.n_halfedges());
  for (const FaceHandle fh : mesh.faces()) {
    for (const HalfedgeHandle corner : detail::corners_of(mesh, fh)) {
      corners.push_back(nodes.find(mesh.to_vertex_handle(corner), value(fh, corner)));
    }
  }
  arrays.add_steps("corners", std::move(corners));
  add_faces(mesh, arrays);
  add_node_values(nodes.values(), value, origins, arrays);
  arrays.add_steps("extra", nodes.take_extra());
  add_lines(mesh, arrays);
}

}  // namespace surfmesh
