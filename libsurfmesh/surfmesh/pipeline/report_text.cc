// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>
#include <string_view>
#include <vector>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/pipeline/facet_text.hh"
#include "surfmesh/pipeline/notice_text.hh"
#include "surfmesh/pipeline/report.hh"
#include "surfmesh/pipeline/text_table.hh"

namespace surfmesh {
namespace {

using detail::TextTable;

/// Of more patches nobody reads the rows.
constexpr std::size_t kMostPatches = 10;

constexpr double kBytesOfMegabyte = 1e6;

/// The faces of a mesh: "12 quads, 1 triangle".
std::string faces_text(const Report::Mesh& mesh) {
  if (mesh.quads == 0) return counted(mesh.triangles, "triangle", "triangles");
  const std::string quads = counted(mesh.quads, "quad", "quads");
  if (mesh.triangles == 0) return quads;
  return fmt::format("{}, {}", quads, counted(mesh.triangles, "triangle", "triangles"));
}

std::string irregular_text(const QuadStatistics& quads) {
  if (quads.count == 0) return "";
  return fmt::format("; {:.1f} % of the inner vertices irregular", 100 * quads.irregular_share);
}

void add_mesh(const Report& report, TextTable& table) {
  const Report::Mesh& mesh = report.mesh;
  table.add("mesh", fmt::format("{} vertices, {}, {}", mesh.vertices, faces_text(mesh),
                                counted(mesh.patches, "patch", "patches")));
  table.add("", fmt::format("{}, Euler characteristic {}{}", mesh.is_closed ? "closed" : "open",
                            mesh.euler, irregular_text(report.quads)));
}

/// The parts that are meshed by themselves; nothing where it is not known how patches are cut.
void add_tiles(const Report& report, TextTable& table) {
  const Report::Tiles& tiles = report.tiles;
  if (tiles.count == 0) return;
  std::string text = fmt::format("{} of {}", counted(tiles.count, "tile", "tiles"),
                                 counted(report.mesh.patches, "patch", "patches"));
  if (tiles.refused > 0) {
    text += fmt::format("; {} stay larger than asked, for no line cuts them well", tiles.refused);
  }
  table.add("tiles", text);
}

/// A number of elements, rounded to three digits: "5770", "12300000".
std::string rounded_count(double count) {
  const double digits = count < 1 ? 0 : std::floor(std::log10(count));
  const double unit = std::pow(10, std::max(0.0, digits - 2));
  return fmt::format("{:.0f}", std::round(count / unit) * unit);
}

/// How pieces and work are dealt out.
void add_pieces(const Report& report, TextTable& table) {
  if (!report.pieces) return;
  const Report::Pieces& pieces = *report.pieces;
  const std::size_t ranks = pieces.faces_of_ranks.size();
  table.add("pieces", fmt::format("{} on {}; {} in several pieces, {} on several ranks",
                                  pieces.count, counted(ranks, "rank", "ranks"),
                                  counted(pieces.of_several_pieces, "vertex", "vertices"),
                                  pieces.of_several_ranks));
  if (ranks < 2) return;
  const double faces =
      std::accumulate(pieces.faces_of_ranks.begin(), pieces.faces_of_ranks.end(), 0.0);
  table.add("",
            fmt::format("{} {} a rank on average, the largest share is {:.2f} of that; "
                        "{:.3g} MB sent in all",
                        rounded_count(faces / static_cast<double>(ranks)),
                        report.options.quads.is_on ? "quads" : "triangles", pieces.largest_share(),
                        static_cast<double>(pieces.bytes_sent) / kBytesOfMegabyte));
}

bool has_mostly_quads(const Report& report) { return report.quads.count > report.quality.count; }

/// Of the kind of faces that most are, beside the lengths of the edges.
void add_histograms(const Report& report, TextTable& table) {
  const TextStyle& style = table.style();
  table.add_blank();
  table.add_histograms(has_mostly_quads(report)
                           ? detail::jacobian_text(report.quads, style)
                           : detail::quality_text("quality of triangles", report.quality, style),
                       detail::length_text(report.edges, style));
}

void add_worst(std::string_view key, std::string_view what, double least,
               const std::optional<Report::WorstFace>& worst, TextTable& table) {
  if (!worst) return;
  table.add(key, fmt::format("{}{:.3f} in patch {} at {}", what, least, worst->patch,
                             point_text(worst->point)));
}

void add_places(const Report& report, TextTable& table) {
  const QualityStatistics& quality = report.quality;
  const QuadStatistics& quads = report.quads;
  if (quads.count == 0) return add_worst("worst", "", quality.min, report.worst, table);
  if (!has_mostly_quads(report)) {
    add_worst("worst", "triangle: ", quality.min, report.worst, table);
  }
  add_worst("worst", "quad: ", quads.min_jacobian, report.worst_quad, table);
  add_worst("", "in space: ", quads.min_space_jacobian, report.worst_quad_in_space, table);
  if (has_mostly_quads(report) && quality.count > 0) {
    add_worst("", "triangle: ", quality.min, report.worst, table);
  }
}

void add_lengths(const Report& report, TextTable& table) {
  const Report::Lengths& lengths = report.lengths;
  table.add("edges", fmt::format("{:.4g} to {:.4g} long, mean {:.4g}; the model's diagonal is "
                                 "{:.4g}",
                                 lengths.min, lengths.max, lengths.mean, report.diagonal));
}

/// Distances of less than this share of the diagonal are rounding.
constexpr double kRounding = 1e-9;

/// How a surface relates to the points of a mesh: "through 42 points", or how near it passes.
std::string nearness_text(const SurfaceFit& fit, double diagonal) {
  const std::string points = counted(fit.vertices, "point", "points");
  if (fit.fit > 0) {
    return fmt::format("within {:.3g} of {}, {:.3g} requested", fit.distance, points, fit.fit);
  }
  if (fit.distance > kRounding * diagonal) {
    return fmt::format("near {}, at up to {:.3g}", points, fit.distance);
  }
  return "through " + points;
}

/// A line for each cage whose surface passes through its points, or near to them.
void add_surfaces(const Report& report, TextTable& table) {
  const char* label = "surface";
  for (const SurfaceFit& fit : report.surfaces) {
    const std::string part = fit.part.empty() ? "" : fit.part + " ";
    table.add(label, fmt::format("{}{}; its cage moved by up to {:.3g}", part,
                                 nearness_text(fit, report.diagonal), fit.greatest_move));
    label = "";
  }
}

void add_sag(const Report::Sag& sag, TextTable& table) {
  if (!sag.asked || !sag.reached) return;
  table.add("sag",
            fmt::format("{:.4g}{}, {:.4g} asked for", *sag.reached,
                        *sag.reached > *sag.asked ? ", NOT REACHED" : " reached", *sag.asked));
}

void add_control(const Report::Control& control, TextTable& table) {
  table.add("control", fmt::format("{}, {} nodes, {} faces",
                                   to_text(ranges::kControl, static_cast<double>(control.kind)),
                                   control.nodes, control.faces));
}

void add_time(const Report& report, TextTable& table) {
  table.add("time", fmt::format("{:.2f} s of processor, {:.2f} s by the clock",
                                report.seconds.sum(), report.wall_seconds));
}

void add_speed(const Report& report, TextTable& table) {
  table.add("", fmt::format("{:.0f} {} a second, {:.0f} without control space and files",
                            report.triangles_per_second_in_all(),
                            report.mesh.quads > 0 ? "quads" : "triangles",
                            report.triangles_per_second()));
}

void add_stages(const Report& report, TextTable& table) {
  const double total = report.seconds.sum();
  std::vector<std::vector<std::string>> rows;
  for (const Stage stage : kStages) {
    const double seconds = report.seconds[stage];
    const std::size_t queries = report.control.queries[stage].total();
    rows.push_back({std::string(name(stage)), fmt::format("{:.3f}", seconds),
                    fmt::format("{:.1f} %", total > 0 ? 100 * seconds / total : 0.0),
                    queries > 0 ? fmt::format("{}", queries) : std::string("-")});
  }
  rows.push_back({"(serial)", fmt::format("{:.3f}", report.serial_seconds),
                  fmt::format("{:.1f} %", total > 0 ? 100 * report.serial_seconds / total : 0.0),
                  "-"});
  table.add_blank();
  table.add_rows({"stage", "seconds", "share", "questions for sizes"}, rows);
}

/// The least of quality and scaled Jacobian, above all others where neither was measured.
double least_of(const PatchMeasure& patch) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  return std::min(patch.least_quality.value_or(kNone), patch.least_jacobian.value_or(kNone));
}

std::string or_dash(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : std::string("-");
}

std::string groups_of(const PatchMeasure& patch) {
  std::string text;
  for (const std::string& group : patch.groups) {
    if (!text.empty()) text += ' ';
    text += group;
  }
  return text;
}

/// The patches of the least qualities.
void add_patches(const Report& report, TextTable& table) {
  std::vector<const PatchMeasure*> patches;
  for (const PatchMeasure& patch : report.patches) patches.push_back(&patch);
  std::stable_sort(
      patches.begin(), patches.end(),
      [](const PatchMeasure* a, const PatchMeasure* b) { return least_of(*a) < least_of(*b); });
  if (patches.size() > kMostPatches) patches.resize(kMostPatches);
  std::vector<std::vector<std::string>> rows;
  for (const PatchMeasure* patch : patches) {
    rows.push_back({patch->name, fmt::format("{}", patch->triangles),
                    fmt::format("{}", patch->quads), fmt::format("{:.4g}", patch->area),
                    or_dash(patch->least_quality), or_dash(patch->least_jacobian),
                    groups_of(*patch)});
  }
  table.add_blank();
  table.add_rows({fmt::format("worst of {}", counted(report.patches.size(), "patch", "patches")),
                  "triangles", "quads", "area", "quality", "Jacobian", "groups"},
                 rows);
}

void add_long_control(const Report::Control& control, TextTable& table) {
  table.add_blank();
  add_control(control, table);
  const PrecisionSample& sample = control.precision;
  if (sample.points > 0) {
    table.add("",
              fmt::format("precision {:.3g} asked for, greatest miss {:.3g}, over it {:.2f} % "
                          "of {} points",
                          sample.asked, sample.greatest, 100 * sample.share_over(), sample.points));
  }
  const Report::Classes& classes = control.classes;
  table.add("", fmt::format("faces by interpolation: {} s, {} t, {} o, {} linear", classes.single,
                            classes.triangle, classes.circles, classes.linear));
  const QueryCounts answers = control.queries.sum();
  table.add("", fmt::format("answers: {} s, {} t, {} o, {} linear, {} lattice, {} extended, {} "
                            "reused",
                            answers.single, answers.triangle, answers.circles, answers.linear,
                            answers.lattice, answers.extended, answers.reused));
}

void add_given(const std::vector<GivenOption>& given, TextTable& table) {
  table.add_blank();
  if (given.empty()) return table.add("options", "none given: all have their defaults");
  std::vector<std::vector<std::string>> rows;
  for (const GivenOption& option : given) {
    rows.push_back({option.name, option.value, std::string(name(option.origin))});
  }
  table.add_rows({"option", "value", "from"}, rows);
}

}  // namespace

std::string estimate_text(const Report& report, const TextStyle& style) {
  TextTable table(style);
  table.add_line("input", report.input);
  table.add("estimate", fmt::format("about {} {}, {}", rounded_count(report.estimated_elements),
                                    report.options.quads.is_on ? "quads" : "triangles",
                                    counted(report.mesh.patches, "patch", "patches")));
  if (report.options.sizing.sag) {
    table.add("", "the sag changes sizes where a first mesh shows it, and so the number");
  }
  add_tiles(report, table);
  add_pieces(report, table);
  if (!style.is_long) add_control(report.control, table);
  add_time(report, table);
  table.add("notices", detail::notices_text(report.notices));
  if (style.is_long) {
    add_long_control(report.control, table);
    add_given(report.given, table);
  }
  return table.take();
}

std::string to_text(const Report& report, const TextStyle& style) try {
  TextTable table(style);
  table.add_line("input", report.input);
  if (!report.output.empty()) table.add_line("output", report.output);
  add_mesh(report, table);
  add_histograms(report, table);
  add_places(report, table);
  add_lengths(report, table);
  add_surfaces(report, table);
  add_sag(report.sag, table);
  if (report.facets) detail::add_facets(*report.facets, table);
  if (style.is_long) add_tiles(report, table);
  add_pieces(report, table);
  if (!style.is_long) add_control(report.control, table);
  add_time(report, table);
  add_speed(report, table);
  table.add("notices", detail::notices_text(report.notices));
  if (style.is_long) {
    add_stages(report, table);
    add_patches(report, table);
    add_long_control(report.control, table);
    add_given(report.given, table);
  }
  return table.take();
} catch (const std::bad_alloc&) {
  fail_without_memory("while writing a report");
}

}  // namespace surfmesh
