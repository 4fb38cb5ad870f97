// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/face_notices.hh"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {
namespace {

/// A triangle of less quality is told: it is of no use, and the user can mend it.
constexpr double kFlatQuality = 0.1;

/// True if a corner of a face is on a contour.
bool is_at_contour(const PolyMesh& mesh, FaceHandle fh) {
  const auto contour_of = require(mesh, keys::edge_contour);
  for (const VertexHandle vh : mesh.fv_range(fh)) {
    for (const EdgeHandle eh : mesh.ve_range(vh)) {
      if (mesh.property(contour_of, eh) >= 0) return true;
    }
  }
  return false;
}

/// A notice of a face, with its place behind the text: "{text} in patch wing at (1, 2, 3)".
Notice located(Notice notice, const PolyMesh& mesh, const Model& model, FaceHandle fh) {
  notice.patch = mesh.property(require(mesh, keys::face_patch), fh);
  notice.point = to_eigen(mesh.calc_face_centroid(fh));
  notice.text +=
      fmt::format(" in patch {} at {}", model.patch(notice.patch).name, point_text(*notice.point));
  return notice;
}

Notice of_flat_triangles(const PolyMesh& mesh, const Model& model,
                         const QualityStatistics& quality) {
  const FaceHandle fh(quality.worst_face);
  Notice notice =
      located(warning(NoticeKind::FlatTriangles,
                      fmt::format("triangles are as flat as quality {:.3g},", quality.min)),
              mesh, model, fh);
  if (is_at_contour(mesh, fh)) {
    notice.text +=
        ": the boundary leaves less room than the sizes ask for; gaps get their sizes by "
        "proximity, not below hmin";
  }
  return notice;
}

Notice of_flat_quads(const PolyMesh& mesh, const Model& model, const QuadStatistics& quads) {
  return located(
      warning(NoticeKind::FlatQuads,
              fmt::format("{} a scaled Jacobian below {} in the metric, the least is {:.3g},",
                          counted(quads.flat, "quad has", "quads have"), kFlatQuad,
                          quads.min_jacobian)),
      mesh, model, FaceHandle(quads.worst_face));
}

/// No advice: where blocks are one or two quads wide, smaller sizes mend some and spoil others.
Notice of_inverted_quads(const PolyMesh& mesh, const Model& model, const QuadStatistics& quads) {
  const bool is_in_domain = quads.inverted > 0;
  return located(
      shortfall(NoticeKind::InvertedQuads,
                fmt::format(
                    "{} a corner of more than 180° in {}, the worst",
                    counted(is_in_domain ? quads.inverted : quads.folded, "quad has", "quads have"),
                    is_in_domain ? "the parameters" : "space")),
      mesh, model, FaceHandle(is_in_domain ? quads.worst_face : quads.worst_face_in_space));
}

/// A patch whose loops have an odd number of segments keeps one.
Notice of_left_triangles(const PolyMesh& mesh, const Model& model, std::size_t count) {
  const auto faces = mesh.faces();
  const auto first = std::find_if(faces.begin(), faces.end(),
                                  [&](FaceHandle fh) { return mesh.valence(fh) == 3; });
  Notice notice = located(shortfall(NoticeKind::LeftTriangles,
                                    fmt::format("{} left among the quads, one",
                                                counted(count, "triangle is", "triangles are"))),
                          mesh, model, *first);
  notice.text +=
      ": the contours around the patch have an odd number of segments, and none could take one "
      "more or fewer";
  return notice;
}

}  // namespace

Notices notices_of_faces(const PolyMesh& mesh, const Model& model, const Report& report) {
  const QuadStatistics& quads = report.quads;
  Notices notices;
  if (report.quality.worst_face >= 0 && report.quality.min < kFlatQuality) {
    notices.push_back(of_flat_triangles(mesh, model, report.quality));
  }
  if (quads.inverted > 0 || quads.folded > 0) {
    notices.push_back(of_inverted_quads(mesh, model, quads));
  }
  if (quads.flat > 0) notices.push_back(of_flat_quads(mesh, model, quads));
  if (report.options.quads.is_on && report.mesh.triangles > 0) {
    notices.push_back(of_left_triangles(mesh, model, report.mesh.triangles));
  }
  return notices;
}

}  // namespace surfmesh::detail
