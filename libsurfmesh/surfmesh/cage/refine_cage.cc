// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/refine_cage.hh"

#include <fmt/format.h>
#include <opensubdiv/far/primvarRefiner.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "surfmesh/cage/primvar.hh"
#include "surfmesh/cage/select_faces.hh"
#include "surfmesh/cage/subdivision.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

namespace Far = OpenSubdiv::Far;

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

/// The vertices of faces of four corners keep their order in quarters: quarter i has its corner i
/// at that of the face. Quarters of other faces begin there.
QuarterOfFace quarter_of(const Far::TopologyLevel& coarse, const Far::TopologyLevel& fine,
                         int face) {
  const Far::ConstIndexArray corners = coarse.GetFaceVertices(fine.GetFaceParentFace(face));
  const Far::ConstIndexArray vertices = fine.GetFaceVertices(face);
  for (int part = 0; part < corners.size(); ++part) {
    const int rotation = vertices.FindIndex(coarse.GetVertexChildVertex(corners[part]));
    if (rotation >= 0) return {part, rotation, corners.size()};
  }
  return {};
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
    Cage::FaceGroup fine{group.name, {}, group.is_material};
    for (int face : group.faces) {
      if (face < 0 || static_cast<std::size_t>(face) >= children.size()) continue;
      const std::vector<int>& parts = children[static_cast<std::size_t>(face)];
      fine.faces.insert(fine.faces.end(), parts.begin(), parts.end());
    }
    refined.cage.groups.push_back(std::move(fine));
  }
}

/// Leave out the faces that are not simple, and with them their tags and places in groups.
RefinedCage leave_out_faces(const Cage& cage, const std::vector<int>& numbers) {
  RefinedCage result;
  std::vector<int> stand_ins;
  for (int f = 0; static_cast<std::size_t>(f) < cage.faces.size(); ++f) {
    stand_ins.push_back(is_simple(cage.faces[static_cast<std::size_t>(f)]) ? f : -1);
    if (stand_ins.back() == f) continue;
    result.notices.push_back(warning(
        NoticeKind::IgnoredInput,
        fmt::format("face {} comes back to a vertex, or has fewer than three different ones; it "
                    "is left out",
                    numbers[static_cast<std::size_t>(f)])));
  }
  for (const int f : selected_faces(stand_ins)) {
    result.parent_faces.push_back(numbers[static_cast<std::size_t>(f)]);
  }
  result.cage = select_faces(cage, stand_ins);
  return result;
}

void add_whole_faces(RefinedCage& simple) {
  for (const std::vector<int>& face : simple.cage.faces) {
    simple.quarters.push_back({-1, 0, static_cast<int>(face.size())});
  }
}

/// Leave out of each face the vertices that are the same as the next one.
void leave_out_sides(RefinedCage& simple) {
  for (std::size_t f = 0; f < simple.cage.faces.size(); ++f) {
    std::vector<int> face = without_repeats(simple.cage.faces[f]);
    if (face.size() == simple.cage.faces[f].size()) continue;
    simple.notices.push_back(
        warning(NoticeKind::IgnoredInput,
                fmt::format("face {} has the same vertex twice in a row; once is taken",
                            simple.parent_faces[f])));
    simple.cage.faces[f] = std::move(face);
  }
}

bool is_all_quads(const Cage& cage) {
  return std::all_of(cage.faces.begin(), cage.faces.end(),
                     [](const auto& face) { return face.size() == 4; });
}

}  // namespace

RefinedCage refine_once(const Cage& cage, Scheme scheme) {
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    if (without_repeats(cage.faces[f]).size() == cage.faces[f].size()) continue;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("face {} has the same vertex twice in a row", f));
  }
  CageTopology topology = make_topology(cage, resolve_scheme(cage, scheme));
  Far::TopologyRefiner::UniformOptions options(1);
  options.fullTopologyInLastLevel = true;  // else its edges have no vertices
  topology.refiner->RefineUniform(options);
  const Far::TopologyLevel& level = topology.refiner->GetLevel(1);
  RefinedCage refined;
  refined.cage.points = refine_points(*topology.refiner, cage.points);
  copy_faces(level, refined);
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    refined.quarters.push_back(quarter_of(topology.refiner->GetLevel(0), level, f));
  }
  copy_sharpness(level, refined.cage);
  copy_groups(cage, refined);
  refined.cage.boundary = cage.boundary;
  refined.cage.is_chaikin = cage.is_chaikin;
  refined.cage.is_smooth_triangles = cage.is_smooth_triangles;
  refined.cage.notices = cage.notices;
  refined.notices = std::move(topology.notices);
  refined.is_refined = true;
  return refined;
}

RefinedCage make_regular(const Cage& cage, Scheme scheme) {
  std::vector<int> numbers(cage.faces.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return make_regular(cage, scheme, numbers);
}

RefinedCage make_simple(const Cage& cage, Scheme scheme, const std::vector<int>& numbers) {
  check_ranges(cage);
  RefinedCage simple = leave_out_faces(cage, numbers);
  if (simple.cage.faces.empty()) {
    throw Error(ErrorCode::InvalidInput,
                "each face of the cage comes back to a vertex, or has fewer than three different "
                "ones");
  }
  if (scheme != Scheme::Loop && is_all_quads(simple.cage)) return simple;
  leave_out_sides(simple);
  if (scheme == Scheme::Loop) check_triangles(simple.cage, simple.parent_faces);
  return simple;
}

RefinedCage make_regular(const Cage& cage, Scheme scheme, const std::vector<int>& numbers) {
  scheme = resolve_scheme(cage, scheme);
  RefinedCage simple = make_simple(cage, scheme, numbers);
  if (scheme == Scheme::Loop || is_all_quads(simple.cage)) {
    add_whole_faces(simple);
    return simple;
  }
  RefinedCage refined = refine_once(simple.cage, scheme);
  for (int& parent : refined.parent_faces) {
    parent = simple.parent_faces[static_cast<std::size_t>(parent)];
  }
  refined.notices.insert(refined.notices.begin(), simple.notices.begin(), simple.notices.end());
  return refined;
}

}  // namespace surfmesh
