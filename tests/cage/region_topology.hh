// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/cage/face_neighbours.hh"
#include "surfmesh/cage/gather_regions.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/cage/subdivision.hh"

namespace surfmesh::testing {

/// A cage with all that regions are made of.
struct RegionTopology {
  explicit RegionTopology(const Cage& cage, std::vector<int> sets_of_faces = {})
      : scheme(resolve_scheme(cage, Scheme::Auto)),
        topology(make_topology(cage, scheme)),
        surfaces(make_limit_surfaces(cage, scheme)),
        sets(std::move(sets_of_faces)) {
    sets.resize(cage.faces.size(), 0);
    for (std::size_t f = 0; f < sets.size(); ++f) {
      if (!surfaces[f]) sets[f] = -1;
    }
  }

  FaceNeighbours neighbours() const { return FaceNeighbours(*topology.refiner, sets); }
  std::vector<FaceRegion> regions() const { return gather_regions(neighbours(), surfaces); }

  Scheme scheme;
  CageTopology topology;
  std::vector<std::shared_ptr<const Surface>> surfaces;
  std::vector<int> sets;
};

}  // namespace surfmesh::testing
