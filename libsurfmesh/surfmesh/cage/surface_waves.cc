// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/surface_waves.hh"

#include <opensubdiv/far/primvarRefiner.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "surfmesh/cage/primvar.hh"
#include "surfmesh/cage/subdivision.hh"

namespace surfmesh {
namespace {

namespace Far = OpenSubdiv::Far;

constexpr double kDegrees = 180 / std::numbers::pi;

/// What the surface turns more than the faces is a wave from here on, degrees. On meshes of 2,000
/// to 30,000 triangles of smooth surfaces no edge has more, beside edges that should be creases 1
/// to 10 % of all have.
constexpr double kWaveAngle = 6;

/// From here on the surface is not one that anybody meant, degrees.
constexpr double kFoldAngle = 45;

/// Nor is it where a part of it turns so far away from the face that it is over, degrees.
constexpr double kMostPartTurn = 60;

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Normals of the limit surface of a cage after a step of subdivision, and its positions.
class LimitNormals {
 public:
  LimitNormals(Far::TopologyRefiner& refiner, const std::vector<Vec3>& points) {
    Far::TopologyRefiner::UniformOptions options(1);
    options.fullTopologyInLastLevel = true;
    refiner.RefineUniform(options);
    std::vector<Primvar> coarse;
    for (const Vec3& point : points) coarse.push_back({point});
    const auto count = static_cast<std::size_t>(refiner.GetLevel(1).GetNumVertices());
    std::vector<Primvar> fine(count), along(count), across(count);
    positions_.resize(count);
    const Far::PrimvarRefinerReal<double> primvars(refiner);
    primvars.Interpolate(1, coarse, fine);
    primvars.Limit(fine, positions_, along, across);
    for (std::size_t v = 0; v < count; ++v) {
      normals_.push_back(along[v].point.cross(across[v].point));
    }
  }

  const Vec3& position(int vertex) const {
    return positions_[static_cast<std::size_t>(vertex)].point;
  }
  const Vec3& normal(int vertex) const { return normals_[static_cast<std::size_t>(vertex)]; }

 private:
  std::vector<Primvar> positions_;
  std::vector<Vec3> normals_;
};

/// Compares a limit surface with the faces of a mesh.
class WaveMeter {
 public:
  WaveMeter(const Cage& mesh, const Far::TopologyRefiner& refiner, const LimitNormals& limit)
      : mesh_(mesh), level_(refiner.GetLevel(0)), parts_(refiner.GetLevel(1)), limit_(limit) {
    for (int f = 0; f < level_.GetNumFaces(); ++f) areas_.push_back(area_of(f));
    turns_.resize(areas_.size(), 0);
    for (int e = 0; e < level_.GetNumEdges(); ++e) {
      if (!is_smooth(e)) continue;
      const Far::ConstIndexArray faces = level_.GetEdgeFaces(e);
      const double angle = angle_between(area(faces[0]), area(faces[1]));
      for (const int face : faces) {
        double& greatest = turns_[static_cast<std::size_t>(face)];
        greatest = std::max(greatest, angle);
      }
    }
  }

  SurfaceWaves measure() const {
    SurfaceWaves waves;
    for (int e = 0; e < level_.GetNumEdges(); ++e) {
      if (is_smooth(e)) add_edge(e, waves);
    }
    for (int f = 0; f < level_.GetNumFaces(); ++f) {
      if (is_folded(f)) waves.folded_faces.push_back(f);
    }
    std::vector<int>& folded = waves.folded_faces;
    std::sort(folded.begin(), folded.end());
    folded.erase(std::unique(folded.begin(), folded.end()), folded.end());
    return waves;
  }

 private:
  const Vec3& area(int face) const { return areas_[static_cast<std::size_t>(face)]; }
  double turn(int face) const { return turns_[static_cast<std::size_t>(face)]; }

  bool is_smooth(int edge) const {
    return level_.GetEdgeFaces(edge).size() == 2 && level_.GetEdgeSharpness(edge) <= 0;
  }

  Vec3 area_of(int f) const {
    return area_of(level_.GetFaceVertices(f), [this](int v) -> const Vec3& {
      return mesh_.points[static_cast<std::size_t>(v)];
    });
  }

  template <class PointOf>
  static Vec3 area_of(const Far::ConstIndexArray& face, PointOf point) {
    Vec3 sum = Vec3::Zero();
    for (int k = 2; k < face.size(); ++k) {
      sum += (point(face[k - 1]) - point(face[0])).cross(point(face[k]) - point(face[0]));
    }
    return sum;
  }

  /// True if a part of the surface over a face turns away from it, as between creases that bulge
  /// across each other.
  bool is_folded(int f) const {
    for (const int part : level_.GetFaceChildFaces(f)) {
      const Vec3 area = area_of(parts_.GetFaceVertices(part),
                                [this](int v) -> const Vec3& { return limit_.position(v); });
      const double angle = angle_between(area, areas_[static_cast<std::size_t>(f)]);
      if (angle > std::max(turn(f), kMostPartTurn / kDegrees)) return true;
    }
    return false;
  }

  void add_edge(int e, SurfaceWaves& waves) const {
    const Far::ConstIndexArray faces = level_.GetEdgeFaces(e);
    const Vec3 &a = area(faces[0]), &b = area(faces[1]);
    const int vertex = level_.GetEdgeChildVertex(e);
    const Vec3 middle = a.normalized() + b.normalized();
    const double excess = angle_between(limit_.normal(vertex), middle) - angle_between(a, b) / 2;
    ++waves.edges;
    if (excess <= kWaveAngle / kDegrees) return;
    if (excess <= std::max(turn(faces[0]), turn(faces[1]))) return;
    ++waves.waves;
    if (excess * kDegrees > kFoldAngle) {
      waves.folded_faces.insert(waves.folded_faces.end(), faces.begin(), faces.end());
    }
    if (excess * kDegrees <= waves.greatest) return;
    waves.greatest = excess * kDegrees;
    waves.point = limit_.position(vertex);
  }

  const Cage& mesh_;
  Far::TopologyLevel level_;
  Far::TopologyLevel parts_;  ///< after a step of subdivision
  const LimitNormals& limit_;
  std::vector<Vec3> areas_;    ///< twice those of the faces, along their normals
  std::vector<double> turns_;  ///< greatest angle of a face with one beside it
};

}  // namespace

SurfaceWaves measure_waves(const Cage& mesh, const Cage& cage, Scheme scheme) {
  const CageTopology topology = make_topology(cage, scheme);
  const LimitNormals limit(*topology.refiner, cage.points);
  return WaveMeter(mesh, *topology.refiner, limit).measure();
}

}  // namespace surfmesh
