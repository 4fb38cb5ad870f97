// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <opensubdiv/sdc/crease.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/cage/subdivision.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// What OpenSubdiv's factory reads, and where it leaves its warnings (it gets a const reference).
struct TaggedCage {
  const Cage& cage;
  Notices& notices;
};

}  // namespace
}  // namespace surfmesh

// The customisation point of OpenSubdiv for a mesh type of one's own. Its ready-made factory for a
// TopologyDescriptor would print a warning for every tag that names an edge that does not exist.
namespace OpenSubdiv {
namespace OPENSUBDIV_VERSION {
namespace Far {

using surfmesh::Cage;
using surfmesh::TaggedCage;

template <>
bool TopologyRefinerFactory<TaggedCage>::resizeComponentTopology(TopologyRefiner& refiner,
                                                                 const TaggedCage& tagged) {
  setNumBaseVertices(refiner, static_cast<int>(tagged.cage.points.size()));
  setNumBaseFaces(refiner, static_cast<int>(tagged.cage.faces.size()));
  for (std::size_t f = 0; f < tagged.cage.faces.size(); ++f) {
    setNumBaseFaceVertices(refiner, static_cast<Index>(f),
                           static_cast<int>(tagged.cage.faces[f].size()));
  }
  return true;
}

template <>
bool TopologyRefinerFactory<TaggedCage>::assignComponentTopology(TopologyRefiner& refiner,
                                                                 const TaggedCage& tagged) {
  for (std::size_t f = 0; f < tagged.cage.faces.size(); ++f) {
    const std::vector<int>& face = tagged.cage.faces[f];
    IndexArray vertices = getBaseFaceVertices(refiner, static_cast<Index>(f));
    for (std::size_t i = 0; i < face.size(); ++i) vertices[static_cast<int>(i)] = face[i];
  }
  return true;
}

template <>
bool TopologyRefinerFactory<TaggedCage>::assignComponentTags(TopologyRefiner& refiner,
                                                             const TaggedCage& tagged) {
  const auto is_index = [](int i, int count) { return i >= 0 && i < count; };
  // Written so that NaN is not a sharpness either.
  const auto is_sharpness = [](double sharpness) { return sharpness >= 0; };
  const auto clamped = [](double sharpness) {
    return std::min(static_cast<float>(sharpness), Sdc::Crease::SHARPNESS_INFINITE);
  };
  const auto ignore = [&](const std::string& what) {
    tagged.notices.push_back(
        surfmesh::warning(surfmesh::NoticeKind::IgnoredInput, what + "; the tag is ignored"));
  };
  const int vertex_count = getNumBaseVertices(refiner);
  for (const Cage::Crease& crease : tagged.cage.creases) {
    const auto [a, b] = crease.edge;
    const bool is_range = is_index(a, vertex_count) && is_index(b, vertex_count);
    const Index edge = is_range ? findBaseEdge(refiner, a, b) : Vtr::INDEX_INVALID;
    if (edge == Vtr::INDEX_INVALID) {
      ignore(fmt::format("a crease names the edge of vertices {} and {}, which no face has", a, b));
    } else if (!is_sharpness(crease.sharpness)) {
      ignore(fmt::format("the crease of vertices {} and {} has sharpness {}, which is not positive",
                         a, b, crease.sharpness));
    } else {
      setBaseEdgeSharpness(refiner, edge, clamped(crease.sharpness));
    }
  }
  for (const Cage::Corner& corner : tagged.cage.corners) {
    if (!is_index(corner.vertex, vertex_count)) {
      ignore(fmt::format("a corner names vertex {}, which does not exist", corner.vertex));
    } else if (!is_sharpness(corner.sharpness)) {
      ignore(fmt::format("the corner of vertex {} has sharpness {}, which is not positive",
                         corner.vertex, corner.sharpness));
    } else {
      setBaseVertexSharpness(refiner, corner.vertex, clamped(corner.sharpness));
    }
  }
  for (int face : tagged.cage.holes) {
    if (is_index(face, getNumBaseFaces(refiner))) {
      setBaseFaceHole(refiner, face, true);
    } else {
      ignore(fmt::format("a hole names face {}, which does not exist", face));
    }
  }
  return true;
}

template <>
bool TopologyRefinerFactory<TaggedCage>::assignFaceVaryingTopology(TopologyRefiner&,
                                                                   const TaggedCage&) {
  return true;
}

template <>
void TopologyRefinerFactory<TaggedCage>::reportInvalidTopology(TopologyError, const char* text,
                                                               const TaggedCage& tagged) {
  tagged.notices.push_back(surfmesh::warning(surfmesh::NoticeKind::IgnoredInput, text));
}

}  // namespace Far
}  // namespace OPENSUBDIV_VERSION
}  // namespace OpenSubdiv

namespace surfmesh {
namespace {

OpenSubdiv::Sdc::SchemeType sdc_scheme(Scheme scheme) {
  switch (scheme) {
    case Scheme::Loop:
      return OpenSubdiv::Sdc::SCHEME_LOOP;
    case Scheme::Bilinear:
      return OpenSubdiv::Sdc::SCHEME_BILINEAR;
    case Scheme::Auto:
    case Scheme::CatmullClark:
      break;
  }
  return OpenSubdiv::Sdc::SCHEME_CATMARK;
}

OpenSubdiv::Sdc::Options sdc_options(const Cage& cage) {
  using Sdc = OpenSubdiv::Sdc::Options;
  Sdc options;
  options.SetVtxBoundaryInterpolation(cage.boundary == BoundaryRule::None ? Sdc::VTX_BOUNDARY_NONE
                                      : cage.boundary == BoundaryRule::EdgeAndCorner
                                          ? Sdc::VTX_BOUNDARY_EDGE_AND_CORNER
                                          : Sdc::VTX_BOUNDARY_EDGE_ONLY);
  options.SetCreasingMethod(cage.is_chaikin ? Sdc::CREASE_CHAIKIN : Sdc::CREASE_UNIFORM);
  options.SetTriangleSubdivision(cage.is_smooth_triangles ? Sdc::TRI_SUB_SMOOTH
                                                          : Sdc::TRI_SUB_CATMARK);
  return options;
}

}  // namespace

void check_triangles(const Cage& cage, const std::vector<int>& numbers) {
  const auto face = std::find_if(cage.faces.begin(), cage.faces.end(),
                                 [](const auto& f) { return f.size() != 3; });
  if (face == cage.faces.end()) return;
  const auto index = static_cast<std::size_t>(face - cage.faces.begin());
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("face {} has {} vertices: the Loop scheme knows triangles only",
                  numbers.empty() ? static_cast<int>(index) : numbers[index], face->size()));
}

CageTopology make_topology(const Cage& cage, Scheme scheme) {
  check(cage);
  if (scheme == Scheme::Loop) check_triangles(cage);
  using Factory = OpenSubdiv::Far::TopologyRefinerFactory<TaggedCage>;
  CageTopology topology;
  topology.refiner.reset(Factory::Create(TaggedCage{cage, topology.notices},
                                         Factory::Options(sdc_scheme(scheme), sdc_options(cage))));
  if (!topology.refiner) {
    throw Error(ErrorCode::InvalidInput, "OpenSubdiv refuses the topology of the cage");
  }
  return topology;
}

}  // namespace surfmesh
