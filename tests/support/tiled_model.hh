// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "support/metric_fields.hh"
#include "support/models.hh"
#include "surfmesh/boundary/contour_nodes.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/tiles/cut_into_tiles.hh"

/// Models whose patches are cut into tiles.
namespace surfmesh::testing {

/// Makes the sizes on a surface.
using FieldOn = std::function<FunctionField(const Surface&)>;

/// One length in space.
inline FieldOn sizes_of(double size) {
  return [size](const Surface& surface) { return isotropic_field_on(surface, size); };
}

/// One field, whatever the surface.
inline FieldOn sizes_of(const FunctionField& field) {
  return [field](const Surface&) { return field; };
}

struct TileOptions {
  double most = 0;  ///< triangles of a tile
  int multiple = 1;
  double sag = 0;
};

inline bool is_inside(const std::vector<BoundaryLoop>& loops, Uv point) {
  bool is_in = false;
  for (const BoundaryLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Uv a = loop[i].uv, b = loop[(i + 1) % loop.size()].uv;
      if ((a.v < point.v) == (b.v < point.v)) continue;
      if (a.u + (point.v - a.v) / (b.v - a.v) * (b.u - a.u) > point.u) is_in = !is_in;
    }
  }
  return is_in;
}

/// Area of a domain in its parameters.
inline double area_of(const PatchBoundary& boundary) {
  double sum = 0;
  for (const BoundaryLoop& loop : boundary.loops) {
    const Uv origin = loop.front().uv;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      sum += 0.5 * cross(loop[i].uv - origin, loop[i + 1].uv - origin);
    }
  }
  return sum;
}

/// Unit triangles that fill a domain: by the mean density at 200 × 200 places of its box.
inline double unit_triangles(const PatchBoundary& boundary, const MetricField& field) {
  constexpr int kSide = 200;
  Uv lower = boundary.loops.front().front().uv, upper = lower;
  for (const BoundaryNode& node : boundary.loops.front()) {
    lower = {std::min(lower.u, node.uv.u), std::min(lower.v, node.uv.v)};
    upper = {std::max(upper.u, node.uv.u), std::max(upper.v, node.uv.v)};
  }
  double sum = 0;
  int inside = 0;
  QueryHint hint;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const Uv uv{std::lerp(lower.u, upper.u, (i + 0.5) / kSide),
                  std::lerp(lower.v, upper.v, (j + 0.5) / kSide)};
      if (!is_inside(boundary.loops, uv)) continue;
      sum += density(field.at(uv, hint));
      ++inside;
    }
  }
  return inside == 0 ? 0 : sum / inside * area_of(boundary) / kUnitTriangleArea;
}

/// All patches of a model, whole and as tiles.
class TiledModel {
 public:
  TiledModel(Model given, const FieldOn& sizes, const TileOptions& options)
      : model(std::move(given)),
        fields(fields_on(model, sizes)),
        nodes(nodes_of(options)),
        numbers(model, nodes) {
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
      whole.push_back(collect_boundary(model, static_cast<int>(p), nodes, numbers, fields[p],
                                       options.multiple));
      triangles.push_back(unit_triangles(whole[p], fields[p]));
      first_vertex.push_back(numbers.count());
      of_patches.push_back(cut_into_tiles(whole[p], task(p, options), numbers.count()));
      numbers.add(of_patches[p].shared_nodes);
    }
  }

  TileTask task(std::size_t patch, const TileOptions& options) const {
    return {.surface = *model.patches[patch].surface,
            .field = fields[patch],
            .triangles = triangles[patch],
            .most = options.most,
            .multiple = options.multiple,
            .sag = options.sag};
  }

  Model model;
  std::vector<FunctionField> fields;  ///< by patch
  std::vector<ContourNodes> nodes;
  NodeNumbers numbers;
  std::vector<PatchBoundary> whole;
  std::vector<double> triangles;  ///< that each patch will have
  std::vector<int> first_vertex;  ///< that its tiles share, by patch
  std::vector<Tiles> of_patches;

 private:
  static std::vector<FunctionField> fields_on(const Model& model, const FieldOn& sizes) {
    std::vector<FunctionField> fields;
    for (const Patch& patch : model.patches) fields.push_back(sizes(*patch.surface));
    return fields;
  }

  std::vector<ContourNodes> nodes_of(const TileOptions& options) const {
    std::vector<const MetricField*> pointers;
    for (const FunctionField& field : fields) pointers.push_back(&field);
    ContourDemands demands;
    if (options.multiple == 2) demands.parity = SegmentParity::EvenPatches;
    if (options.sag > 0) demands.sag = options.sag;
    return place_contour_nodes(model, pointers, demands).contours;
  }
};

/// The square [-1,1]² with two round holes that touch in the origin.
inline Model square_with_touching_holes() {
  Model model = model_of({rectangle(-1, -1, 1, 1)});
  const int vertex = static_cast<int>(model.vertices.size());
  model.vertices.push_back({Vec3::Zero()});
  for (const double radius : {-0.3, 0.3}) {
    Contour hole;
    hole.name = radius < 0 ? "left" : "right";
    hole.start = hole.end = vertex;
    hole.is_smooth = false;
    const auto curve = std::make_shared<CallableCurve>([radius](double t) {
      const double angle = t == 1 ? 0 : 2 * std::numbers::pi * t;
      return Uv{radius - radius * std::cos(angle), -radius * std::sin(angle)};
    });
    // Counter-clockwise: the patch lies on the right.
    hole.uses.push_back({0, curve, false, true});
    model.patches[0].loops.push_back({{static_cast<int>(model.contours.size()), 0}});
    model.contours.push_back(std::move(hole));
  }
  return model;
}

}  // namespace surfmesh::testing
