// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/build_model.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/project_to_curve.hh"

namespace surfmesh {
namespace {

/// Uses of a contour, and vertices at their ends, may differ by the rounding of hand-made formulas
/// only: this share of the diagonal.
constexpr double kUseGap = 1e-6;

/// Below this share of the diagonal, points at equal t are taken as the same point: the rounding of
/// two evaluations. A true difference of speed is far above.
constexpr double kSameSpeedGap = 1e-9;

/// Samples of a curve for the area it encloses and the bounding box.
constexpr int kCurveSamples = 64;

/// Samples of a domain in each direction for the bounding box.
constexpr int kDomainSamples = 16;

/// Places where uses of a contour are compared: t = 0, 1/8, ..., 1.
constexpr int kComparedSteps = 8;

void require_index(int index, std::size_t count, const char* what) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("there is no {} {}, the model has {}", what, index, count));
}

void require_curve(const std::shared_ptr<const Curve>& curve, const std::string& contour) {
  if (!curve) throw Error(ErrorCode::InvalidInput, fmt::format("contour {} has no curve", contour));
}

Vec3 place(const Model& model, const ContourUse& use, double t) {
  const Surface& surface = *model.patches[static_cast<std::size_t>(use.patch)].surface;
  return surface.evaluate(use.curve->evaluate(t), Order::Position).point;
}

void append_samples(const Curve& curve, bool is_forward, std::vector<Uv>& polygon) {
  for (int i = 0; i < kCurveSamples; ++i) {
    const double t = static_cast<double>(i) / kCurveSamples;
    polygon.push_back(curve.evaluate(is_forward ? t : 1 - t));
  }
}

std::vector<Uv> sample_loop(const Model& model, const Loop& loop) {
  std::vector<Uv> polygon;
  for (const LoopEntry& entry : loop) {
    const ContourUse& use = model.contours[static_cast<std::size_t>(entry.contour)]
                                .uses[static_cast<std::size_t>(entry.use)];
    append_samples(*use.curve, use.is_forward, polygon);
  }
  return polygon;
}

/// Twice the area, positive if the polygon runs counter-clockwise.
double doubled_area(const std::vector<Uv>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return sum;
}

/// Whether the ray from p in the direction of growing u crosses the polygon an odd number of times.
bool crosses_oddly(Uv p, const std::vector<Uv>& polygon) {
  bool is_odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Uv a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.v > p.v) == (b.v > p.v)) continue;
    is_odd ^= p.u < a.u + (p.v - a.v) / (b.v - a.v) * (b.u - a.u);
  }
  return is_odd;
}

bool is_inside(Uv p, const std::vector<std::vector<Uv>>& polygons) {
  return std::count_if(polygons.begin(), polygons.end(),
                       [&](const auto& polygon) { return crosses_oddly(p, polygon); }) %
             2 ==
         1;
}

std::vector<std::vector<Uv>> sample_loops(const Model& model, const Patch& patch) {
  std::vector<std::vector<Uv>> polygons;
  for (const Loop& loop : patch.loops) polygons.push_back(sample_loop(model, loop));
  return polygons;
}

double sampled_diagonal(const Model& model) {
  Eigen::AlignedBox3d box;
  for (const Patch& patch : model.patches) {
    const auto add = [&](Uv uv) { box.extend(patch.surface->evaluate(uv, Order::Position).point); };
    const std::vector<std::vector<Uv>> polygons = sample_loops(model, patch);
    for (const std::vector<Uv>& polygon : polygons)
      std::for_each(polygon.begin(), polygon.end(), add);
    const Domain domain = patch.surface->domain();
    for (int i = 0; i < kDomainSamples * kDomainSamples; ++i) {
      const Uv uv = domain.at((i % kDomainSamples + 0.5) / kDomainSamples,
                              (i / kDomainSamples + 0.5) / kDomainSamples);
      if (is_inside(uv, polygons)) add(uv);
    }
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// Compare a use with the contour's first, and tell whether both have the same speed.
bool is_same_speed(const Model& model, const Contour& contour, const ContourUse& use) {
  bool is_same = true;
  for (int i = 0; i <= kComparedSteps; ++i) {
    const double t = static_cast<double>(i) / kComparedSteps;
    const Vec3 wanted = place(model, contour.uses[0], t);
    if ((place(model, use, t) - wanted).norm() <= kSameSpeedGap * model.diagonal) continue;
    is_same = false;
    const Surface& surface = *model.patches[static_cast<std::size_t>(use.patch)].surface;
    const double nearest = project_to_curve(surface, *use.curve, wanted, t);
    const double gap = (place(model, use, nearest) - wanted).norm();
    if (gap <= kUseGap * model.diagonal) continue;
    throw Error(ErrorCode::Geometry,
                fmt::format("contour {}: its curves on patches {} and {} are {} apart in space",
                            contour.name,
                            model.patches[static_cast<std::size_t>(contour.uses[0].patch)].name,
                            model.patches[static_cast<std::size_t>(use.patch)].name, gap));
  }
  return is_same;
}

void check_ends(const Model& model, const Contour& contour, const ContourUse& use) {
  for (const auto& [vertex, t] : {std::pair(contour.start, 0.0), std::pair(contour.end, 1.0)}) {
    const Vec3& position = model.vertices[static_cast<std::size_t>(vertex)].position;
    const double gap = (place(model, use, t) - position).norm();
    if (gap <= kUseGap * model.diagonal) continue;
    throw Error(ErrorCode::Geometry,
                fmt::format("contour {}: on patch {} its {} is {} from its vertex", contour.name,
                            model.patches[static_cast<std::size_t>(use.patch)].name,
                            t == 0 ? "start" : "end", gap));
  }
}

void check_direction(const Model& model, const Patch& patch) {
  for (std::size_t i = 0; i < patch.loops.size(); ++i) {
    const double area = doubled_area(sample_loop(model, patch.loops[i]));
    if (i == 0 ? area > 0 : area < 0) continue;
    const int contour = patch.loops[i].front().contour;
    throw Error(ErrorCode::Geometry,
                fmt::format("patch {}: the {} with contour {} must run {} in (u,v)", patch.name,
                            i == 0 ? "outer loop" : "hole",
                            model.contours[static_cast<std::size_t>(contour)].name,
                            i == 0 ? "counter-clockwise" : "clockwise"));
  }
}

}  // namespace

int add_vertex(Model& model, const Vec3& position) {
  if (!position.allFinite()) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("vertex {}: its position is not finite", model.vertices.size()));
  }
  model.vertices.push_back({position});
  return static_cast<int>(model.vertices.size()) - 1;
}

int add_patch(Model& model, std::string name, std::shared_ptr<const Surface> surface) {
  if (!surface) {
    throw Error(ErrorCode::InvalidInput, fmt::format("patch {} has no surface", name));
  }
  if (std::any_of(model.patches.begin(), model.patches.end(),
                  [&](const Patch& patch) { return patch.name == name; })) {
    throw Error(ErrorCode::InvalidInput, fmt::format("there is a patch {} already", name));
  }
  model.patches.push_back({std::move(name), std::move(surface), {}, -1});
  return static_cast<int>(model.patches.size()) - 1;
}

int add_contour(Model& model, std::string name, int start, int end) {
  require_index(start, model.vertices.size(), "vertex");
  require_index(end, model.vertices.size(), "vertex");
  Contour contour;
  contour.name = std::move(name);
  contour.start = start;
  contour.end = end;
  model.contours.push_back(std::move(contour));
  return static_cast<int>(model.contours.size()) - 1;
}

LoopEntry add_use(Model& model, int contour, int patch, std::shared_ptr<const Curve> curve,
                  bool is_forward) {
  require_index(contour, model.contours.size(), "contour");
  require_index(patch, model.patches.size(), "patch");
  Contour& used = model.contours[static_cast<std::size_t>(contour)];
  require_curve(curve, used.name);
  used.uses.push_back({patch, std::move(curve), is_forward, true});
  return {contour, static_cast<int>(used.uses.size()) - 1};
}

void add_loop(Model& model, int patch, Loop loop) {
  require_index(patch, model.patches.size(), "patch");
  model.patches[static_cast<std::size_t>(patch)].loops.push_back(std::move(loop));
}

void add_loop(Model& model, int patch, const std::vector<NamedCurve>& curves) {
  require_index(patch, model.patches.size(), "patch");
  const Patch& owner = model.patches[static_cast<std::size_t>(patch)];
  if (curves.empty()) {
    throw Error(ErrorCode::InvalidInput, fmt::format("patch {}: a loop is empty", owner.name));
  }
  std::vector<Uv> polygon;
  for (const NamedCurve& named : curves) {
    require_curve(named.curve, named.name);
    append_samples(*named.curve, true, polygon);
  }
  const bool is_forward = (doubled_area(polygon) > 0) == owner.loops.empty();
  const int first = static_cast<int>(model.vertices.size());
  for (const NamedCurve& named : curves) {
    add_vertex(model, owner.surface->evaluate(named.curve->evaluate(0), Order::Position).point);
  }
  const int count = static_cast<int>(curves.size());
  Loop loop;
  for (int i = 0; i < count; ++i) {
    const NamedCurve& named = curves[static_cast<std::size_t>(i)];
    const int contour = add_contour(model, named.name, first + i, first + (i + 1) % count);
    loop.push_back(add_use(model, contour, patch, named.curve, is_forward));
  }
  if (!is_forward) std::reverse(loop.begin(), loop.end());
  add_loop(model, patch, std::move(loop));
}

std::vector<NamedCurve> polygon_curves(const std::string& name, const std::vector<Uv>& corners) {
  if (corners.size() < 3) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("polygon {} has {} corners, less than 3", name, corners.size()));
  }
  std::vector<NamedCurve> curves;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    curves.push_back(
        {fmt::format("{}{}", name, i),
         std::make_shared<SegmentCurve>(corners[i], corners[(i + 1) % corners.size()])});
  }
  return curves;
}

void complete_model(Model& model) {
  check_structure(model);
  model.diagonal = sampled_diagonal(model);
  check(model);
  for (Contour& contour : model.contours) {
    if (contour.uses.size() == 1) contour.is_smooth = false;
    for (ContourUse& use : contour.uses) {
      check_ends(model, contour, use);
      use.is_same_speed = is_same_speed(model, contour, use);
    }
  }
  for (const Patch& patch : model.patches) check_direction(model, patch);
}

}  // namespace surfmesh
