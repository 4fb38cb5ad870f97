// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/sharp_contours.hh"

#include <cstddef>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/geometry/curve_polyline.hh"

namespace surfmesh {

std::vector<SharpContour> sharp_contours(const Model& model, double tolerance,
                                         const RunContext& context) {
  std::vector<SharpContour> result;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const Contour& contour = model.contours[c];
    if (contour.is_smooth || contour.is_degenerate) continue;
    result.push_back({static_cast<int>(c), contour.uses.size() == 1, {}});
  }
  share_indices(result.size(), [&](std::size_t i) {
    context.throw_if_cancelled();
    const Contour& contour = model.contour(result[i].contour);
    const ContourUse& use = contour.uses.front();
    const CurveOnSurface curve(model.patch(use).surface, use.curve, contour.breaks);
    for (const CurvePoint& point : curve_polyline(curve, tolerance)) {
      result[i].points.push_back(point.point);
    }
  });
  return result;
}

}  // namespace surfmesh
