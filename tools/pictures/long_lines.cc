// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/long_lines.hh"

#include <cmath>
#include <cstddef>

namespace surfmesh {
namespace {

/// Runs through segments, each once.
class Walk {
 public:
  Walk(const std::vector<PicturePoint>& points, const std::vector<std::array<int, 2>>& segments)
      : points_(points), segments_(segments), is_drawn_(segments.size(), 0) {
    ends_.resize(points.size() + 1, 0);
    for (const auto& [a, b] : segments) {
      ++ends_[slot(a) + 1];
      ++ends_[slot(b) + 1];
    }
    for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
    at_.resize(ends_.back());
    std::vector<std::size_t> next(ends_.begin(), ends_.end() - 1);
    for (std::size_t s = 0; s < segments.size(); ++s) {
      for (const int point : segments[s]) at_[next[slot(point)]++] = s;
    }
  }

  std::vector<PicturePoints> run() {
    std::vector<PicturePoints> lines;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (is_drawn_[s] != 0) continue;
      int from = segments_[s][0];
      PicturePoints& line = lines.emplace_back();
      line.push_back(point(from));
      for (std::size_t at = s; at != kNone;) {
        is_drawn_[at] = 1;
        const int to = other_end(at, from);
        line.push_back(point(to));
        at = straightest_after(from, to);
        from = to;
      }
    }
    return lines;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  static std::size_t slot(int i) { return static_cast<std::size_t>(i); }
  const PicturePoint& point(int i) const { return points_[slot(i)]; }

  int other_end(std::size_t segment, int end) const {
    const auto& [a, b] = segments_[segment];
    return a == end ? b : a;
  }

  /// The segment not drawn yet that turns least from another one.
  std::size_t straightest_after(int from, int to) const {
    const PicturePoint &a = point(from), &b = point(to);
    std::size_t best = kNone;
    double best_cosine = -2;
    for (std::size_t i = ends_[slot(to)]; i < ends_[slot(to) + 1]; ++i) {
      if (is_drawn_[at_[i]] != 0) continue;
      const PicturePoint& c = point(other_end(at_[i], to));
      const double dot = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
      const double length = std::hypot(c.x - b.x, c.y - b.y) * std::hypot(b.x - a.x, b.y - a.y);
      const double cosine = length > 0 ? dot / length : 0;
      if (cosine > best_cosine) {
        best_cosine = cosine;
        best = at_[i];
      }
    }
    return best;
  }

  const std::vector<PicturePoint>& points_;
  const std::vector<std::array<int, 2>>& segments_;
  std::vector<char> is_drawn_;
  std::vector<std::size_t> ends_;  ///< of the segments at each point
  std::vector<std::size_t> at_;
};

}  // namespace

std::vector<PicturePoints> long_lines(const std::vector<PicturePoint>& points,
                                      const std::vector<std::array<int, 2>>& segments) {
  return Walk(points, segments).run();
}

std::vector<PicturePoints> edge_lines(const PolyMesh& mesh,
                                      const std::function<PicturePoint(VertexHandle)>& at) {
  std::vector<PicturePoint> points;
  points.reserve(mesh.n_vertices());
  for (const VertexHandle vh : mesh.vertices()) points.push_back(at(vh));
  std::vector<std::array<int, 2>> segments;
  segments.reserve(mesh.n_edges());
  for (const EdgeHandle eh : mesh.edges()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    segments.push_back({mesh.from_vertex_handle(heh).idx(), mesh.to_vertex_handle(heh).idx()});
  }
  return long_lines(points, segments);
}

}  // namespace surfmesh
