// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "surfmesh/core/notice.hh"
#include "surfmesh/io/json.hh"

namespace surfmesh::detail {

/// Notices as reports have them. `patch_name` gives the name of a patch, empty for one that is not
/// known; what a notice does not tell is null.
inline Json notices_json(const Notices& notices,
                         const std::function<std::string(int)>& patch_name) {
  Json list = Json::array();
  for (const Notice& notice : notices) {
    const std::string patch = notice.patch >= 0 ? patch_name(notice.patch) : std::string();
    Json json = {{"kind", name(notice.kind)},
                 {"severity", name(notice.severity)},
                 {"text", notice.text},
                 {"patch", patch.empty() ? Json(nullptr) : Json(patch)},
                 {"contour", notice.contour >= 0 ? Json(notice.contour) : Json(nullptr)},
                 {"point", nullptr},
                 {"count", notice.count}};
    if (notice.point) json["point"] = {notice.point->x(), notice.point->y(), notice.point->z()};
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace surfmesh::detail
