// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/model_fit.hh"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "surfmesh/model/finish_model.hh"

namespace surfmesh {
namespace {

/// Gaps below this share of the diagonal are none.
constexpr double kLeastGap = 1e-7;

/// A tolerance is greater than the gap that was measured at some points only.
constexpr double kSlack = 1.1;

/// A gap above this share of the diagonal is told.
constexpr double kToldGap = 1e-5;

/// The ends of contours at each vertex, on the surfaces.
std::vector<std::vector<Vec3>> ends_by_vertex(const Model& model) {
  std::vector<std::vector<Vec3>> ends(model.vertices.size());
  for (const Contour& contour : model.contours) {
    for (const ContourUse& use : contour.uses) {
      ends[static_cast<std::size_t>(contour.start)].push_back(model.point(use, 0));
      ends[static_cast<std::size_t>(contour.end)].push_back(model.point(use, 1));
    }
  }
  return ends;
}

double farthest(const Vec3& from, const std::vector<Vec3>& points) {
  double distance = 0;
  for (const Vec3& point : points) distance = std::max(distance, (point - from).norm());
  return distance;
}

double tolerance_for(double gap, double diagonal) {
  return gap > kLeastGap * diagonal ? kSlack * gap : 0;
}

void tell_gap(Model& model, int contour, double gap) {
  const Contour& loosest = model.contour(contour);
  const Vec3 place = model.point(loosest.uses.front(), 0.5);
  Notice notice = warning(
      NoticeKind::LooseFit,
      fmt::format("the faces at {} near {} are {:.3g} apart in the file, {:.2g} of the diagonal: "
                  "corners there lie off their surfaces by as much",
                  loosest.name, point_text(place), gap, gap / model.diagonal));
  notice.contour = contour;
  notice.point = place;
  append({notice}, model.notices);
}

}  // namespace

void centre_vertices(Model& model) {
  const std::vector<std::vector<Vec3>> ends = ends_by_vertex(model);
  for (std::size_t v = 0; v < ends.size(); ++v) {
    if (ends[v].empty()) continue;
    Vec3 mean = Vec3::Zero();
    for (const Vec3& end : ends[v]) mean += end / static_cast<double>(ends[v].size());
    Vec3& position = model.vertices[v].position;
    if (!(farthest(position, ends[v]) <= farthest(mean, ends[v]))) position = mean;
  }
}

void set_tolerances(Model& model) {
  double greatest = 0;
  int loosest = -1;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    Contour& contour = model.contours[c];
    const double gap = gap_of(model, contour);
    contour.tolerance = tolerance_for(gap, model.diagonal);
    if (gap > greatest) {
      greatest = gap;
      loosest = static_cast<int>(c);
    }
  }
  const std::vector<std::vector<Vec3>> ends = ends_by_vertex(model);
  for (std::size_t v = 0; v < ends.size(); ++v) {
    ModelVertex& vertex = model.vertices[v];
    vertex.tolerance = tolerance_for(farthest(vertex.position, ends[v]), model.diagonal);
  }
  if (greatest > kToldGap * model.diagonal) tell_gap(model, loosest, greatest);
}

}  // namespace surfmesh
