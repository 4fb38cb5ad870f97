// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surfmesh/pipeline/options.hh"
#include "surfmesh/quality/patch_measures.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {

/// Processor time of the stages in seconds, over all threads; `wall` is by the clock.
struct StageSeconds {
  double read = 0;
  double control = 0;
  double boundary = 0;
  double triangulate = 0;
  double refine = 0;
  double improve = 0;
  double quad = 0;
  double assemble = 0;
  double write = 0;
  double total = 0;  ///< of all stages above
  double wall = 0;

  /// Add the stages of meshing and the control space.
  StageSeconds& operator+=(const StageSeconds& other) {
    control += other.control;
    boundary += other.boundary;
    triangulate += other.triangulate;
    refine += other.refine;
    improve += other.improve;
    assemble += other.assemble;
    return *this;
  }
};

/// What a run made, how good it is and what it cost.
struct Report {
  struct Mesh {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t quads = 0;
    std::size_t patches = 0;
    bool is_closed = false;
    long euler = 0;
  };

  /// How often each stage asked for the metric, and how it was answered.
  struct Queries {
    QueryCounts boundary;
    QueryCounts triangulate;
    QueryCounts refine;
    QueryCounts improve;
    QueryCounts quad;
  };

  /// Control triangles by their interpolation; a grid has none.
  struct Classes {
    std::size_t single = 0;
    std::size_t triangle = 0;
    std::size_t circles = 0;
    std::size_t linear = 0;
  };

  struct Control {
    std::size_t nodes = 0;
    std::size_t triangles = 0;
    Classes classes;
    Queries queries;
  };

  /// Greatest distance between mesh and surface, model units.
  struct Sag {
    std::optional<double> asked;
    std::optional<double> reached;  ///< measured if asked for
  };

  std::string input;
  PipelineOptions options;  ///< the effective values
  std::vector<std::string> warnings;
  /// What was asked for and not reached, in plain English; a tool ends with status 3.
  std::vector<std::string> shortfalls;
  Mesh mesh;
  std::vector<PatchMeasure> patches;
  EdgeStatistics edges;       ///< in the metric of the control space
  QualityStatistics quality;  ///< likewise
  Sag sag;
  Control control;
  StageSeconds seconds;
  /// Triangles over processor time without reading, control space, report and writing: the NT/s of
  /// the paper.
  double triangles_per_second = 0;
};

/// The report as JSON text, with the keys of the documentation.
std::string to_json(const Report& report);

/// The report in about ten lines for a terminal.
std::string to_text(const Report& report);

}  // namespace surfmesh
