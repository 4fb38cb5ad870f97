// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/surface_waves.hh"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/sdc/crease.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "surfmesh/cage/face_angles.hh"
#include "surfmesh/cage/primvar.hh"
#include "surfmesh/cage/subdivision.hh"

namespace surfmesh {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

using detail::angle_between;
using detail::area_vector;
using detail::kDegrees;

/// What the surface turns more than the faces is a wave from here on, degrees. On meshes of 2,000
/// to 30,000 triangles of smooth surfaces no edge has more, beside edges that should be creases 1
/// to 10 % of all have.
constexpr double kWaveAngle = 6;

/// From here on the surface is not one that anybody meant, degrees.
constexpr double kFoldAngle = 45;

/// Nor is it where a part of it turns so far away from the face that it is over, degrees.
constexpr double kMostPartTurn = 60;

/// What is left of semi-sharp tags of this sharpness after a step of subdivision is nothing.
constexpr float kGoneAfterAStep = 1;

bool outlasts_a_step(float sharpness) {
  return Sdc::Crease::IsSemiSharp(sharpness) && sharpness > kGoneAfterAStep;
}

/// The faces over which the limit normals are known: those that have a surface, and no vertex at
/// which a semi-sharp tag goes on after a step of subdivision, which limit masks overlook.
std::vector<char> known_faces(const Far::TopologyLevel& level) {
  std::vector<char> is_known(static_cast<std::size_t>(level.GetNumFaces()), 1);
  const auto leave_out_around = [&](int vertex) {
    for (const int f : level.GetVertexFaces(vertex)) is_known[static_cast<std::size_t>(f)] = 0;
  };
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    if (outlasts_a_step(level.GetVertexSharpness(v))) leave_out_around(v);
  }
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    if (!outlasts_a_step(level.GetEdgeSharpness(e))) continue;
    for (const int vertex : level.GetEdgeVertices(e)) leave_out_around(vertex);
  }
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    if (level.IsFaceHole(f)) is_known[static_cast<std::size_t>(f)] = 0;
  }
  return is_known;
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
      : level_(refiner.GetLevel(0)),
        parts_(refiner.GetLevel(1)),
        limit_(limit),
        is_known_(known_faces(level_)) {
    for (int f = 0; f < level_.GetNumFaces(); ++f) {
      areas_.push_back(area_vector(level_.GetFaceVertices(f), mesh.points));
    }
    turns_.resize(areas_.size(), 0);
    for (int e = 0; e < level_.GetNumEdges(); ++e) {
      if (!is_measured(e)) continue;
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
      if (is_measured(e)) add_edge(e, waves);
    }
    for (int f = 0; f < level_.GetNumFaces(); ++f) {
      if (is_known(f) && is_folded(f)) waves.folded_faces.push_back(f);
    }
    std::vector<int>& folded = waves.folded_faces;
    std::sort(folded.begin(), folded.end());
    folded.erase(std::unique(folded.begin(), folded.end()), folded.end());
    return waves;
  }

 private:
  const Vec3& area(int face) const { return areas_[static_cast<std::size_t>(face)]; }
  double turn(int face) const { return turns_[static_cast<std::size_t>(face)]; }

  bool is_known(int face) const { return is_known_[static_cast<std::size_t>(face)] != 0; }

  /// True for an edge of two known faces that is no crease.
  bool is_measured(int edge) const {
    const Far::ConstIndexArray faces = level_.GetEdgeFaces(edge);
    return faces.size() == 2 && level_.GetEdgeSharpness(edge) <= 0 && is_known(faces[0]) &&
           is_known(faces[1]);
  }

  /// True if a part of the surface over a face turns away from it, as between creases that bulge
  /// across each other.
  bool is_folded(int f) const {
    for (const int part : level_.GetFaceChildFaces(f)) {
      const Vec3 part_area =
          area_vector(parts_.GetFaceVertices(part),
                      [this](int v) -> const Vec3& { return limit_.position(v); });
      if (angle_between(part_area, area(f)) > std::max(turn(f), kMostPartTurn / kDegrees))
        return true;
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

  Far::TopologyLevel level_;
  Far::TopologyLevel parts_;  ///< after a step of subdivision
  const LimitNormals& limit_;
  std::vector<char> is_known_;  ///< by face
  std::vector<Vec3> areas_;     ///< twice those of the faces, along their normals
  std::vector<double> turns_;   ///< greatest angle of a face with one beside it
};

}  // namespace

SurfaceWaves measure_waves(const Cage& mesh, const Cage& cage, Scheme scheme) {
  const CageTopology topology = make_topology(cage, scheme);
  const LimitNormals limit(*topology.refiner, cage.points);
  return WaveMeter(mesh, *topology.refiner, limit).measure();
}

}  // namespace surfmesh
