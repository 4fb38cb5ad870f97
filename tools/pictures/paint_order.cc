// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/paint_order.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace surfmesh {
namespace {

/// Cuts of everything that lies in a circle, before depths decide.
constexpr int kRounds = 10;

/// Pixels by which one surface has to be in front of another to hide it, and by which a corner is
/// off a plane.
constexpr double kLeastDepth = 1e-3;

constexpr int kNone = -1;

/// A piece with its triangle.
struct Piece {
  std::vector<ScenePoint> corners;
  int triangle = 0;
  double depth = 0;  ///< of its middle
};

std::size_t slot(int i) { return static_cast<std::size_t>(i); }

class PaintOrder {
 public:
  PaintOrder(const Scene& scene, const DepthBuffer& buffer)
      : scene_(scene), buffer_(buffer), front_(buffer.columns() * buffer.rows(), kNone) {
    find_pieces();
  }

  std::vector<std::vector<PaintPiece>> run() {
    for (int round = 0;; ++round) {
      collect_overlaps();
      std::vector<int> layers = layers_of_pieces();
      const std::vector<char> is_in_circle = find_circles(layers);
      const bool has_circles =
          std::find(is_in_circle.begin(), is_in_circle.end(), 1) != is_in_circle.end();
      if (!has_circles) return collect(layers);
      if (round == kRounds || !cut(is_in_circle)) {
        order_by_depth(layers);
        return collect(layers);
      }
    }
  }

 private:
  using Overlap = std::pair<int, int>;  ///< a piece, and one that lies over it

  void find_pieces() {
    std::vector<int> piece_of(scene_.triangles.size(), kNone);
    for (std::size_t row = 0; row < buffer_.rows(); ++row) {
      for (std::size_t column = 0; column < buffer_.columns(); ++column) {
        const int t = buffer_.front(column, row);
        if (t < 0) continue;
        int& piece = piece_of[slot(t)];
        if (piece == kNone) {
          std::vector<ScenePoint> corners;
          for (const int p : scene_.triangles[slot(t)].points) {
            corners.push_back(scene_.points[slot(p)]);
          }
          piece = add(std::move(corners), t);
        }
        front_[row * buffer_.columns() + column] = piece;
      }
    }
  }

  int add(std::vector<ScenePoint> corners, int triangle) {
    double depth = 0;
    for (const ScenePoint& corner : corners) {
      depth += corner.depth / static_cast<double>(corners.size());
    }
    pieces_.push_back({std::move(corners), triangle, depth});
    return static_cast<int>(pieces_.size()) - 1;
  }

  std::array<ScenePoint, 3> triangle_of(const Piece& piece) const {
    return buffer_.corners(scene_.triangles[slot(piece.triangle)]);
  }

  /// Call `body(front, depth, sample)` for the samples in a piece; `depth` is its own.
  template <class Body>
  void for_samples(const Piece& piece, Body body) const {
    const DepthPlane plane(triangle_of(piece));
    for (std::size_t i = 2; i < piece.corners.size(); ++i) {
      const std::array corners = {buffer_.on_lattice(piece.corners[0]),
                                  buffer_.on_lattice(piece.corners[i - 1]),
                                  buffer_.on_lattice(piece.corners[i])};
      for_samples_in(
          corners, buffer_.columns(), 0, buffer_.rows(), [&](std::size_t column, std::size_t row) {
            body(double(column) + 0.5, double(row) + 0.5, row * buffer_.columns() + column, plane);
          });
    }
  }

  /// Which pieces lie over which, where the upper one is seen.
  void collect_overlaps() {
    overlaps_.clear();
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const Piece& piece = pieces_[p];
      int last = kNone;
      for_samples(piece, [&](double x, double y, std::size_t sample, const DepthPlane& plane) {
        const int front = front_[sample];
        if (front == static_cast<int>(p) || front == last || front == kNone) return;
        const Piece& other = pieces_[slot(front)];
        if (other.triangle == piece.triangle) return;
        if (DepthPlane(triangle_of(other)).at(x, y) <= plane.at(x, y) + kLeastDepth) return;
        last = front;
        overlaps_.emplace_back(static_cast<int>(p), front);
      });
    }
    std::sort(overlaps_.begin(), overlaps_.end());
    overlaps_.erase(std::unique(overlaps_.begin(), overlaps_.end()), overlaps_.end());
  }

  /// The layer of each piece, above all that it lies over; kNone in circles and over these.
  std::vector<int> layers_of_pieces() const {
    std::vector<int> under(pieces_.size(), 0), layers(pieces_.size(), kNone);
    for (const auto& [lower, upper] : overlaps_) ++under[slot(upper)];
    std::vector<int> ready, next;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (under[p] == 0) ready.push_back(static_cast<int>(p));
    }
    for (int layer = 0; !ready.empty(); ++layer, ready.swap(next)) {
      next.clear();
      for (const int p : ready) {
        layers[slot(p)] = layer;
        for (auto [at, end] = above(p); at != end; ++at) {
          if (--under[slot(at->second)] == 0) next.push_back(at->second);
        }
      }
    }
    return layers;
  }

  std::pair<const Overlap*, const Overlap*> above(int piece) const {
    const auto [first, last] =
        std::equal_range(overlaps_.begin(), overlaps_.end(), Overlap(piece, 0),
                         [](const Overlap& a, const Overlap& b) { return a.first < b.first; });
    return {overlaps_.data() + (first - overlaps_.begin()),
            overlaps_.data() + (last - overlaps_.begin())};
  }

  /// Of the pieces without a layer those that have others without one above them, and so on: what
  /// merely lies over a circle is not in it.
  std::vector<char> find_circles(const std::vector<int>& layers) const {
    std::vector<char> is_in(pieces_.size(), 0);
    std::vector<int> over(pieces_.size(), 0);
    std::vector<std::vector<int>> lower_ones(pieces_.size());
    for (std::size_t p = 0; p < pieces_.size(); ++p) is_in[p] = layers[p] == kNone;
    for (const auto& [lower, upper] : overlaps_) {
      if (is_in[slot(lower)] == 0 || is_in[slot(upper)] == 0) continue;
      ++over[slot(lower)];
      lower_ones[slot(upper)].push_back(lower);
    }
    std::vector<int> free;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (is_in[p] != 0 && over[p] == 0) free.push_back(static_cast<int>(p));
    }
    while (!free.empty()) {
      const int p = free.back();
      free.pop_back();
      is_in[slot(p)] = 0;
      for (const int lower : lower_ones[slot(p)]) {
        if (--over[slot(lower)] == 0) free.push_back(lower);
      }
    }
    return is_in;
  }

  /// Cut each piece of a circle at the plane of the first one over it that passes through it.
  bool cut(const std::vector<char>& is_in_circle) {
    bool has_cut = false;
    std::vector<char> is_cut(pieces_.size(), 0);
    for (const auto& [lower, upper] : overlaps_) {
      if (is_in_circle[slot(lower)] == 0 || is_in_circle[slot(upper)] == 0) continue;
      for (const auto& [piece, by] : {Overlap(lower, upper), Overlap(upper, lower)}) {
        if (is_cut[slot(piece)] != 0) continue;
        if (!cut(piece, pieces_[slot(by)].triangle)) continue;
        is_cut[slot(piece)] = 1;
        has_cut = true;
      }
    }
    return has_cut;
  }

  /// Cut a piece at the plane of a triangle; false if it lies on one side.
  bool cut(int piece, int triangle) {
    const auto& points = scene_.triangles[slot(triangle)].points;
    const ScenePoint &a = scene_.points[slot(points[0])], &b = scene_.points[slot(points[1])],
                     &c = scene_.points[slot(points[2])];
    const Vec3 origin(a.x, a.y, a.depth);
    const Vec3 normal = (Vec3(b.x, b.y, b.depth) - origin)
                            .cross(Vec3(c.x, c.y, c.depth) - origin)
                            .stableNormalized();
    const auto height = [&](const ScenePoint& p) {
      return normal.dot(Vec3(p.x, p.y, p.depth) - origin);
    };
    const std::vector<ScenePoint> corners = pieces_[slot(piece)].corners;
    std::vector<ScenePoint> above, below;
    double highest = 0, lowest = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const ScenePoint &p = corners[i], &q = corners[(i + 1) % corners.size()];
      const double from = height(p), to = height(q);
      highest = std::max(highest, from);
      lowest = std::min(lowest, from);
      if (from >= 0) above.push_back(p);
      if (from <= 0) below.push_back(p);
      if (from * to >= 0) continue;
      const double t = from / (from - to);
      const ScenePoint middle{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y),
                              p.depth + t * (q.depth - p.depth)};
      above.push_back(middle);
      below.push_back(middle);
    }
    if (!(highest > kLeastDepth && lowest < -kLeastDepth)) return false;
    const int own = pieces_[slot(piece)].triangle;
    pieces_[slot(piece)] = {above, own, 0};
    for (const ScenePoint& p : above) {
      pieces_[slot(piece)].depth += p.depth / static_cast<double>(above.size());
    }
    const int other = add(std::move(below), own);
    for_samples(pieces_[slot(other)], [&](double, double, std::size_t sample, const DepthPlane&) {
      if (front_[sample] == piece) front_[sample] = other;
    });
    return true;
  }

  /// Give those without a layer one each, from back to front.
  void order_by_depth(std::vector<int>& layers) const {
    std::vector<int> rest;
    int layer = 0;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      layer = std::max(layer, layers[p]);
      if (layers[p] == kNone) rest.push_back(static_cast<int>(p));
    }
    std::stable_sort(rest.begin(), rest.end(),
                     [&](int a, int b) { return pieces_[slot(a)].depth < pieces_[slot(b)].depth; });
    for (const int p : rest) layers[slot(p)] = ++layer;
  }

  /// The pieces by layer, those of a colour together, from left to right.
  std::vector<std::vector<PaintPiece>> collect(const std::vector<int>& layers) const {
    const int count = layers.empty() ? 0 : *std::max_element(layers.begin(), layers.end()) + 1;
    std::vector<std::vector<PaintPiece>> result(slot(count));
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      result[slot(layers[p])].push_back(
          {pieces_[p].corners, scene_.triangles[slot(pieces_[p].triangle)].colour});
    }
    for (std::vector<PaintPiece>& layer : result) {
      std::stable_sort(layer.begin(), layer.end(), [](const PaintPiece& a, const PaintPiece& b) {
        return std::pair(a.colour, a.corners[0].x) < std::pair(b.colour, b.corners[0].x);
      });
    }
    return result;
  }

  const Scene& scene_;
  const DepthBuffer& buffer_;
  std::vector<int> front_;  ///< the piece in front at each sample
  std::vector<Piece> pieces_;
  std::vector<Overlap> overlaps_;  ///< ascending
};

}  // namespace

std::vector<std::vector<PaintPiece>> paint_order(const Scene& scene, const DepthBuffer& buffer) {
  return PaintOrder(scene, buffer).run();
}

}  // namespace surfmesh
