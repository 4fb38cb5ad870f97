// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/spline_surface.hh"

#include <utility>

#include "surfmesh_cad/stateless_surface.hh"

namespace surfmesh {

std::shared_ptr<const Surface> spline_surface(const Handle(Geom_BSplineSurface) & surface,
                                              const Domain& domain, UnevenCells cells) {
  return stateless_surface(surface, domain, std::move(cells));
}

}  // namespace surfmesh
