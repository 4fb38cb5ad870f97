// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/stage.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/pipeline/options.hh"
#include "surfmesh/quality/patch_measures.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {

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
    PerStage<QueryCounts> queries;  ///< how each stage's questions for the metric were answered
  };

  /// Greatest distance between mesh and surface, model units.
  struct Sag {
    std::optional<double> asked;
    std::optional<double> reached;  ///< measured if asked for
  };

  std::string input;
  PipelineOptions options;  ///< the effective values
  Notices notices;          ///< a tool ends with status 3 if one is a shortfall
  Mesh mesh;
  std::vector<PatchMeasure> patches;
  EdgeStatistics edges;       ///< in the metric of the control space
  QualityStatistics quality;  ///< likewise
  Sag sag;
  Control control;
  PerStage<double> seconds;  ///< of processor, over all threads
  double wall_seconds = 0;   ///< by the clock

  /// Triangles over processor time without reading, control space, report and writing: the NT/s of
  /// the paper. 0 if no time has passed.
  double triangles_per_second() const;
};

/// The report as JSON text, with the keys of the documentation.
std::string to_json(const Report& report);

/// The report in about ten lines for a terminal.
std::string to_text(const Report& report);

}  // namespace surfmesh
