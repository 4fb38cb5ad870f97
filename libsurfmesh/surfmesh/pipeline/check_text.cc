// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/pipeline/check_mesh.hh"
#include "surfmesh/pipeline/facet_text.hh"
#include "surfmesh/pipeline/notice_text.hh"
#include "surfmesh/pipeline/text_table.hh"

namespace surfmesh {
namespace {

using detail::HistogramText;
using detail::TextTable;

constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

/// Places of a kind of fault in the short style.
constexpr std::size_t kFewPlaces = 3;

std::string faces_text(const FaceSetCheck& faces) {
  std::string text;
  const auto add = [&text](std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) text += fmt::format(", {}", counted(count, one, many));
  };
  add(faces.triangles, "triangle", "triangles");
  add(faces.quads, "quad", "quads");
  add(faces.polygons, "other face", "other faces");
  return text.empty() ? ", no faces" : text;
}

void add_faces(const FaceSetCheck& faces, TextTable& table) {
  table.add("mesh",
            fmt::format("{} vertices, {} edges{}", faces.vertices, faces.edges, faces_text(faces)));
  const std::string border = faces.is_closed
                                 ? "closed"
                                 : fmt::format("open: {} boundary edges in {} loops",
                                               faces.boundary_edges, faces.boundary_loops);
  table.add("", fmt::format("{}, {}, {}, {}, Euler characteristic {}", border,
                            faces.is_manifold ? "manifold" : "not manifold",
                            faces.is_oriented ? "oriented" : "not oriented",
                            counted(faces.components, "component", "components"), faces.euler));
  if (!faces.is_closed) table.add("", "the first open edge: " + faces.open_edges.places.front());
}

void add_extent(const MeshCheck& check, TextTable& table) {
  const MeshExtent& extent = check.extent;
  if (extent.box.isEmpty()) return;
  table.add("box", fmt::format("from {} to {}", point_text(extent.box.min()),
                               point_text(extent.box.max())));
  const std::string volume = !check.faces.has_volume()
                                 ? ""
                                 : fmt::format(", volume {:.6g}{}", extent.volume,
                                               extent.volume < 0 ? ": the faces face inwards" : "");
  table.add("area", fmt::format("{:.6g}{}", extent.area, volume));
}

/// The angles of all corners, in eighteen bins or in six.
HistogramText angle_text(const ShapeStatistics& shape, const TextStyle& style) {
  constexpr std::array kLimits = {0.0, 30.0, 60.0, 90.0, 120.0, 150.0};
  std::vector<double> limits(kLimits.begin(), kLimits.end());
  if (style.is_long) {
    limits.clear();
    for (const HistogramBin& bin : shape.angles) limits.push_back(bin.from);
  }
  HistogramText text{
      .heading = {"angles of corners (degrees)",
                  fmt::format("least {:.2f}, greatest {:.2f}", kDegreesPerRadian * shape.min_angle,
                              kDegreesPerRadian * shape.max_angle)},
      .rows = detail::rows_between(shape.angles, limits),
      .share = {},
      .total = 0};
  for (const HistogramBin& bin : shape.angles) text.total += bin.count;
  return text;
}

void add_shape_histograms(const ShapeStatistics& shape, TextTable& table) {
  const TextStyle& style = table.style();
  const HistogramText angles = angle_text(shape, style);
  table.add_blank();
  if (shape.quality.count == 0) return table.add_histograms(angles, {});
  table.add_histograms(detail::quality_text("shape of triangles in space", shape.quality, style),
                       angles);
}

std::string figures_text(const QualityStatistics& quality) {
  return fmt::format("mean {:.3f}, least {:.3f}, {:.2f} % below 0.3", quality.mean, quality.min,
                     100 * quality.below_0_3);
}

void add_shape(const ShapeStatistics& shape, TextTable& table) {
  table.add("angles", fmt::format("from {:.2f} (face {}) to {:.2f} degrees (face {})",
                                  kDegreesPerRadian * shape.min_angle, shape.min_angle_face,
                                  kDegreesPerRadian * shape.max_angle, shape.max_angle_face));
  table.add("lengths", fmt::format("from {:.4g} to {:.4g}, mean {:.4g}", shape.min_edge,
                                   shape.max_edge, shape.mean_edge));
  if (shape.quality.count > 0) table.add("shape", figures_text(shape.quality));
}

void add_metric(const MetricFit& fit, TextTable& table) {
  const TextStyle& style = table.style();
  const bool has_mostly_quads = fit.quads.count > fit.quality.count;
  table.add_blank();
  table.add_histograms(has_mostly_quads
                           ? detail::jacobian_text(fit.quads, style)
                           : detail::quality_text("quality of triangles", fit.quality, style),
                       detail::length_text(fit.edges, style));
  if (fit.quads.count == 0) return;
  if (fit.quality.count > 0) {
    if (has_mostly_quads) {
      table.add("triangles", figures_text(fit.quality));
    } else {
      table.add("quads", fmt::format("scaled Jacobian: mean {:.3f}, least {:.3f}",
                                     fit.quads.mean_jacobian, fit.quads.min_jacobian));
    }
  }
  table.add("in space", fmt::format("scaled Jacobian of quads: mean {:.3f}, least {:.3f}",
                                    fit.quads.mean_space_jacobian, fit.quads.min_space_jacobian));
}

/// What the sizes are that judge a mesh.
void add_judge(const MeshCheck& check, TextTable& table) {
  if (!check.fit || check.fit->is_by_stored_metric) {
    return table.add("metric", "that of the mesh, which it was made by");
  }
  const ModelFit& fit = *check.fit;
  if (fit.is_by_exact_sizes) {
    table.add("metric", "the exact sizes of the model");
    if (fit.has_other_sizes) {
      table.add("",
                "without grade, corrections of the sag and interpolation of `at`, which make a "
                "mesh finer by right");
    }
    return;
  }
  table.add("metric", "the mesh has none: that of a run on the model, with these options");
  if (fit.has_other_sizes) {
    table.add("", "without corrections of the sag, which make a mesh finer by right");
  }
}

/// In the metric that judges the mesh, or in space where there is none.
void add_histograms(const MeshCheck& check, TextTable& table) {
  const MetricFit* fit = check.fit ? &check.fit->sizes : check.stored ? &*check.stored : nullptr;
  if (check.shape.angles.empty()) return;
  if (!fit || table.style().is_long) add_shape_histograms(check.shape, table);
  if (!fit) return;
  add_metric(*fit, table);
  add_judge(check, table);
}

void add_fit(const ModelFit& fit, TextTable& table) {
  table.add("model", fit.is_projected ? "the mesh has no (u,v), nearest points were taken"
                                      : "by the (u,v) of the mesh");
  if (fit.is_projected) {
    table.add("", fmt::format("corners are up to {:.3g} from the surface, which without (u,v) is "
                              "no fault",
                              fit.distance.max_corner));
  }
  if (fit.corners_beyond > 0) {
    table.add("", fmt::format("corners beyond the patch of their face, where its (u,v) go on: {}",
                              fit.corners_beyond));
  }
  if (fit.distance.unjudged > 0) {
    table.add("", fmt::format("faces that look turned, but whose side the points found at their "
                              "corners do not tell: {}",
                              fit.distance.unjudged));
  }
  table.add("distance", fmt::format("greatest {:.3g} in face {}{} at {}, mean {:.3g}",
                                    fit.distance.max, fit.distance.max_face,
                                    fit.max_contour.empty() ? "" : " on contour " + fit.max_contour,
                                    point_text(fit.distance.max_at), fit.distance.mean));
  if (fit.from_surface) {
    table.add("", fmt::format("of the surface from the mesh: {}",
                              detail::distance_text(*fit.from_surface)));
  }
  if (fit.facets) detail::add_facets(*fit.facets, table);
  if (fit.sag) {
    table.add("sag", fmt::format("{:.4g} asked for, {}", *fit.sag,
                                 fit.distance.max > *fit.sag ? "NOT REACHED" : "kept"));
  }
}

void add_faults(const MeshCheck& check, TextTable& table) {
  if (check.faults.empty()) table.add("faults", "none");
  for (const MeshFault& fault : check.faults) {
    table.add("fault", fmt::format("{}: {}", fault.kind, fault.count));
    const std::size_t shown =
        table.style().is_long ? fault.places.size() : std::min(kFewPlaces, fault.places.size());
    for (std::size_t i = 0; i < shown; ++i) table.add_line("", "  " + fault.places[i]);
    if (fault.count > shown) table.add("", fmt::format("  and {} more", fault.count - shown));
  }
  const MeshFault& crossing = check.self_intersections;
  if (crossing.count == 0) return table.add("", "no faces pass through each other");
  table.add("warning", fmt::format("pairs of faces that pass through each other: {}, the first:",
                                   crossing.count));
  table.add_line("", "  " + crossing.places.front());
}

}  // namespace

std::string to_text(const MeshCheck& check, const TextStyle& style) try {
  TextTable table(style);
  add_faces(check.faces, table);
  add_extent(check, table);
  add_shape(check.shape, table);
  add_histograms(check, table);
  if (check.fit) add_fit(*check.fit, table);
  add_faults(check, table);
  if (!check.notices.empty()) table.add("notices", detail::notices_text(check.notices));
  return table.take();
} catch (const std::bad_alloc&) {
  fail_without_memory("while writing a report");
}

}  // namespace surfmesh
