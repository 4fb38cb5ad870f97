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

ToldFace told(const PolyMesh& mesh, FaceHandle fh) {
  return {mesh.property(require(mesh, keys::face_patch), fh),
          to_eigen(mesh.calc_face_centroid(fh))};
}

std::optional<ToldFace> told(const PolyMesh& mesh, int face) {
  if (face < 0) return {};
  return told(mesh, FaceHandle(face));
}

bool has_flat_triangles(const Report& report) {
  return report.quality.count > 0 && report.quality.min < kFlatQuality;
}

bool has_left_triangles(const Report& report) {
  return report.options.quads.is_on && report.mesh.triangles > 0;
}

/// A notice of a face, with its place behind the text: "{text} in patch wing at (1, 2, 3)".
Notice located(Notice notice, const Model& model, const ToldFace& face) {
  notice.patch = face.patch;
  notice.point = face.middle;
  notice.text += fmt::format(" in patch {}", model.patch(face.patch).name);
  if (face.middle) notice.text += " at " + point_text(*face.middle);
  return notice;
}

Notice of_flat_triangles(const Model& model, const QualityStatistics& quality,
                         const ToldFace& face) {
  Notice notice =
      located(warning(NoticeKind::FlatTriangles,
                      fmt::format("triangles are as flat as quality {:.3g},", quality.min)),
              model, face);
  if (face.is_at_contour) {
    notice.text +=
        ": the boundary leaves less room than the sizes ask for; gaps get their sizes by "
        "proximity, not below hmin";
  }
  return notice;
}

Notice of_flat_quads(const Model& model, const QuadStatistics& quads, const ToldFace& face) {
  return located(
      warning(NoticeKind::FlatQuads,
              fmt::format("{} a scaled Jacobian below {} in the metric, the least is {:.3g},",
                          counted(quads.flat, "quad has", "quads have"), kFlatQuad,
                          quads.min_jacobian)),
      model, face);
}

/// No advice: where blocks are one or two quads wide, smaller sizes mend some and spoil others.
Notice of_inverted_quads(const Model& model, const QuadStatistics& quads, const ToldFaces& faces) {
  const bool is_in_domain = quads.inverted > 0;
  return located(shortfall(NoticeKind::InvertedQuads,
                           fmt::format("{} a corner of more than 180° in {}, the worst",
                                       counted(is_in_domain ? quads.inverted : quads.folded,
                                               "quad has", "quads have"),
                                       is_in_domain ? "the parameters" : "space")),
                 model, is_in_domain ? *faces.worst_quad : *faces.worst_quad_in_space);
}

/// A patch whose loops have an odd number of segments keeps one.
Notice of_left_triangles(const Model& model, std::size_t count, const ToldFace& face) {
  Notice notice = located(shortfall(NoticeKind::LeftTriangles,
                                    fmt::format("{} left among the quads, one",
                                                counted(count, "triangle is", "triangles are"))),
                          model, face);
  notice.text +=
      ": the contours around the patch have an odd number of segments, and none could take one "
      "more or fewer";
  return notice;
}

}  // namespace

ToldFaces told_faces(const PolyMesh& mesh, const Report& report) {
  ToldFaces faces{.worst = told(mesh, report.quality.worst_face),
                  .worst_quad = told(mesh, report.quads.worst_face),
                  .worst_quad_in_space = told(mesh, report.quads.worst_face_in_space),
                  .triangle = {}};
  if (faces.worst && has_flat_triangles(report)) {
    faces.worst->is_at_contour = is_at_contour(mesh, FaceHandle(report.quality.worst_face));
  }
  if (has_left_triangles(report)) {
    const auto all = mesh.faces();
    faces.triangle = told(mesh, *std::find_if(all.begin(), all.end(), [&](FaceHandle fh) {
                            return mesh.valence(fh) == 3;
                          }));
  }
  return faces;
}

Notices notices_of_faces(const Model& model, const Report& report, const ToldFaces& faces) {
  const QuadStatistics& quads = report.quads;
  Notices notices;
  if (faces.worst && has_flat_triangles(report)) {
    notices.push_back(of_flat_triangles(model, report.quality, *faces.worst));
  }
  if (quads.inverted > 0 || quads.folded > 0) {
    notices.push_back(of_inverted_quads(model, quads, faces));
  }
  if (quads.flat > 0) notices.push_back(of_flat_quads(model, quads, *faces.worst_quad));
  if (faces.triangle && has_left_triangles(report)) {
    notices.push_back(of_left_triangles(model, report.mesh.triangles, *faces.triangle));
  }
  return notices;
}

}  // namespace surfmesh::detail
