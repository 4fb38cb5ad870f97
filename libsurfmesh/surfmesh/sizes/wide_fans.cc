// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/wide_fans.hh"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <span>
#include <utility>

namespace surfmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Patches of so many rings around a vertex have ripples: its own, those of a second row of faces
/// where the cage is refined once, and the first row beside them.
constexpr int kRings = 3;

/// Ripples end within this many times the greatest distance of the corners of its own patches.
constexpr double kReach = 4;

/// Curvature that counts, as a multiple of its mean over a cell: on smooth shapes it is no more.
constexpr double kAboveMean = 2;

/// Curvature times distance that counts in any case. Elements are wider than faces then.
constexpr double kLeastTurn = 1;

/// A pair of places is taken instead of one before if it is wider apart by this factor: those
/// that take in a whole face, not half of one.
constexpr double kWiderBy = 1.3;

/// Places nearer to the centre than this share of the distance of the cell lie in no direction.
constexpr double kLeastDistance = 0.01;

/// Places on the border of a cell, as shares of its width and height: the middles of the sides
/// first, because derivatives at extraordinary corners are those of a point beside them.
constexpr std::array<Uv, 8> kOfQuad = {Uv{0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5},
                                       {0, 0},     {1, 0},   {1, 1},   {0, 1}};
constexpr std::array<Uv, 6> kOfTriangle = {Uv{0.5, 0}, {0.5, 0.5}, {0, 0.5},
                                           {0, 0},     {1, 0},     {0, 1}};

/// A point of a surface, with the unit normal.
struct Oriented {
  Vec3 point;
  Vec3 normal;
};

/// A fan as a whole.
struct Fan {
  Vec3 centre;
  Vec3 axis = Vec3::Zero();  ///< of the cone that it is most like
  double reach = 0;
};

/// How much the surface bends on average between the two points that are widest apart around a fan,
/// times the distance from its centre. They are on the sides of a face that lead to the vertex,
/// where the bumps of ripples meet.
///
/// Returns  infinity if no two points lie beside each other
double widest_turn(const std::vector<Oriented>& points, const Fan& fan) {
  Vec3 middle = Vec3::Zero();
  for (const Oriented& p : points) middle += p.point - fan.centre;
  const Vec3 around = fan.axis.cross(middle).normalized();
  double turn = kInfinity, widest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 to_a = points[i].point - fan.centre, to_b = points[j].point - fan.centre;
      const double spread = std::abs((to_b.normalized() - to_a.normalized()).dot(around));
      if (!(spread > kWiderBy * widest)) continue;
      const double width = std::abs((to_b - to_a).dot(around));
      const double bend = std::abs((points[j].normal - points[i].normal).dot(around)) / width;
      turn = bend * 0.5 * (to_a + to_b).norm();
      widest = spread;
    }
  }
  return turn;
}

/// The direction in which points differ least: across the plane of a circle.
Vec3 least_spread(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) spread += (p - mean) * (p - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
}

int start_of(const Model& model, const LoopEntry& entry) {
  const Contour& contour = model.contour(entry);
  return model.use(entry).is_forward ? contour.start : contour.end;
}

class FanFinder {
 public:
  explicit FanFinder(const Model& model)
      : model_(model), patches_at_(model.vertices.size()), fans_(model.patches.size()) {
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
      if (model.patches[p].cage_faces.empty()) continue;
      for (const PatchLoop& loop : model.patches[p].loops) {
        for (const LoopEntry& entry : loop) {
          at(start_of(model, entry)).push_back(static_cast<int>(p));
        }
      }
    }
  }

  std::vector<std::vector<WideFan>> run() {
    for (std::size_t v = 0; v < patches_at_.size(); ++v) {
      if (patches_at_[v].size() >= kWideFan) add_fan(static_cast<int>(v));
    }
    return std::move(fans_);
  }

 private:
  std::vector<int>& at(int vertex) { return patches_at_[static_cast<std::size_t>(vertex)]; }

  template <class Visit>
  void for_each_corner(int patch, Visit visit) const {
    for (const PatchLoop& loop : model_.patch(patch).loops) {
      for (const LoopEntry& entry : loop) visit(start_of(model_, entry));
    }
  }

  std::set<int> patches_near(int vertex) {
    std::set<int> patches, vertices = {vertex};
    for (int ring = 0; ring < kRings; ++ring) {
      for (const int v : vertices) patches.insert(at(v).begin(), at(v).end());
      for (const int p : patches) for_each_corner(p, [&](int v) { vertices.insert(v); });
    }
    return patches;
  }

  Fan fan_at(int vertex) {
    Fan fan{model_.position(vertex)};
    std::vector<Vec3> rays;
    for (const int patch : at(vertex)) {
      for_each_corner(patch, [&](int v) {
        const Vec3 ray = model_.position(v) - fan.centre;
        fan.reach = std::max(fan.reach, kReach * ray.norm());
        if (v != vertex) rays.push_back(ray.normalized());
      });
    }
    fan.axis = least_spread(rays);
    return fan;
  }

  void add_fan(int vertex) {
    const Fan fan = fan_at(vertex);
    for (const int patch : patches_near(vertex)) {
      WideFan seen{fan.centre, turns(patch, fan)};
      const bool is_near = std::any_of(seen.turns.begin(), seen.turns.end(),
                                       [](double turn) { return turn < kInfinity; });
      if (is_near) fans_[static_cast<std::size_t>(patch)].push_back(std::move(seen));
    }
  }

  /// By cell of a patch.
  std::vector<double> turns(int patch, const Fan& fan) const {
    const Surface& surface = model_.surface(patch);
    const CellCount cells = surface.cells();
    std::vector<double> turns;
    for (int j = 0; j < cells.v; ++j) {
      for (int i = 0; i < cells.u; ++i) {
        turns.push_back(turn_of_cell(surface, {double(i), double(j)}, fan));
      }
    }
    return turns;
  }

  static double turn_of_cell(const Surface& surface, Uv corner, const Fan& fan) {
    const bool is_triangle = surface.domain().shape == Domain::Shape::Triangle;
    const auto evaluate = [&](Uv share, Order order) {
      return surface.evaluate(surface.from_cells(corner + share), order);
    };
    const double middle = is_triangle ? 1.0 / 3 : 0.5;
    const Vec3 ray = evaluate({middle, middle}, Order::Position).point - fan.centre;
    if (ray.norm() >= fan.reach) return kInfinity;
    std::vector<Oriented> points;
    for (const Uv share : is_triangle ? std::span<const Uv>(kOfTriangle) : kOfQuad) {
      const Jet jet = evaluate(share, Order::First);
      if ((jet.point - fan.centre).norm() < kLeastDistance * ray.norm()) continue;
      points.push_back({jet.point, jet.du.cross(jet.dv).normalized()});
    }
    return std::max(kLeastTurn, kAboveMean * widest_turn(points, fan));
  }

  const Model& model_;
  std::vector<std::vector<int>> patches_at_;  ///< by vertex, for each corner: of cages only
  std::vector<std::vector<WideFan>> fans_;
};

/// Limit a curvature of which this share lies around a vertex.
double limited(double curvature, double share, double limit) {
  if (!(std::abs(curvature) * share > limit)) return curvature;
  return std::copysign(limit / share, curvature);
}

}  // namespace

std::vector<std::vector<WideFan>> wide_fans(const Model& model) { return FanFinder(model).run(); }

PrincipalCurvatures without_ripples(const PrincipalCurvatures& k, const Jet& jet,
                                    const Vec3& centre, double turn) {
  const Vec3 ray = jet.point - centre;
  // The ray in the frame of the first form, as cosine and sine of twice its angle.
  const Vec3 first = jet.du.normalized();
  const Vec3 second = jet.du.cross(jet.dv).cross(jet.du).normalized();
  const double x = ray.dot(first), y = ray.dot(second), squared = x * x + y * y;
  if (!(squared > 0)) return k;
  const double cos2 = (x * x - y * y) / squared, sin2 = 2 * x * y / squared;
  const double share_of_k1 = 0.5 * (1 - (k.cos2 * cos2 + k.sin2 * sin2));
  const double limit = turn / ray.norm();
  const double k1 = limited(k.k1, share_of_k1, limit);
  const double k2 = limited(k.k2, 1 - share_of_k1, limit);
  if (k1 >= k2) return {k1, k2, k.cos2, k.sin2};
  return {k2, k1, -k.cos2, -k.sin2};
}

}  // namespace surfmesh
