// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/tile_notices.hh"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "surfmesh/pipeline/patch_names.hh"

namespace surfmesh::detail {
namespace {

std::string turned_text(const std::string& patch, const TurnedPlace& place) {
  const std::string where = fmt::format(", one in patch {} at {}", patch, point_text(place.point));
  if (!place.is_of_surface) return where + "; smaller sizes help (curvature, hmin, hmax)";
  return where + fmt::format(
                     ", near (u,v) = ({:.6g}, {:.6g}), where the surface turns over, has "
                     "no tangent plane, or bends by a right angle within a triangle: "
                     "smaller sizes help, or to divide the patch there",
                     place.uv.u, place.uv.v);
}

}  // namespace

Notices notices_of_given_up(const Model& model, const std::vector<char>& is_given_up,
                            ElementKind kind) {
  Notices notices;
  auto notice = shortfall_of_patches(
      NoticeKind::GivenUp, model, is_given_up,
      fmt::format("given up at three times the {} that the sizes ask for: they change direction "
                  "faster than elements can follow; smaller stretch or a lower grade helps",
                  name(kind)));
  if (notice) notices.push_back(std::move(*notice));
  return notices;
}

Notices notices_of_turned(const Model& model, const std::vector<TurnedTile>& tiles) {
  std::size_t count = 0;
  const TurnedPlace* place = nullptr;
  Notice notice = shortfall(NoticeKind::TurnedTriangles, {});
  for (const TurnedTile& tile : tiles) {
    count += tile.turned.count;
    if (!tile.turned.place ||
        (place && (place->is_of_surface || !tile.turned.place->is_of_surface))) {
      continue;
    }
    place = &*tile.turned.place;
    notice.patch = tile.patch;
  }
  if (count == 0) return {};
  if (place) notice.point = place->point;
  notice.text = fmt::format("{} triangles are turned against the normal of the surface{}", count,
                            place ? turned_text(model.patch(notice.patch).name, *place)
                                  : "; smaller sizes help (curvature, hmin, hmax)");
  Notices notices;
  notices.push_back(std::move(notice));
  return notices;
}

}  // namespace surfmesh::detail
