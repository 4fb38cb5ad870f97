// SPDX-License-Identifier: BSD-3-Clause
#include "compare/remesh_judge.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/quality/contour_distance.hh"
#include "surfmesh/quality/face_set_check.hh"
#include "surfmesh/quality/mesh_extent.hh"
#include "surfmesh/quality/self_intersections.hh"

namespace surfmesh::compare {
namespace {

constexpr std::size_t kMostMeasured = 20000;  // of facets, and of vertices

/// Share of the diagonal by which chords of creases may be off: below any distance that matters.
constexpr double kFeatureTolerance = 1e-5;

/// The cosine of 120°: across a crease a good facet may be at more than 90° to one of its sides.
constexpr double kTurnedCosine = -0.5;

/// Share of the longest side of a facet from which on it does not tell where its surface is.
constexpr double kFarAway = 0.25;

ModelInput load_truth(const std::filesystem::path& cage) {
  LoadOptions options;
  options.cages.surface = SurfaceKind::Limit;
  return load_model(cage, options);
}

double quality(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return sides > 0 ? 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / sides : 0;
}

/// Calls `visit` with the corners of the triangles that a face is for its quality.
template <class Visitor>
void for_each_part(const std::vector<Vec3>& points, std::span<const int> face, Visitor visit) {
  const auto at = [&](std::size_t i) -> const Vec3& {
    return points[static_cast<std::size_t>(face[i % face.size()])];
  };
  const bool is_turned =
      face.size() == 4 && (at(3) - at(1)).squaredNorm() < (at(2) - at(0)).squaredNorm();
  const std::size_t first = is_turned ? 1 : 0;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    visit(at(first), at(first + i), at(first + i + 1));
  }
}

void measure_quality(const MeshArrays& mesh, RemeshJudgement& judgement) {
  double least = std::numeric_limits<double>::infinity(), sum = 0;
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for_each_part(mesh.points, mesh.faces[f], [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      const double q = quality(a, b, c);
      least = std::min(least, q);
      sum += q;
      ++count;
    });
  }
  judgement.least_quality = least;
  judgement.mean_quality = sum / static_cast<double>(count);
}

void measure_topology(const MeshArrays& mesh, RemeshJudgement& judgement) {
  const FaceSetCheck check = check_face_set(mesh);
  judgement.euler = check.euler;
  judgement.components = check.components;
  judgement.boundary_loops = check.boundary_loops;
  for (const MeshFault& fault : check.faults) {
    if (!judgement.faults.empty()) judgement.faults += ", ";
    judgement.faults += fault.kind;
  }
}

std::array<Vec3, 3> corners_of(const Facets& facets, std::size_t triangle) {
  std::array<Vec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = facets.points[static_cast<std::size_t>(facets.triangles[triangle][i])];
  }
  return corners;
}

/// Normal to a triangle, with twice its area as its length.
Vec3 area_of(const std::array<Vec3, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

double longest_side(const std::array<Vec3, 3>& corners) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, (corners[(i + 1) % 3] - corners[i]).norm());
  }
  return longest;
}

/// By point, the areas of the triangles around it, in some unit.
std::vector<double> areas_around(const Facets& facets) {
  std::vector<double> areas(facets.points.size(), 0.0);
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    const double area = area_of(corners_of(facets, t)).norm();
    for (const int point : facets.triangles[t]) areas[static_cast<std::size_t>(point)] += area;
  }
  return areas;
}

/// How many steps lie between those that are measured.
std::size_t stride(std::size_t count) { return (count + kMostMeasured - 1) / kMostMeasured; }

/// Counts facets by the side of the surface on which their normals are.
struct Sides {
  std::size_t with = 0;
  std::size_t against = 0;

  void add(const Vec3& area, const Jet& jet) {
    const double cosine = area.stableNormalized().dot(jet.du.cross(jet.dv).stableNormalized());
    if (cosine < kTurnedCosine) ++against;
    if (cosine > -kTurnedCosine) ++with;
  }
};

}  // namespace

bool RemeshJudgement::has_topology_of(const RemeshJudgement& other) const {
  return euler == other.euler && components == other.components &&
         boundary_loops == other.boundary_loops && faults == other.faults;
}

RemeshJudge::RemeshJudge(const std::filesystem::path& cage)
    : input_(load_truth(cage)),
      search_(input_.model),
      features_(sharp_contours(input_.model, kFeatureTolerance * input_.model.diagonal)) {}

RemeshJudgement RemeshJudge::judge(const std::filesystem::path& mesh) const {
  MeshArraysFile file = read_mesh_arrays(mesh);
  RemeshJudgement judgement;
  judgement.faces = file.mesh.faces.size();
  judgement.area = measure_extent(file.mesh).area;
  judgement.mean_edge = measure_shape(file.mesh).mean_edge;
  measure_quality(file.mesh, judgement);
  measure_topology(file.mesh, judgement);
  judgement.crossings = find_self_intersections(file.mesh).count;
  const MeshFile poly = mesh_from(std::move(file), mesh.string());
  const Facets facets = facets_of(poly.mesh);
  measure_vertices(facets, poly.mesh.n_vertices(), judgement);
  measure_facets(facets, judgement);
  measure_back(poly.mesh, judgement);
  return judgement;
}

void RemeshJudge::measure_vertices(const Facets& facets, std::size_t count,
                                   RemeshJudgement& judgement) const {
  const std::vector<double> areas = areas_around(facets);
  Distances& found = judgement.vertices;
  double weighted = 0, all = 0;
  for (std::size_t i = 0; i < count; i += stride(count)) {
    const double distance = search_.nearest(facets.points[i]).distance / diagonal();
    found.max = std::max(found.max, distance);
    weighted += areas[i] * distance;
    all += areas[i];
  }
  if (all > 0) found.mean = weighted / all;
}

void RemeshJudge::measure_facets(const Facets& facets, RemeshJudgement& judgement) const {
  Distances& found = judgement.facets;
  Sides sides;
  double weighted = 0, all = 0;
  const std::size_t step = stride(facets.triangles.size());
  for (std::size_t t = 0; t < facets.triangles.size(); t += step) {
    const std::array<Vec3, 3> corner = corners_of(facets, t);
    const Vec3 area = area_of(corner);
    const auto measure = [&](const Vec3& point, double weight) {
      const NearPoint near = search_.nearest(point);
      const double distance = near.distance / diagonal();
      found.max = std::max(found.max, distance);
      weighted += weight * area.norm() * distance;
      return near;
    };
    // The rule of seven points that is exact for cubic polynomials.
    constexpr double kAtCorner = 1.0 / 20, kAtSide = 2.0 / 15, kAtMiddle = 9.0 / 20;
    for (std::size_t i = 0; i < 3; ++i) {
      measure(corner[i], kAtCorner);
      measure((corner[i] + corner[(i + 1) % 3]) / 2, kAtSide);
    }
    const NearPoint middle = measure((corner[0] + corner[1] + corner[2]) / 3, kAtMiddle);
    all += area.norm();
    const Surface& surface = *input_.model.patches[static_cast<std::size_t>(middle.patch)].surface;
    if (middle.distance > kFarAway * longest_side(corner)) continue;
    sides.add(area, surface.evaluate(middle.uv, Order::First));
  }
  if (all > 0) found.mean = weighted / all;
  // A mesh that is turned over as a whole is as good.
  judgement.turned = step * std::min(sides.with, sides.against);
}

void RemeshJudge::measure_back(const PolyMesh& mesh, RemeshJudgement& judgement) const {
  if (const auto back = measure_surface_to_mesh(search_, mesh)) {
    judgement.from_surface = {back->mean / diagonal(), back->max / diagonal()};
  }
  for (const ContourDistance& far : far_contour_points(mesh, features_, 0)) {
    judgement.features = std::max(judgement.features, far.distance / diagonal());
  }
}

}  // namespace surfmesh::compare
