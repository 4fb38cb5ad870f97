// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/quality/facet_distance.hh"
#include "surfmesh/quality/sharp_contours.hh"
#include "surfmesh/quality/surface_search.hh"

namespace surfmesh::compare {

/// Mean and greatest of some distances.
struct Distances {
  double mean = 0;
  double max = 0;

  friend bool operator==(const Distances&, const Distances&) = default;
};

/// A mesh beside the smooth surface that it stands for. Distances are shares of the diagonal.
struct RemeshJudgement {
  std::size_t faces = 0;
  double area = 0;         ///< model units
  double mean_edge = 0;    ///< length, model units
  Distances facets;        ///< of the faces from the surface, by area
  Distances vertices;      ///< of the vertices from the surface, by the area around them
  Distances from_surface;  ///< of the surface from the mesh
  double features = 0;     ///< greatest, of creases and borders of the surface from the mesh
  double least_quality = 0;
  double mean_quality = 0;
  long euler = 0;
  std::size_t components = 0;
  std::size_t boundary_loops = 0;
  std::size_t crossings = 0;  ///< pairs of faces that pass through each other
  /// Faces by more than 120° from the surface. Those that are farther from it than a quarter of
  /// their longest side do not count: the input lacks what the surface is there, and the nearest
  /// point may be on its other side.
  std::size_t turned = 0;
  std::string faults;  ///< of the connectivity, by their kinds; empty if there are none

  /// True if the meshes have the same borders, components and Euler characteristic, and no faults
  /// that differ.
  bool has_topology_of(const RemeshJudgement& other) const;
};

/// The limit surface of a cage, by which meshes are judged.
class RemeshJudge {
 public:
  /// Throws   as load_model
  explicit RemeshJudge(const std::filesystem::path& cage);

  RemeshJudge(const RemeshJudge&) = delete;
  RemeshJudge& operator=(const RemeshJudge&) = delete;

  double diagonal() const { return input_.model.diagonal; }

  /// Judge a mesh of any format that the library reads. Patches of the file do not matter.
  ///
  /// Q = 4√3·A/Σl² in space; a quad counts as the two triangles of its shorter diagonal. Of large
  /// meshes 20,000 facets and as many vertices are measured, spread evenly.
  /// Error    greatest distances are lower bounds: a facet is sampled at its middle, the middles of
  ///          its sides and its corners. Means are exact for cubic polynomials
  /// Throws   as read_mesh_arrays
  RemeshJudgement judge(const std::filesystem::path& mesh) const;

 private:
  void measure_vertices(const Facets& facets, std::size_t count, RemeshJudgement& judgement) const;
  void measure_facets(const Facets& facets, RemeshJudgement& judgement) const;
  void measure_back(const PolyMesh& mesh, RemeshJudgement& judgement) const;

  ModelInput input_;
  SurfaceSearch search_;
  std::vector<SharpContour> features_;
};

}  // namespace surfmesh::compare
