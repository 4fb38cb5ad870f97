// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/counted_surfaces.hh"

#include <utility>
#include <vector>

namespace surfmesh::detail {

/// A surface that counts its evaluations.
class CountedModel::CountedSurface : public Surface {
 public:
  CountedSurface(std::shared_ptr<const Surface> surface, Count& count)
      : surface_(std::move(surface)), count_(count) {}

  Jet evaluate(Uv uv, Order order) const override {
    count_.evaluations.fetch_add(1, std::memory_order_relaxed);
    return surface_->evaluate(uv, order);
  }
  Domain domain() const override { return surface_->domain(); }
  std::vector<SingularPoint> singular_points() const override {
    return surface_->singular_points();
  }
  CellCount cells() const override { return surface_->cells(); }
  Uv from_cells(Uv point) const override { return surface_->from_cells(point); }
  Uv to_cells(Uv uv) const override { return surface_->to_cells(uv); }
  Uv beside_roundings(Uv uv) const override { return surface_->beside_roundings(uv); }

 private:
  std::shared_ptr<const Surface> surface_;
  Count& count_;
};

CountedModel::CountedModel(const Model& model)
    : model_(model), counts_(std::make_unique<Count[]>(model.patches.size())) {
  for (std::size_t p = 0; p < model_.patches.size(); ++p) {
    auto& surface = model_.patches[p].surface;
    surface = std::make_shared<CountedSurface>(surface, counts_[p]);
  }
}

std::size_t CountedModel::evaluations() const {
  std::size_t sum = 0;
  for (std::size_t p = 0; p < model_.patches.size(); ++p) sum += counts_[p].evaluations;
  return sum;
}

}  // namespace surfmesh::detail
