// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "fuzz/byte_reader.hh"
#include "fuzz/checks.hh"
#include "fuzz/targets.hh"
#include "surfmesh/formats/medit_reader.hh"
#include "surfmesh/formats/msh_reader.hh"
#include "surfmesh/formats/vtu_reader.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/model_file/read_background.hh"
#include "surfmesh/model_file/read_table.hh"
#include "surfmesh/sizes/background_sizes.hh"
#include "surfmesh/sizes/table_sizes.hh"

namespace surfmesh::fuzz {
namespace {

/// Larger ones take long.
constexpr std::size_t kMostNodes = 300;

enum class Kind { Table, Msh, Vtu, Medit, Sol };
constexpr std::array kKinds = {Kind::Table, Kind::Msh, Kind::Vtu, Kind::Medit, Kind::Sol};

constexpr double kSharesOfSheet[] = {0, 0.2, 0.5, 0.9, 1};

std::shared_ptr<const Surface> sheet() {
  return std::make_shared<FormulaSurface>(SurfaceFormulas{"u", "v+0.1*u", "0.2*sin(3*u)*v", {}},
                                          Domain{0, 1, 0, 1});
}

void check_table(const std::string& text) {
  const auto surface = sheet();
  TableSource source;
  source.patch = 0;
  source.nodes = parse_table(text, "table.csv", surface->domain());
  if (source.nodes.size() > kMostNodes) return;
  const SizeBounds bounds{1e-3, 0.5, 1.5};
  demand(count_clamped(source, *surface, bounds) <= source.nodes.size(), "rows are counted once");
  for (const ControlNode& node : table_nodes(source, *surface, bounds)) {
    demand(node.point.allFinite(), "nodes of tables are somewhere");
  }
  demand(!interpolate_table(source, *surface, bounds, 0.1).points().empty(), "tables have points");
}

/// Three triangles, for values of another file.
GridFile small_grid() {
  GridFile grid;
  grid.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 0}};
  grid.faces.add(std::array{0, 1, 2});
  grid.faces.add(std::array{0, 2, 3});
  grid.faces.add(std::array{1, 4, 2});
  return grid;
}

/// Values for a mesh without, that a file beside it would have.
void add_own_sizes(GridFile& grid) {
  GridValues& sizes = grid.at_points.emplace_back();
  sizes.name = std::string("h");
  sizes.components = 1;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    sizes.numbers.push_back(0.1 + 0.05 * static_cast<double>(i % 7));
  }
}

GridFile read_grid_of(Kind kind, std::string text) {
  if (kind == Kind::Msh) return parse_msh_grid(std::move(text), "a.msh");
  if (kind == Kind::Vtu) return parse_vtu_grid(std::move(text), "a.vtu");
  if (kind == Kind::Medit) return parse_medit_grid(std::move(text), "a.mesh");
  GridFile grid = small_grid();
  add_medit_values(std::move(text), "a.sol", grid);
  return grid;
}

void check_size(const FieldSource& field, Uv uv, const Vec3& point) {
  const double size = field.size(uv, point);
  demand(size > 0 && std::isfinite(size), "sizes of a background mesh are sizes");
  const Vec3 reach(0.1, 0.2, 0.3);
  const UvBox around{{uv.u - 0.1, uv.u + 0.2}, {uv.v - 0.2, uv.v + 0.1}};
  const Interval bounds = field.size_bounds(around, {point - reach, point + reach});
  const double slack = 1e-9 * size;
  demand(bounds.lower <= size + slack && size - slack <= bounds.upper, "bounds hold the sizes");
}

void check_field(const FieldSource& field, const Surface& surface) {
  for (const double u : kSharesOfSheet) {
    for (const double v : kSharesOfSheet) {
      const Vec3 point = surface.evaluate({u, v}, Order::Position).point;
      if (field.size) {
        check_size(field, {u, v}, point);
      } else {
        const Metric metric = field.metric({u, v}, point);
        demand(metric.m11 > 0 && metric.m11 * metric.m22 - metric.m12 * metric.m12 >= 0,
               "metrics of a background mesh are positive definite");
      }
    }
  }
}

void check_background(Kind kind, std::string text, BackgroundIn in) {
  GridFile grid = read_grid_of(kind, std::move(text));
  if (grid.points.size() > kMostNodes) return;
  if (grid.at_points.empty()) add_own_sizes(grid);
  const std::string name = grid.at_points.front().name;
  const auto surface = sheet();
  const auto sizes = std::make_shared<BackgroundSizes>(background_mesh(grid, name, in), in);
  check_field(background_field(sizes, 0, surface), *surface);
}

}  // namespace

bool try_table(Bytes input) {
  ByteReader bytes(input);
  const Kind kind = bytes.one_of(kKinds);
  const BackgroundIn in = bytes.happens(80) ? BackgroundIn::Uv : BackgroundIn::Space;
  std::string text = bytes.rest();
  return accepts([&] {
    if (kind == Kind::Table) {
      check_table(text);
    } else {
      check_background(kind, std::move(text), in);
    }
  });
}

}  // namespace surfmesh::fuzz
