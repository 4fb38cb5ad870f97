// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/interpolating_cage.hh"

#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "surfmesh/cage/face_angles.hh"
#include "surfmesh/cage/limit_stencils.hh"
#include "surfmesh/cage/subdivision.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

namespace Far = OpenSubdiv::Far;

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using Symmetric = Eigen::SparseMatrix<double>;

/// Residuals of solvers, as shares of their right sides: rounding is not far below.
constexpr double kSolverPrecision = 1e-13;
/// With a fit, distances are compared with it to so many digits and no more.
constexpr double kFitPrecision = 1e-9;
/// A solution is one if distances are no more than this share of the diagonal.
constexpr double kSolved = 1e-11;
/// The nearest surface is found where moves change the distance by less than this share of what
/// they did at first.
constexpr double kNearest = 1e-6;
/// Regular meshes need some 20 iterations, and those with bad triangles 60.
constexpr int kMostIterations = 300;
constexpr int kMostLeastSquaresIterations = 2000;
/// Weights of smoothness between which the one for a fit lies. The lower one gives the least
/// squares of the interpolation, the upper one damps waves of 100 edges and less.
constexpr double kLeastFairness = 1e-8;
constexpr double kMostFairness = 1e5;
/// The search for the weight ends where the distance is at least this share of the fit.
constexpr double kFitReached = 0.95;
constexpr int kMostFitSteps = 24;

Points matrix_of(const std::vector<Vec3>& points) {
  Points result(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.row(static_cast<Eigen::Index>(i)) = points[i];
  }
  return result;
}

/// A solution of a linear system, column by column.
struct Solution {
  Points columns;
  int iterations = 0;
};

/// Solve for each column by a solver of Eigen's, from a first guess.
template <class Solver>
Solution solve(const Solver& prepared, const Points& right, const Points& guess) {
  Solution solution{guess};
  for (int k = 0; k < 3; ++k) {
    solution.columns.col(k) = prepared.solveWithGuess(right.col(k), guess.col(k));
    solution.iterations += static_cast<int>(prepared.iterations());
  }
  return solution;
}

/// Adds up a matrix in which a vertex is compared with the mean of its neighbours.
class Umbrella {
 public:
  explicit Umbrella(const Far::TopologyLevel& level) : level_(level) {
    for (int v = 0; v < level.GetNumVertices(); ++v) add(v);
  }

  Stencils matrix() const {
    Stencils result(level_.GetNumVertices(), level_.GetNumVertices());
    result.setFromTriplets(entries_.begin(), entries_.end());
    return result;
  }

 private:
  bool is_line(int edge) const {
    return level_.GetEdgeSharpness(edge) > 0 || level_.GetEdgeFaces(edge).size() != 2;
  }

  void add(int vertex) {
    std::vector<int> lines, all;
    for (const int edge : level_.GetVertexEdges(vertex)) {
      const Far::ConstIndexArray ends = level_.GetEdgeVertices(edge);
      const int other = ends[0] == vertex ? ends[1] : ends[0];
      all.push_back(other);
      if (is_line(edge)) lines.push_back(other);
    }
    const bool is_fixed = level_.GetVertexSharpness(vertex) > 0 || lines.size() > 2;
    // A line that ends is a dart, around which the surface is smooth.
    const std::vector<int>& neighbours = lines.size() == 2 ? lines : all;
    if (is_fixed || neighbours.empty()) return;
    const double weight = 1 / static_cast<double>(neighbours.size());
    for (const int other : neighbours) entries_.emplace_back(vertex, other, weight);
    entries_.emplace_back(vertex, vertex, -1);
  }

  const Far::TopologyLevel& level_;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// The normals of vertices: the sums of the areas of their faces, of length 1 or zero.
Points normals_of(const Far::TopologyLevel& level, const Points& points) {
  Points normals = Points::Zero(points.rows(), 3);
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    const Far::ConstIndexArray face = level.GetFaceVertices(f);
    const Vec3 area =
        detail::area_vector(face, [&](int v) -> Vec3 { return points.row(v).transpose(); });
    for (const int v : face) normals.row(v) += area;
  }
  for (int v = 0; v < normals.rows(); ++v) {
    const double length = normals.row(v).norm();
    if (length > 0) normals.row(v) /= length;
  }
  return normals;
}

/// A matrix some of whose rows are those of the identity.
Stencils with_identity_rows(Stencils matrix, const std::vector<int>& rows) {
  for (const int row : rows) {
    if (row < 0 || row >= matrix.rows()) {
      throw Error(
          ErrorCode::InvalidInput,
          fmt::format("vertex {} to pass by does not exist: there are {}", row, matrix.rows()));
    }
    for (Stencils::InnerIterator entry(matrix, row); entry; ++entry) {
      entry.valueRef() = entry.col() == row ? 1 : 0;
    }
    matrix.coeffRef(row, row) = 1;
  }
  return matrix;
}

/// Looks for the cage of a mesh.
class CageSolver {
 public:
  CageSolver(const Far::TopologyRefiner& refiner, const Cage& cage,
             const std::vector<int>& passed_by)
      : level_(refiner.GetLevel(0)),
        given_(matrix_of(cage.points)),
        stencils_(limit_stencils(refiner)),
        system_(with_identity_rows(stencils_, passed_by)),
        diagonal_(surfmesh::diagonal(cage)) {}

  /// The points whose limit positions are those given.
  Points interpolate(InterpolatingCage& result) const {
    const Points right = given_ - system_ * given_;
    const Points nothing = Points::Zero(given_.rows(), 3);
    Eigen::BiCGSTAB<Stencils> solver;
    solver.setTolerance(kSolverPrecision);
    solver.setMaxIterations(kMostIterations);
    solver.compute(system_);
    Solution solution = solve(solver, right, nothing);
    result.iterations += solution.iterations;
    const double residual = (right - system_ * solution.columns).rowwise().norm().maxCoeff();
    result.is_least_squares = !(residual <= kSolved * diagonal_);  // also where it is not a number
    if (!result.is_least_squares) return given_ + solution.columns;
    Eigen::LeastSquaresConjugateGradient<Stencils> nearest;
    nearest.setTolerance(kSolverPrecision);
    nearest.setMaxIterations(kMostLeastSquaresIterations);
    nearest.compute(system_);
    solution = solve(nearest, right, nothing);
    result.iterations += solution.iterations;
    const Points slope = system_.transpose() * (right - system_ * solution.columns);
    result.has_stopped = !(slope.norm() <= kNearest * (system_.transpose() * right).norm());
    return given_ + solution.columns;
  }

  /// The smoothest points whose limit positions are no farther than `fit` from those given.
  Points fit(double fit, InterpolatingCage& result) const {
    const Vec3 centre = given_.colwise().mean();
    const FairSystem system = fair_system(centre);
    Points reached = given_, points = given_;
    const double least = std::log(kLeastFairness);
    double low = least, high = std::log(kMostFairness), at = 0;
    for (int step = 0; step < kMostFitSteps; ++step) {
      points = solve_fair(system, centre, std::exp(at), points, result);
      const double distance = distances(points).maxCoeff();
      const bool is_near = distance <= fit;
      if (is_near) {
        reached = points;
        result.fairness = std::exp(at);
      }
      if (!is_near && at == least) break;
      (is_near ? low : high) = at;
      if (high - low < kLeastStep || (is_near && distance >= kFitReached * fit)) break;
      // If the least weight does not reach the fit, none does.
      at = step == 0 && !is_near ? least : (low + high) / 2;
    }
    if (result.fairness > 0) return reached;
    return interpolate(result);
  }

  void measure(const Points& points, InterpolatingCage& result) const {
    const Eigen::VectorXd distance = distances(points);
    double squares = 0;
    for (int v = 0; v < level_.GetNumVertices(); ++v) {
      if (level_.GetVertexFaces(v).size() == 0) continue;
      ++result.vertices;
      if (distance[v] > result.distance) {
        result.distance = distance[v];
        result.farthest_vertex = v;
      }
      squares += distance[v] * distance[v];
      const double move = (points.row(v) - given_.row(v)).norm();
      if (move <= result.greatest_move) continue;
      result.greatest_move = move;
      result.moved_vertex = v;
    }
    result.mean_distance = std::sqrt(squares / static_cast<double>(result.vertices));
  }

 private:
  /// Steps of the logarithm below which a weight is as good as another.
  static constexpr double kLeastStep = 0.02;

  /// Nearness and smoothness of the normal equations, with their right sides.
  struct FairSystem {
    Symmetric nearness;
    Symmetric smoothness;
    Points near_right;
    Points smooth_right;
  };

  /// Only what stands out along the normal is to vanish: vertices that are unevenly spread in the
  /// surface stay so.
  FairSystem fair_system(const Vec3& centre) const {
    const Points centred = given_.rowwise() - centre.transpose();
    const Stencils umbrella = Umbrella(level_).matrix();
    const Points normals = normals_of(level_, given_);
    const Points all = umbrella * centred;
    const Eigen::VectorXd along = (all.array() * normals.array()).rowwise().sum();
    const Points within = all - along.asDiagonal() * normals;
    FairSystem system;
    system.nearness = Symmetric(stencils_.transpose()) * Symmetric(stencils_);
    system.smoothness = Symmetric(umbrella.transpose()) * Symmetric(umbrella);
    system.near_right = stencils_.transpose() * centred;
    system.smooth_right = umbrella.transpose() * within;
    return system;
  }

  Points solve_fair(const FairSystem& system, const Vec3& centre, double fairness,
                    const Points& guess, InterpolatingCage& result) const {
    const Symmetric matrix = system.nearness + fairness * system.smoothness;
    Eigen::ConjugateGradient<Symmetric, Eigen::Lower | Eigen::Upper> solver;
    solver.setTolerance(kFitPrecision);
    solver.setMaxIterations(kMostLeastSquaresIterations);
    solver.compute(matrix);
    const Solution solution = solve(solver, system.near_right + fairness * system.smooth_right,
                                    guess.rowwise() - centre.transpose());
    result.iterations += solution.iterations;
    return solution.columns.rowwise() + centre.transpose();
  }

  Eigen::VectorXd distances(const Points& points) const {
    return (given_ - stencils_ * points).rowwise().norm();
  }

  Far::TopologyLevel level_;
  Points given_;
  Stencils stencils_;
  Stencils system_;  ///< the stencils, with the points themselves at vertices that are passed by
  double diagonal_;
};

}  // namespace

InterpolatingCage interpolating_cage(const Cage& cage, const InterpolationOptions& options) {
  if (options.fit.value != 0) check_option(ranges::kFit, options.fit);
  const CageTopology topology = make_topology(cage, resolve_scheme(cage, options.scheme));
  const CageSolver solver(*topology.refiner, cage, options.passed_by);
  InterpolatingCage result;
  const double fit = options.fit.in_units(diagonal(cage));
  const Points points = fit > 0 ? solver.fit(fit, result) : solver.interpolate(result);
  if (!points.allFinite()) {
    throw Error(ErrorCode::Geometry, "no cage was found whose surface passes through the points");
  }
  solver.measure(points, result);
  result.cage = cage;
  for (std::size_t v = 0; v < cage.points.size(); ++v) {
    result.cage.points[v] = points.row(static_cast<Eigen::Index>(v));
  }
  return result;
}

}  // namespace surfmesh
