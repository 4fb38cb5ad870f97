// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/facet_distance.hh"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

/// Weights of corners, middles of sides and the centre of a triangle, by which polynomials of
/// degree 3 are integrated exactly.
constexpr double kCorner = 1.0 / 20, kMiddle = 2.0 / 15, kCentre = 9.0 / 20;

/// Adds polygons to facets.
class FacetCollector {
 public:
  explicit FacetCollector(std::vector<Vec3> points) { facets_.points = std::move(points); }

  void add(const std::vector<int>& polygon, int face) {
    if (polygon.size() == 3) return add_triangle(polygon[0], polygon[1], polygon[2], face);
    Vec3 sum = Vec3::Zero();
    for (const int v : polygon) sum += facets_.points[static_cast<std::size_t>(v)];
    const auto middle = static_cast<int>(facets_.points.size());
    facets_.points.push_back(sum / static_cast<double>(polygon.size()));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      add_triangle(polygon[i], polygon[(i + 1) % polygon.size()], middle, face);
    }
  }

  Facets finish() { return std::move(facets_); }

 private:
  void add_triangle(int a, int b, int c, int face) {
    facets_.triangles.push_back({a, b, c});
    facets_.faces.push_back(face);
  }

  Facets facets_;
};

bool counts(const Patch& patch, FacetsOf which) {
  return patch.cage != nullptr && (which == FacetsOf::AllCages || patch.is_interpolating);
}

/// Points at which facets are compared with others, and what they have to say for the mean.
class FacetSamples {
 public:
  explicit FacetSamples(const Facets& facets) {
    add_corners(facets);
    add_sides(facets);
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
      const auto [a, b, c] = corners(facets, t);
      add((a + b + c) / 3, kCentre * area(facets, t), facets.faces[t]);
    }
  }

  std::size_t size() const { return points_.size(); }
  const Vec3& point(std::size_t i) const { return points_[i]; }
  double weight(std::size_t i) const { return weights_[i]; }
  int face(std::size_t i) const { return faces_[i]; }

 private:
  static std::array<Vec3, 3> corners(const Facets& facets, std::size_t t) {
    const auto& [a, b, c] = facets.triangles[t];
    return {facets.points[static_cast<std::size_t>(a)], facets.points[static_cast<std::size_t>(b)],
            facets.points[static_cast<std::size_t>(c)]};
  }

  static double area(const Facets& facets, std::size_t t) {
    const auto [a, b, c] = corners(facets, t);
    return 0.5 * (b - a).cross(c - a).norm();
  }

  void add(const Vec3& point, double weight, int face) {
    points_.push_back(point);
    weights_.push_back(weight);
    faces_.push_back(face);
  }

  void add_corners(const Facets& facets) {
    std::vector<int> sample_of(facets.points.size(), -1);
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
      for (const int v : facets.triangles[t]) {
        int& sample = sample_of[static_cast<std::size_t>(v)];
        if (sample < 0) {
          sample = static_cast<int>(points_.size());
          add(facets.points[static_cast<std::size_t>(v)], 0, facets.faces[t]);
        }
        weights_[static_cast<std::size_t>(sample)] += kCorner * area(facets, t);
      }
    }
  }

  /// A side that several triangles share is one sample.
  void add_sides(const Facets& facets) {
    struct SideOfTriangle {
      int low, high;
      std::size_t triangle;
    };
    std::vector<SideOfTriangle> sides;
    sides.reserve(3 * facets.triangles.size());
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] =
            std::minmax(facets.triangles[t][i], facets.triangles[t][(i + 1) % 3]);
        sides.push_back({low, high, t});
      }
    }
    std::sort(sides.begin(), sides.end(), [](const SideOfTriangle& a, const SideOfTriangle& b) {
      return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const SideOfTriangle& side = sides[i];
      if (i == 0 || side.low != sides[i - 1].low || side.high != sides[i - 1].high) {
        add((facets.points[static_cast<std::size_t>(side.low)] +
             facets.points[static_cast<std::size_t>(side.high)]) /
                2,
            0, facets.faces[side.triangle]);
      }
      weights_.back() += kMiddle * area(facets, side.triangle);
    }
  }

  std::vector<Vec3> points_;
  std::vector<double> weights_;
  std::vector<int> faces_;
};

/// The nearest triangle of each point. Points that follow each other are near each other, so each
/// begins where the last one ended.
template <class PointAt>
std::vector<TriangleTree::Nearest> find_nearest(const TriangleTree& tree, std::size_t count,
                                                const PointAt& point_at,
                                                const RunContext& context) {
  std::vector<TriangleTree::Nearest> nearest(count);
  share_ranges(count, [&](std::size_t first, std::size_t end) {
    std::size_t guess = 0;
    for (std::size_t i = first; i < end; ++i) {
      if (i % kSearchesBetweenCancellation == 0) context.throw_if_cancelled();
      nearest[i] = tree.nearest(point_at(i), guess);
      guess = nearest[i].triangle;
    }
  });
  return nearest;
}

/// Whose face the greatest distance names.
enum class FaceOf { Samples, Others };

OneWayDistance one_way(const FacetSamples& samples, const Facets& others, const TriangleTree& tree,
                       FaceOf named, const RunContext& context) {
  const auto nearest = find_nearest(
      tree, samples.size(), [&](std::size_t i) -> const Vec3& { return samples.point(i); },
      context);
  OneWayDistance result;
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sum += samples.weight(i) * nearest[i].distance;
    area += samples.weight(i);
    if (result.max_face >= 0 && nearest[i].distance <= result.max) continue;
    result.max = nearest[i].distance;
    result.max_at = samples.point(i);
    result.max_face =
        named == FaceOf::Samples ? samples.face(i) : others.faces[nearest[i].triangle];
  }
  result.mean = area > 0 ? sum / area : 0;
  return result;
}

}  // namespace

Facets facets_of(const PolyMesh& mesh, const std::vector<char>& patches) {
  std::vector<Vec3> points;
  points.reserve(mesh.n_vertices());
  // Also deleted ones, so that the numbers of the others hold.
  for (const VertexHandle vh : mesh.all_vertices()) points.push_back(to_eigen(mesh.point(vh)));
  FacetCollector collector(std::move(points));
  decltype(keys::face_patch)::Handle patch_of;
  if (!patches.empty()) patch_of = require(mesh, keys::face_patch);
  std::vector<int> polygon;
  for (const FaceHandle fh : mesh.faces()) {
    if (!patches.empty()) {
      const int patch = mesh.property(patch_of, fh);
      if (patch < 0 || static_cast<std::size_t>(patch) >= patches.size()) continue;
      if (patches[static_cast<std::size_t>(patch)] == 0) continue;
    }
    polygon.clear();
    for (const VertexHandle vh : mesh.fv_range(fh)) polygon.push_back(vh.idx());
    collector.add(polygon, fh.idx());
  }
  return collector.finish();
}

Facets facets_of(const Model& model, FacetsOf which) {
  std::map<const Cage*, int> first_point;
  std::vector<Vec3> points;
  std::vector<std::pair<const Cage*, int>> faces;
  for (const Patch& patch : model.patches) {
    if (!counts(patch, which)) continue;
    const Cage& cage = *patch.cage;
    if (first_point.try_emplace(&cage, static_cast<int>(points.size())).second) {
      points.insert(points.end(), cage.points.begin(), cage.points.end());
    }
    for (const int face : patch.cage_faces) faces.emplace_back(&cage, face);
  }
  // Several patches may cover parts of one face.
  std::sort(faces.begin(), faces.end(), [&](const auto& a, const auto& b) {
    return std::pair(first_point.at(a.first), a.second) <
           std::pair(first_point.at(b.first), b.second);
  });
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  FacetCollector collector(std::move(points));
  for (const auto& [cage, face] : faces) {
    std::vector<int> polygon = without_repeats(cage->faces[static_cast<std::size_t>(face)]);
    for (int& vertex : polygon) vertex += first_point.at(cage);
    collector.add(polygon, face);
  }
  return collector.finish();
}

std::optional<FacetDistance> measure_facet_distance(const PolyMesh& mesh, const Model& model,
                                                    FacetsOf which, const RunContext& context) {
  std::vector<char> is_meant;
  for (const Patch& patch : model.patches) is_meant.push_back(counts(patch, which) ? 1 : 0);
  if (std::find(is_meant.begin(), is_meant.end(), 1) == is_meant.end()) return std::nullopt;
  const Facets of_mesh = facets_of(mesh, is_meant), of_cages = facets_of(model, which);
  if (of_mesh.triangles.empty() || of_cages.triangles.empty()) return std::nullopt;
  FacetDistance distance;
  {
    const TriangleTree tree(of_cages);
    distance.to_facets = one_way(FacetSamples(of_mesh), of_cages, tree, FaceOf::Samples, context);
  }
  const TriangleTree tree(of_mesh);
  distance.from_facets = one_way(FacetSamples(of_cages), of_mesh, tree, FaceOf::Others, context);
  return distance;
}

std::optional<OneWayDistance> measure_surface_to_mesh(const SurfaceSearch& search,
                                                      const PolyMesh& mesh,
                                                      const RunContext& context) {
  const Facets facets = facets_of(mesh);
  const std::vector<Vec3> points = search.sample_points();
  if (facets.triangles.empty() || points.empty()) return std::nullopt;
  const TriangleTree tree(facets);
  const auto nearest = find_nearest(
      tree, points.size(), [&](std::size_t i) -> const Vec3& { return points[i]; }, context);
  OneWayDistance result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.mean += nearest[i].distance / static_cast<double>(points.size());
    if (result.max_face >= 0 && nearest[i].distance <= result.max) continue;
    result.max = nearest[i].distance;
    result.max_at = points[i];
    result.max_face = facets.faces[nearest[i].triangle];
  }
  return result;
}

}  // namespace surfmesh
