// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/patch_measures.hh"

#include <algorithm>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/quality/patch_runs.hh"

namespace surfmesh {
namespace {

struct FaceSums {
  std::size_t triangles = 0;
  std::size_t quads = 0;
  std::size_t polygons = 0;
  double area = 0;
};

void add_face(const PolyMesh& mesh, FaceHandle fh, FaceSums& patch) {
  const HalfedgeHandle start = mesh.halfedge_handle(fh);
  const OpenMesh::Vec3d& origin = mesh.point(mesh.to_vertex_handle(start));
  OpenMesh::Vec3d doubled(0, 0, 0);
  HalfedgeHandle heh = mesh.next_halfedge_handle(start);
  int corners = 2;
  for (;; ++corners) {
    const HalfedgeHandle next = mesh.next_halfedge_handle(heh);
    if (next == start) break;
    doubled += OpenMesh::cross(mesh.point(mesh.to_vertex_handle(heh)) - origin,
                               mesh.point(mesh.to_vertex_handle(next)) - origin);
    heh = next;
  }
  ++(corners == 3 ? patch.triangles : corners == 4 ? patch.quads : patch.polygons);
  patch.area += 0.5 * doubled.norm();
}

detail::PatchRuns<FaceSums> measure_runs(const PolyMesh& mesh,
                                         const std::vector<int>& patch_of_faces) {
  return sum_of_ranges(patch_of_faces.size(), [&](std::size_t first, std::size_t end) {
    detail::PatchRuns<FaceSums> runs;
    for (std::size_t f = first; f < end; ++f) {
      add_face(mesh, FaceHandle(static_cast<int>(f)), runs.next(patch_of_faces[f]));
    }
    return runs;
  });
}

}  // namespace

std::vector<PatchMeasure> measure_patches(const PolyMesh& mesh, const MeshNames& names) {
  std::vector<PatchMeasure> patches;
  const auto patch_of = find(mesh, keys::face_patch);
  if (!patch_of.is_valid()) return patches;
  const std::vector<int>& numbers = mesh.property(patch_of).data_vector();
  const int most = numbers.empty() ? -1 : *std::max_element(numbers.begin(), numbers.end());
  patches.resize(std::max(names.patches.size(), static_cast<std::size_t>(most + 1)));
  const auto groups = groups_by_patch(names, patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (p < names.patches.size()) patches[p].name = names.patches[p];
    for (const int group : groups[p]) {
      patches[p].groups.push_back(names.groups[static_cast<std::size_t>(group)].name);
    }
  }
  for (const auto& [patch, sums] : measure_runs(mesh, numbers)) {
    if (patch < 0) continue;
    PatchMeasure& measure = patches[static_cast<std::size_t>(patch)];
    measure.triangles += sums.triangles;
    measure.quads += sums.quads;
    measure.polygons += sums.polygons;
    measure.area += sums.area;
  }
  return patches;
}

}  // namespace surfmesh
