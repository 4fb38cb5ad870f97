// SPDX-License-Identifier: BSD-3-Clause
#include "tabulated_field.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "functions.hh"

namespace surfmesh::python {
namespace {

/// Steps along each direction of the first grid.
constexpr std::size_t kFirstSteps = 16;

/// A part of the table, in steps: whole steps and the rest.
struct Place {
  std::size_t step;
  double rest;
};

/// Values on a grid, interpolated linearly along u and v.
class ValueTable {
 public:
  ValueTable(const Domain& domain, std::size_t columns, std::size_t rows, std::size_t width,
             std::vector<double> values)
      : domain_(domain),
        columns_(columns),
        rows_(rows),
        width_(width),
        values_(std::move(values)) {}

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }

  double at(std::size_t column, std::size_t row, std::size_t i) const {
    return values_[(row * columns_ + column) * width_ + i];
  }

  double value(Uv uv, std::size_t i) const {
    const Place u = place_u(uv.u), v = place_v(uv.v);
    const double below = std::lerp(at(u.step, v.step, i), at(u.step + 1, v.step, i), u.rest);
    const double above =
        std::lerp(at(u.step, v.step + 1, i), at(u.step + 1, v.step + 1, i), u.rest);
    return std::lerp(below, above, v.rest);
  }

  /// The least and the greatest value in a box: those of entries around it are bounds.
  Interval bounds(const UvBox& box, std::size_t i) const {
    const std::size_t last_u = place_u(box.u.upper).step + 1;
    const std::size_t last_v = place_v(box.v.upper).step + 1;
    Interval result{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    for (std::size_t row = place_v(box.v.lower).step; row <= last_v; ++row) {
      for (std::size_t column = place_u(box.u.lower).step; column <= last_u; ++column) {
        result = hull(result, Interval::of(at(column, row, i)));
      }
    }
    return result;
  }

 private:
  Place place_u(double u) const { return place(u, domain_.u0, domain_.u1, columns_ - 1); }
  Place place_v(double v) const { return place(v, domain_.v0, domain_.v1, rows_ - 1); }

  static Place place(double x, double from, double to, std::size_t steps) {
    const double count = static_cast<double>(steps);
    const double all = std::clamp((x - from) / (to - from), 0., 1.) * count;
    const double step = std::min(std::floor(all), count - 1);
    return {static_cast<std::size_t>(step), all - step};
  }

  Domain domain_;
  std::size_t columns_;
  std::size_t rows_;
  std::size_t width_;
  std::vector<double> values_;  ///< row by row, `width` for each entry
};

/// Greatest ratio, less 1, of the sizes that two metrics ask for.
double relative_difference(const double* a, const double* b) {
  // Eigenvalues of A⁻¹B; sizes are the square roots of their inverses.
  const double det_a = a[0] * a[2] - a[1] * a[1], det_b = b[0] * b[2] - b[1] * b[1];
  const double half_trace = (a[2] * b[0] - 2 * a[1] * b[1] + a[0] * b[2]) / (2 * det_a);
  const double root = std::sqrt(std::max(half_trace * half_trace - det_b / det_a, 0.));
  const double greatest = half_trace + root, least = det_b / det_a / greatest;
  return std::sqrt(std::max(greatest, 1 / least)) - 1;
}

class Tabulation {
 public:
  Tabulation(const FieldFunction& function, const Surface& surface, const TableOptions& options)
      : function_(function),
        surface_(surface),
        options_(options),
        width_(function.is_metric ? 3 : 1) {}

  TabulatedField run() {
    sample(kFirstSteps + 1, kFirstSteps + 1);
    while (true) {
      const double along_u = error(0.5, 0), along_v = error(0, 0.5), both = error(0.5, 0.5);
      const double greatest = std::max({along_u, along_v, both});
      const bool is_both = (along_u > options_.precision) == (along_v > options_.precision);
      const std::size_t columns =
          is_both || along_u > along_v ? 2 * table_->columns() - 1 : table_->columns();
      const std::size_t rows =
          is_both || along_v > along_u ? 2 * table_->rows() - 1 : table_->rows();
      if (greatest <= options_.precision || columns * rows > options_.max_samples) {
        return finished(greatest);
      }
      sample(columns, rows);
    }
  }

 private:
  std::vector<Uv> places(std::size_t columns, std::size_t rows, double shift_u,
                         double shift_v) const {
    const Domain domain = surface_.domain();
    std::vector<Uv> uvs;
    for (std::size_t j = 0; j < rows - (shift_v > 0 ? 1 : 0); ++j) {
      for (std::size_t i = 0; i < columns - (shift_u > 0 ? 1 : 0); ++i) {
        uvs.push_back(
            domain.at((static_cast<double>(i) + shift_u) / static_cast<double>(columns - 1),
                      (static_cast<double>(j) + shift_v) / static_cast<double>(rows - 1)));
      }
    }
    return uvs;
  }

  std::vector<double> values(const std::vector<Uv>& uvs) const {
    return values_of(function_.function, uvs, function_.is_in_space ? &surface_ : nullptr, width_);
  }

  void sample(std::size_t columns, std::size_t rows) {
    table_ = std::make_shared<const ValueTable>(surface_.domain(), columns, rows, width_,
                                                values(places(columns, rows, 0, 0)));
  }

  /// Greatest relative error of sizes in the middle of steps.
  double error(double shift_u, double shift_v) const {
    const auto uvs = places(table_->columns(), table_->rows(), shift_u, shift_v);
    const std::vector<double> exact = values(uvs);
    double greatest = 0;
    for (std::size_t i = 0; i < uvs.size(); ++i) {
      std::array<double, 3> interpolated{};
      for (std::size_t k = 0; k < width_; ++k) interpolated[k] = table_->value(uvs[i], k);
      const double* const value = exact.data() + i * width_;
      const double error = width_ == 1 ? std::abs(interpolated[0] / value[0] - 1)
                                       : relative_difference(interpolated.data(), value);
      greatest = std::max(greatest, error);
    }
    return greatest;
  }

  TabulatedField finished(double error) const {
    TabulatedField result;
    result.error = error;
    result.samples = table_->columns() * table_->rows();
    result.source.uses_position = false;
    if (function_.is_metric) {
      result.source.metric = [table = table_](Uv uv, const Vec3&) {
        return Metric{table->value(uv, 0), table->value(uv, 1), table->value(uv, 2)};
      };
      result.source.metric_bounds = [table = table_](const UvBox& box, const Eigen::AlignedBox3d&) {
        return MetricBounds{table->bounds(box, 0), table->bounds(box, 1), table->bounds(box, 2)};
      };
    } else {
      result.source.size = [table = table_](Uv uv, const Vec3&) { return table->value(uv, 0); };
      result.source.size_bounds = [table = table_](const UvBox& box, const Eigen::AlignedBox3d&) {
        return table->bounds(box, 0);
      };
    }
    return result;
  }

  const FieldFunction& function_;
  const Surface& surface_;
  TableOptions options_;
  std::size_t width_;
  std::shared_ptr<const ValueTable> table_;
};

}  // namespace

TabulatedField tabulate(const FieldFunction& function, const Surface& surface,
                        const TableOptions& options) {
  return Tabulation(function, surface, options).run();
}

}  // namespace surfmesh::python
