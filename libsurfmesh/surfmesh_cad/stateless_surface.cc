// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/stateless_surface.hh"

#include <Standard_Failure.hxx>
#include <utility>

#include "surfmesh_cad/file_points.hh"

namespace surfmesh {
namespace {

class StatelessSurface : public Surface {
 public:
  StatelessSurface(Handle(Geom_Surface) surface, const Domain& domain, UnevenCells cells)
      : surface_(std::move(surface)), domain_(domain), cells_(std::move(cells)) {}

  Jet evaluate(Uv uv, Order order) const override {
    try {
      return finite(file_jet(*surface_, uv, order), uv, order);
    } catch (const Standard_Failure&) {
      fail_evaluation(uv);
    }
  }

  Domain domain() const override { return domain_; }
  CellCount cells() const override { return cells_.count(); }
  Uv from_cells(Uv point) const override { return cells_.from_cells(point); }
  Uv to_cells(Uv uv) const override { return cells_.to_cells(uv); }

 private:
  Handle(Geom_Surface) surface_;
  Domain domain_;
  UnevenCells cells_;
};

}  // namespace

std::shared_ptr<const Surface> stateless_surface(const Handle(Geom_Surface) & surface,
                                                 const Domain& domain, UnevenCells cells) {
  return std::make_shared<StatelessSurface>(surface, domain, std::move(cells));
}

}  // namespace surfmesh
