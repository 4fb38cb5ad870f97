// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh::paper {

/// How a mesh is made.
enum class Way {
  Paper,       ///< as in section 2.1: circumcentres, smoothing by elements, quads from the fronts
  Unsmoothed,  ///< the same without smoothing
  Today        ///< with the defaults of surfmesh
};

/// Interpolations by their letters in the paper: t, o, x.
inline constexpr Interpolation kT = Interpolation::Triangle, kO = Interpolation::Circles,
                               kX = Interpolation::Automatic;

/// A row of the tables: how sizes are interpolated, and between which nodes.
struct Variant {
  Interpolation interpolation = Interpolation::Triangle;
  bool has_inner_nodes = false;  ///< I
  bool is_reusing = false;       ///< R
  int nodes = 0;                 ///< regular ones; 0: those that the model gives
  double conformity = 0;         ///< see RefineOptions, in the paper's way
};

/// "V_x+IR".
std::string label(const Variant& variant);

struct EdgeFigures {
  double mean = 0;       ///< μ
  double deviation = 0;  ///< σ
};

/// What a mesh is, and what it took.
struct Outcome {
  Report report;
  EdgeFigures own;           ///< in the metric that it was made by
  EdgeFigures by_triangles;  ///< in that of V_t
  EdgeFigures by_circles;    ///< in that of V_o
  std::shared_ptr<const MeshResult> result;

  std::size_t elements() const { return report.mesh.triangles + report.mesh.quads; }
  double generation_seconds() const;  ///< t_g
  double control_seconds() const;     ///< t_c
  double steps_of_a_walk() const;     ///< from triangle to triangle, to that of a point
};

/// One of the examples of section 5.
class Experiment {
 public:
  /// Throws   as load_model; InvalidInput if the model has more than one patch
  explicit Experiment(const std::filesystem::path& model);

  /// Mesh it, by triangles or by quads.
  Outcome run(const Variant& variant, Way way, bool has_quads = false);

  /// The control space of a variant, without R.
  const ControlSpace& control(const Variant& variant);

 private:
  PipelineOptions options(const Variant& variant, Way way, bool has_quads) const;
  EdgeFigures measure(PolyMesh& mesh, Variant variant, Interpolation by);

  ModelInput input_;
  std::map<std::string, ControlSpaces> controls_;  ///< by label and number of nodes
};

}  // namespace surfmesh::paper
