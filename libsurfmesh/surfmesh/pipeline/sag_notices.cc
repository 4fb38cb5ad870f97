// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/sag_notices.hh"

#include <fmt/format.h>

#include <algorithm>

#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh::detail {

Notices notices_of_raised_sag(const Model& model, const Sizing& sizing) {
  const double asked = sizing.sag ? sizing.sag->in_units(model.diagonal) : 0;
  const double least = least_sag(model);
  if (asked == 0 || asked >= least) return {};
  const auto worst = std::max_element(
      model.contours.begin(), model.contours.end(),
      [](const Contour& a, const Contour& b) { return a.tolerance < b.tolerance; });
  Notices notices;
  notices.push_back(shortfall(
      NoticeKind::LooseFit,
      fmt::format(
          "sag = {:.6g} is less than the surfaces of the model allow, which are apart where "
          "they meet, most at contour {}; {:.6g} is kept in its place",
          asked, worst == model.contours.end() ? "" : worst->name, least)));
  return notices;
}

}  // namespace surfmesh::detail
