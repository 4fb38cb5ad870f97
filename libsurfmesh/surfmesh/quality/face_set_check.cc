// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/face_set_check.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/quality/facing.hh"
#include "surfmesh/quality/patch_text.hh"
#include "surfmesh/quality/quality_histogram.hh"

namespace surfmesh {
namespace {

constexpr int kAngleBins = 18;
/// Powers of 2 up to this one, and as many below 1, are numbers with all their digits.
constexpr int kGreatestExponent = 1000;
constexpr double kDegree = std::numbers::pi / 180;

/// A side of a face, by its vertices.
struct Side {
  int low = 0;
  int high = 0;
  std::size_t corner = 0;  ///< at its origin
  std::size_t tip = 0;     ///< the corner at its end
  std::size_t face = 0;
  bool is_rising = false;  ///< from the lower to the higher vertex
};

std::vector<Side> sorted_sides(const FaceList& faces) {
  std::vector<Side> sides;
  sides.reserve(faces.corner_count());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::size_t first = faces.first_corner(f), end = faces.first_corner(f + 1);
    for (std::size_t c = first; c < end; ++c) {
      const std::size_t tip = c + 1 == end ? first : c + 1;
      const int a = faces.vertex(c), b = faces.vertex(tip);
      sides.push_back({std::min(a, b), std::max(a, b), c, tip, f, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::array{static_cast<std::size_t>(a.low), static_cast<std::size_t>(a.high), a.corner} <
           std::array{static_cast<std::size_t>(b.low), static_cast<std::size_t>(b.high), b.corner};
  });
  return sides;
}

/// The normal with twice the area as its length.
Vec3 double_area(const MeshArrays& set, std::size_t f) {
  const auto face = set.faces[f];
  const Vec3& origin = set.points[static_cast<std::size_t>(face[0])];
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < face.size(); ++k) {
    const Vec3 a = set.points[static_cast<std::size_t>(face[k - 1])] - origin;
    const Vec3 b = set.points[static_cast<std::size_t>(face[k])] - origin;
    sum += a.cross(b);
  }
  return sum;
}

class Checker {
 public:
  explicit Checker(const MeshArrays& set) : set_(set) {}

  FaceSetCheck run() {
    check_ = {};
    face_of_.assign(set_.points.size(), kNoFace);
    count_faces();
    look_at_edges();
    look_at_vertices();
    look_at_faces();
    finish();
    return std::move(check_);
  }

 private:
  const Vec3& point(int vertex) const { return set_.points[static_cast<std::size_t>(vertex)]; }

  std::string patch_text(std::size_t f) const { return detail::patch_text(set_, f); }

  std::string edge_text(const Side& side) const {
    return fmt::format("edge {}-{}{} at {}", side.low, side.high, patch_text(side.face),
                       point_text(0.5 * (point(side.low) + point(side.high))));
  }

  std::string face_text(std::size_t f) const {
    return fmt::format("face {}{} at {}", f, patch_text(f), point_text(point(set_.faces[f][0])));
  }

  std::string vertex_text(std::size_t v) const {
    return fmt::format("vertex {}{} at {}", v, patch_text(face_of_[v]), point_text(set_.points[v]));
  }

  bool is_used(std::size_t v) const { return face_of_[v] != kNoFace; }

  void count_faces() {
    for (std::size_t f = 0; f < set_.faces.size(); ++f) {
      const auto face = set_.faces[f];
      ++(face.size() == 3 ? check_.triangles : face.size() == 4 ? check_.quads : check_.polygons);
      for (const int vertex : face) face_of_[static_cast<std::size_t>(vertex)] = f;
    }
  }

  void look_at_edges() {
    const std::vector<Side> sides = sorted_sides(set_.faces);
    DisjointSets corners(set_.faces.corner_count());
    DisjointSets vertices(set_.points.size()), open(set_.points.size());
    std::vector<bool> is_open(set_.points.size(), false);
    check_.components = static_cast<std::size_t>(std::count_if(
        face_of_.begin(), face_of_.end(), [](std::size_t face) { return face != kNoFace; }));
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].low == sides[i].low &&
             sides[end].high == sides[i].high)
        ++end;
      look_at_edge(sides, i, end, corners);
      const auto a = static_cast<std::size_t>(sides[i].low);
      const auto b = static_cast<std::size_t>(sides[i].high);
      if (vertices.unite(a, b)) --check_.components;
      if (end == i + 1) {
        check_.boundary_loops += !is_open[a] + !is_open[b];
        is_open[a] = is_open[b] = true;
        if (open.unite(a, b)) --check_.boundary_loops;
      }
      i = end;
    }
    count_fans(corners);
  }

  void look_at_edge(const std::vector<Side>& sides, std::size_t first, std::size_t end,
                    DisjointSets& corners) {
    ++check_.edges;
    for (std::size_t j = first + 1; j < end; ++j) {
      const Side& a = sides[first];
      const Side& b = sides[j];
      const bool is_same = a.is_rising == b.is_rising;
      corners.unite(a.corner, is_same ? b.corner : b.tip);
      corners.unite(a.tip, is_same ? b.tip : b.corner);
    }
    if (end - first == 1) check_.open_edges.add([&] { return edge_text(sides[first]); });
    if (end - first > 2) {
      edges_.add(
          [&] { return fmt::format("{}, of {} faces", edge_text(sides[first]), end - first); });
    } else if (end - first == 2 && sides[first].is_rising == sides[first + 1].is_rising) {
      turned_.add([&] {
        return fmt::format("faces {} and {}, {}", sides[first].face, sides[first + 1].face,
                           edge_text(sides[first]));
      });
    }
  }

  void count_fans(DisjointSets& corners) {
    std::vector<char> fans(set_.points.size(), 0);
    for (std::size_t c = 0; c < set_.faces.corner_count(); ++c) {
      if (corners.find(c) != c) continue;
      char& count = fans[static_cast<std::size_t>(set_.faces.vertex(c))];
      if (count < 2) ++count;
    }
    for (std::size_t v = 0; v < fans.size(); ++v) {
      if (fans[v] > 1) vertices_.add([&] { return vertex_text(v); });
    }
  }

  void look_at_vertices() {
    for (std::size_t v = 0; v < set_.points.size(); ++v) {
      if (!is_used(v)) unused_.add([&] { return vertex_text(v); });
    }
    std::vector<std::size_t> order(set_.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [this](std::size_t v) {
      const Vec3& p = set_.points[v];
      return std::array{p.x(), p.y(), p.z()};
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (key(order[i - 1]) != key(order[i])) continue;
      same_points_.add([&] {
        return fmt::format("vertices {} and {}{} at {}", order[i - 1], order[i],
                           patch_text(face_of_[order[i]]), point_text(set_.points[order[i]]));
      });
    }
  }

  void look_at_faces() {
    std::vector<std::vector<int>> keys;
    keys.reserve(set_.faces.size());
    for (std::size_t f = 0; f < set_.faces.size(); ++f) {
      const auto face = set_.faces[f];
      double longest = 0;
      for (std::size_t k = 0; k < face.size(); ++k) {
        longest =
            std::max(longest, (point(face[k]) - point(face[(k + 1) % face.size()])).squaredNorm());
      }
      if (is_flat(double_area(set_, f).norm(), longest)) {
        flat_.add([&] { return face_text(f); });
      }
      keys.emplace_back(face.begin(), face.end());
      std::sort(keys.back().begin(), keys.back().end());
    }
    std::vector<std::size_t> order(keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (keys[order[i - 1]] != keys[order[i]]) continue;
      same_faces_.add([&] {
        return fmt::format("faces {} and {}{} at {}", order[i - 1], order[i], patch_text(order[i]),
                           point_text(point(set_.faces[order[i]][0])));
      });
    }
  }

  void finish() {
    check_.vertices = set_.points.size();
    check_.euler = static_cast<long>(set_.points.size() - unused_.count) -
                   static_cast<long>(check_.edges) + static_cast<long>(set_.faces.size());
    check_.boundary_edges = check_.open_edges.count;
    check_.is_closed = !set_.faces.empty() && check_.boundary_edges == 0;
    check_.is_manifold = edges_.count == 0 && vertices_.count == 0;
    check_.is_oriented = turned_.count == 0 && edges_.count == 0;
    for (MeshFault* fault :
         {&edges_, &turned_, &vertices_, &flat_, &same_faces_, &same_points_, &unused_}) {
      if (fault->count > 0) check_.faults.push_back(std::move(*fault));
    }
  }

  static constexpr std::size_t kNoFace = std::numeric_limits<std::size_t>::max();

  const MeshArrays& set_;
  FaceSetCheck check_;
  std::vector<std::size_t> face_of_;  ///< a face of each vertex
  MeshFault edges_{"non_manifold_edge", 0, {}};
  MeshFault turned_{"turned_neighbour", 0, {}};
  MeshFault vertices_{"non_manifold_vertex", 0, {}};
  MeshFault flat_{"degenerate_face", 0, {}};
  MeshFault same_faces_{"duplicate_face", 0, {}};
  MeshFault same_points_{"duplicate_vertex", 0, {}};
  MeshFault unused_{"unused_vertex", 0, {}};
};

std::vector<HistogramBin> empty_angles() {
  std::vector<HistogramBin> bins;
  for (int i = 0; i < kAngleBins; ++i) bins.push_back({10.0 * i, 10.0 * (i + 1), 0});
  return bins;
}

/// Gathers the statistics of shapes, face by face.
class ShapeMeter {
 public:
  explicit ShapeMeter(const MeshArrays& set) : set_(set) {
    shape_.angles = empty_angles();
    shape_.min_angle = shape_.min_edge = std::numeric_limits<double>::infinity();
    shape_.quality.min = std::numeric_limits<double>::infinity();
  }

  ShapeStatistics run() {
    for (std::size_t f = 0; f < set_.faces.size(); ++f) add(f);
    if (set_.faces.empty()) return {};
    shape_.mean_edge = length_sum_ / static_cast<double>(set_.faces.corner_count());
    QualityStatistics& quality = shape_.quality;
    if (quality.count > 0) {
      quality.mean = quality_sum_ / static_cast<double>(quality.count);
      quality.below_0_3 = static_cast<double>(poor_) / static_cast<double>(quality.count);
    } else {
      quality.min = 0;
    }
    return shape_;
  }

 private:
  void add(std::size_t f) {
    const auto face = set_.faces[f];
    const std::size_t n = face.size();
    const auto point = [&](std::size_t k) {
      return set_.points[static_cast<std::size_t>(face[k % n])];
    };
    double longest = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Vec3 side = point(k + 1) - point(k);
      add_length(side.stableNorm());
      longest = std::max(longest, side.lpNorm<Eigen::Infinity>());
    }
    const double scale = scale_for(longest);
    const auto side = [&](std::size_t from, std::size_t to) {
      return Vec3(scale > 0 ? Vec3(scale * (point(to) - point(from))) : Vec3::Zero());
    };
    double squares = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Vec3 next = side(k, k + 1), back = side(k, k + n - 1);
      add_angle(std::atan2(next.cross(back).norm(), next.dot(back)), f);
      squares += next.squaredNorm();
    }
    if (n != 3) return;
    const double area = side(0, 1).cross(side(0, 2)).norm();
    add_quality(squares > 0 ? 2 * std::numbers::sqrt3 * area / squares : 0, f);
  }

  /// A power of 2 that brings lengths near to 1, so that their products neither overflow nor
  /// vanish; 0 where there is none.
  static double scale_for(double longest) {
    if (!(longest > 0) || !std::isfinite(longest)) return 0;
    return std::ldexp(1.0, -std::clamp(std::ilogb(longest), -kGreatestExponent, kGreatestExponent));
  }

  void add_angle(double angle, std::size_t f) {
    if (angle < shape_.min_angle) {
      shape_.min_angle = angle;
      shape_.min_angle_face = f;
    }
    if (angle > shape_.max_angle) {
      shape_.max_angle = angle;
      shape_.max_angle_face = f;
    }
    const double bin = std::clamp(angle / (10 * kDegree), 0.0, kAngleBins - 1.0);
    ++shape_.angles[static_cast<std::size_t>(bin)].count;
  }

  void add_length(double length) {
    shape_.min_edge = std::min(shape_.min_edge, length);
    shape_.max_edge = std::max(shape_.max_edge, length);
    length_sum_ += length;
  }

  void add_quality(double quality, std::size_t f) {
    if (shape_.quality.count++ == 0) {
      shape_.quality.histogram = detail::empty_quality_histogram();
    }
    detail::count_quality(quality, shape_.quality.histogram);
    if (quality < shape_.quality.min) {
      shape_.quality.min = quality;
      shape_.quality.worst_face = static_cast<int>(f);
    }
    quality_sum_ += quality;
    if (quality < detail::kPoorQuality) ++poor_;
  }

  const MeshArrays& set_;
  ShapeStatistics shape_;
  double length_sum_ = 0;
  double quality_sum_ = 0;
  std::size_t poor_ = 0;
};

}  // namespace

FaceSetCheck check_face_set(const MeshArrays& set) { return Checker(set).run(); }

ShapeStatistics measure_shape(const MeshArrays& set) { return ShapeMeter(set).run(); }

}  // namespace surfmesh
