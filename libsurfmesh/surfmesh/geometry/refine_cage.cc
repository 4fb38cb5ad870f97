// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/refine_cage.hh"

#include <opensubdiv/far/primvarRefiner.h>

#include <utility>

#include "surfmesh/geometry/subdivision_detail.hh"

namespace surfmesh {
namespace {

namespace Far = OpenSubdiv::Far;

/// A point as OpenSubdiv's interpolation wants it.
struct Primvar {
  Vec3 point = Vec3::Zero();

  void Clear() { point.setZero(); }
  void AddWithWeight(const Primvar& other, double weight) { point += weight * other.point; }
};

std::vector<Vec3> refine_points(const Far::TopologyRefiner& refiner,
                                const std::vector<Vec3>& points) {
  std::vector<Primvar> coarse(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) coarse[i].point = points[i];
  std::vector<Primvar> fine(static_cast<std::size_t>(refiner.GetLevel(1).GetNumVertices()));
  Far::PrimvarRefinerReal<double>(refiner).Interpolate(1, coarse, fine);
  std::vector<Vec3> result;
  result.reserve(fine.size());
  for (const Primvar& primvar : fine) result.push_back(primvar.point);
  return result;
}

void copy_faces(const Far::TopologyLevel& level, RefinedCage& refined) {
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    const Far::ConstIndexArray vertices = level.GetFaceVertices(f);
    refined.cage.faces.emplace_back(vertices.begin(), vertices.end());
    refined.parent_faces.push_back(level.GetFaceParentFace(f));
    if (level.IsFaceHole(f)) refined.cage.holes.push_back(f);
  }
}

void copy_sharpness(const Far::TopologyLevel& level, Cage& cage) {
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    if (!(level.GetEdgeSharpness(e) > 0)) continue;
    const Far::ConstIndexArray ends = level.GetEdgeVertices(e);
    cage.creases.push_back({{ends[0], ends[1]}, level.GetEdgeSharpness(e)});
  }
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    if (level.GetVertexSharpness(v) > 0) cage.corners.push_back({v, level.GetVertexSharpness(v)});
  }
}

void copy_groups(const Cage& coarse, RefinedCage& refined) {
  std::vector<std::vector<int>> children(coarse.faces.size());
  for (std::size_t f = 0; f < refined.parent_faces.size(); ++f) {
    children[static_cast<std::size_t>(refined.parent_faces[f])].push_back(static_cast<int>(f));
  }
  for (const Cage::FaceGroup& group : coarse.groups) {
    Cage::FaceGroup fine{group.name, {}};
    for (int face : group.faces) {
      if (face < 0 || static_cast<std::size_t>(face) >= children.size()) continue;
      const std::vector<int>& parts = children[static_cast<std::size_t>(face)];
      fine.faces.insert(fine.faces.end(), parts.begin(), parts.end());
    }
    refined.cage.groups.push_back(std::move(fine));
  }
}

}  // namespace

RefinedCage refine_once(const Cage& cage, Scheme scheme) {
  CageTopology topology = make_topology(cage, resolve_scheme(cage, scheme));
  Far::TopologyRefiner::UniformOptions options(1);
  options.fullTopologyInLastLevel = true;  // else its edges have no vertices
  topology.refiner->RefineUniform(options);
  const Far::TopologyLevel& level = topology.refiner->GetLevel(1);
  RefinedCage refined;
  refined.cage.points = refine_points(*topology.refiner, cage.points);
  copy_faces(level, refined);
  copy_sharpness(level, refined.cage);
  copy_groups(cage, refined);
  refined.cage.boundary = cage.boundary;
  refined.cage.is_chaikin = cage.is_chaikin;
  refined.cage.is_smooth_triangles = cage.is_smooth_triangles;
  refined.cage.warnings = cage.warnings;
  refined.warnings = std::move(topology.warnings);
  return refined;
}

}  // namespace surfmesh
