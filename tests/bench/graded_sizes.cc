// SPDX-License-Identifier: BSD-3-Clause
#include "bench/graded_sizes.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "bench/contour_stations.hh"
#include "bench/size_graph.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh::judge {
namespace {

/// The sizes of one patch at its nodes, before gradation.
std::vector<SizedPoint> sample_patch(const SizeField& field, const PatchGrid& grid) {
  std::vector<SizedPoint> points(grid.node_count());
  share_indices(static_cast<std::size_t>(grid.rows()), [&](std::size_t row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const int j = static_cast<int>(row);
      points[grid.node(column, j)] = sized_point(field, grid.at(column, j));
    }
  });
  return points;
}

class GraphOfModel {
 public:
  GraphOfModel(const Model& model, const SizeFields& fields, const std::vector<PatchGrid>& grids)
      : model_(model), fields_(fields), grids_(grids) {}

  void build() {
    for (std::size_t p = 0; p < grids_.size(); ++p) {
      first_.push_back(graph_.add_grid(grids_[p].columns(), grids_[p].rows(),
                                       sample_patch(*fields_[p], grids_[p])));
    }
    for (std::size_t p = 0; p < grids_.size(); ++p) add_required(p);
    add_contours();
  }

  SizeGraph& graph() { return graph_; }
  std::size_t first(std::size_t patch) const { return first_[patch]; }

 private:
  void add_required(std::size_t patch) {
    for (const Uv uv : fields_[patch]->required_points()) {
      add(patch, uv, sized_point(*fields_[patch], uv));
    }
  }

  void add_contours() {
    std::vector<std::vector<Station>> stations(model_.contours.size());
    share_indices(stations.size(), [&](std::size_t c) {
      stations[c] = make_stations(model_, model_.contours[c], fields_, grids_);
    });
    for (std::size_t c = 0; c < stations.size(); ++c) {
      for (const Station& station : stations[c]) add_station(model_.contours[c], station);
    }
  }

  void add_station(const Contour& contour, const Station& station) {
    std::vector<ContourSide> sides;
    for (std::size_t use = 0; use < station.size(); ++use) {
      const StationSide& side = station[use];
      const auto patch = static_cast<std::size_t>(contour.uses[use].patch);
      sides.push_back(
          {add(patch, side.uv, side.point), side.cos, side.sin, contour.uses[use].is_forward});
      for (std::size_t other = 0; other < use; ++other) {
        graph_.link_across(sides[other], sides[use]);
      }
    }
  }

  /// Add a point that is no node, and link it to the nodes of its cell and one step around.
  std::size_t add(std::size_t patch, Uv uv, const SizedPoint& point) {
    const std::size_t index = graph_.add_point(point);
    const PatchGrid& grid = grids_[patch];
    const Uv at = grid.in_steps(grid.domain.clamp(uv));
    const int column = std::min(static_cast<int>(at.u), grid.u_steps - 1);
    const int row = std::min(static_cast<int>(at.v), grid.v_steps - 1);
    for (int j = std::max(row - 1, 0); j <= std::min(row + 2, grid.v_steps); ++j) {
      for (int i = std::max(column - 1, 0); i <= std::min(column + 2, grid.u_steps); ++i) {
        graph_.link(index, first_[patch] + grid.node(i, j));
      }
    }
    return index;
  }

  const Model& model_;
  const SizeFields& fields_;
  const std::vector<PatchGrid>& grids_;
  SizeGraph graph_;
  std::vector<std::size_t> first_;  ///< node of each patch
};

SizeTensor weighted(const std::vector<SizeTensor>& sizes, const PatchGrid::Corners& corners) {
  SizeTensor sum{0, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    const SizeTensor& h = sizes[corners.nodes[i]];
    const double weight = corners.weights[i];
    sum = {sum.h11 + weight * h.h11, sum.h12 + weight * h.h12, sum.h22 + weight * h.h22};
  }
  return sum;
}

}  // namespace

GradedSizes::GradedSizes(const Model& model, const SizeFields& fields, double grade,
                         std::vector<PatchGrid> grids)
    : fields_(&fields), grids_(std::move(grids)), sizes_(grids_.size()) {
  GraphOfModel builder(model, fields, grids_);
  builder.build();
  builder.graph().grade(grade);
  for (std::size_t p = 0; p < grids_.size(); ++p) {
    for (std::size_t i = 0; i < grids_[p].node_count(); ++i) {
      sizes_[p].push_back(builder.graph().size(builder.first(p) + i));
    }
  }
}

SizeTensor GradedSizes::at(int patch, Uv uv) const {
  const auto p = static_cast<std::size_t>(patch);
  const SizeTensor graded = weighted(sizes_[p], grids_[p].corners_at(uv));
  return minimum(graded, sized_point(*(*fields_)[p], uv).size);
}

double GradedSizes::density(int patch, Uv uv) const {
  const FirstFormFactor form = form_at((*fields_)[static_cast<std::size_t>(patch)]->surface(), uv);
  return form.l11 * form.l22 / determinant(at(patch, uv));
}

/// By Gauss's rule with two points in each direction of each cell of the grid. Beyond the diagonal
/// of a triangular domain the sizes are mirrored, so that the rectangle has twice its area.
double GradedSizes::metric_area(int patch) const {
  const PatchGrid& g = grid(patch);
  const double offset = 0.5 / std::sqrt(3.0);
  const std::array<double, 2> places = {0.5 - offset, 0.5 + offset};
  std::vector<double> rows(static_cast<std::size_t>(g.v_steps), 0);
  share_indices(rows.size(), [&](std::size_t row) {
    for (int i = 0; i < g.u_steps; ++i) {
      for (const double t : places) {
        for (const double s : places) {
          const double v = (static_cast<double>(row) + t) / g.v_steps;
          rows[row] += density(patch, g.domain.at((i + s) / g.u_steps, v));
        }
      }
    }
  });
  const double sum = std::accumulate(rows.begin(), rows.end(), 0.0);
  const Domain& d = g.domain;
  const double cell = (d.u1 - d.u0) / g.u_steps * (d.v1 - d.v0) / g.v_steps;
  return 0.25 * cell * sum * (d.shape == Domain::Shape::Triangle ? 0.5 : 1);
}

std::size_t node_count(const std::vector<PatchGrid>& grids) {
  std::size_t count = 0;
  for (const PatchGrid& grid : grids) count += grid.node_count();
  return count;
}

}  // namespace surfmesh::judge
