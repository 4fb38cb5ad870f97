// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/stage.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pipeline/given_options.hh"
#include "surfmesh/pipeline/options.hh"
#include "surfmesh/pipeline/text_style.hh"
#include "surfmesh/quality/facet_distance.hh"
#include "surfmesh/quality/patch_measures.hh"
#include "surfmesh/quality/quad_statistics.hh"
#include "surfmesh/quality/statistics.hh"
#include "surfmesh/refine/refine.hh"

namespace surfmesh {

/// What a run made, its quality and its cost.
struct Report {
  /// What the mesh consists of.
  struct Mesh {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t quads = 0;
    std::size_t patches = 0;
    bool is_closed = false;
    long euler = 0;
  };

  /// The parts that are meshed by themselves.
  struct Tiles {
    std::size_t count = 0;    ///< patches that are whole among them
    std::size_t refused = 0;  ///< that stay larger than asked, for no line cuts them well
  };

  /// A mesh that is made in pieces by one or more ranks.
  struct Pieces {
    std::size_t count = 0;
    std::vector<std::size_t> faces_of_ranks;  ///< by rank, in the report of an estimate foretold
    std::vector<double> seconds_of_ranks;     ///< processor time; empty in that of an estimate
    std::size_t of_several_pieces = 0;        ///< vertices
    std::size_t of_several_ranks = 0;         ///< vertices
    std::size_t bytes_sent = 0;               ///< by all ranks together

    /// The most faces of a rank, in the mean number of a rank; 1 if there are none.
    double largest_share() const;
  };

  /// Numbers of control faces by interpolation.
  struct Classes {
    std::size_t single = 0;
    std::size_t triangle = 0;
    std::size_t circles = 0;
    std::size_t linear = 0;
  };

  /// The control spaces of all patches together.
  struct Control {
    ControlKind kind = ControlKind::Cells;  ///< that took effect
    std::size_t nodes = 0;
    std::size_t faces = 0;
    Classes classes;
    PrecisionSample precision;      ///< of all patches; of cells and of grids with chosen nodes
    PerStage<QueryCounts> queries;  ///< how the metric queries of each stage were answered
  };

  /// Greatest distance between mesh and surface, model units.
  struct Sag {
    std::optional<double> asked;
    std::optional<double> reached;           ///< measured only with a requested sag
    std::optional<std::size_t> evaluations;  ///< of surfaces, in all meshes it took; likewise
  };

  /// Lengths of the edges of the mesh, model units.
  struct Lengths {
    double min = 0;
    double mean = 0;
    double max = 0;
  };

  /// The first face of the least quality.
  struct WorstFace {
    std::string patch;
    Vec3 point;  ///< its centre
  };

  std::string input;
  std::string output;                        ///< empty for none
  std::vector<std::filesystem::path> files;  ///< all that were read
  std::vector<GivenOption> given;            ///< with a value of their own, and where from
  PipelineOptions options;                   ///< the effective values
  Notices notices;                           ///< a tool exits with status 3 if one is a shortfall
  double estimated_elements = 0;  ///< known before the mesh is made, see TriangleEstimate
  Mesh mesh;
  Tiles tiles;
  std::optional<Pieces> pieces;  ///< none of a mesh in one piece
  std::vector<PatchMeasure> patches;
  EdgeStatistics edges;       ///< in the metric of the control space
  QualityStatistics quality;  ///< likewise
  double diagonal = 0;        ///< of the model's box, model units
  double tolerance = 0;       ///< greatest one of the model's contours and vertices, model units
  std::vector<SurfaceFit> surfaces;  ///< of cages whose surface passes through their points
  Lengths lengths;
  std::optional<WorstFace> worst;
  QuadStatistics quads;
  std::optional<WorstFace> worst_quad;
  std::optional<WorstFace> worst_quad_in_space;
  Sag sag;
  /// From the faces of the meshes that the surface interpolates, and back; none if it does not.
  std::optional<FacetDistance> facets;
  RefineCounts refine;  ///< of triangles in all patches; zeros where quads are made without them
  Control control;
  PerStage<double> seconds;  ///< processor time of all threads
  /// Of these, what more threads do not make shorter: outside of calls that share work among
  /// threads, without reading and gradation across contours.
  double serial_seconds = 0;
  double wall_seconds = 0;  ///< elapsed time

  /// Triangles, or quads, per second of processor time, without reading, control space, report and
  /// writing: the NT/s of the paper. 0 if no time has passed.
  double triangles_per_second() const;

  /// Triangles per second of processor time of the whole run; 0 if no time has passed.
  double triangles_per_second_in_all() const;
};

/// The report as JSON text, with the documented keys.
std::string to_json(const Report& report);

/// The report for a terminal: counts, histograms of quality and metric lengths, sag and time. The
/// long style adds all bins, the times of the stages, the worst patches, the control space, and the
/// options that were given.
std::string to_text(const Report& report, const TextStyle& style = {});

/// The report of estimate_mesh in a few lines for a terminal.
std::string estimate_text(const Report& report, const TextStyle& style = {});

}  // namespace surfmesh
