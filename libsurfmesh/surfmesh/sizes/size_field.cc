// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/size_field.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surfmesh/control/node_interpolation.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/geometry/beside_pole.hh"
#include "surfmesh/geometry/curvature.hh"
#include "surfmesh/geometry/difference_surface.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/geometry/quasirandom.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/quality/surface_search.hh"
#include "surfmesh/sizes/field_size.hh"
#include "surfmesh/sizes/place_sources.hh"
#include "surfmesh/sizes/point_nodes.hh"
#include "surfmesh/sizes/source_place.hh"
#include "surfmesh/sizes/table_sizes.hh"

namespace surfmesh {
namespace {

/// Intervals of a curve or of a side of a polygon between whose ends its size is looked for.
constexpr int kSamplesOnCurve = 64;

/// Places of a surface from which the one nearest to a size in space is looked for.
constexpr int kPlacesOfSurface = 300;

/// Rays on which the ring around an extraordinary vertex is sampled, in each quarter of it.
constexpr int kRingSamples = 5;

/// Share of its width and height at which the field is looked at in each cell of the surface.
constexpr double kCellShare = 0.45;

/// Share of the greatest |p_u| or |p_v| of a surface below which they are rounding.
constexpr double kNoSpeed = 1e-10;

/// The length that a size tensor asks for along a unit vector.
double length_along(const SizeTensor& h, const Eigen::Vector2d& direction) {
  const double x = h.h22 * direction.x() - h.h12 * direction.y();
  const double y = h.h11 * direction.y() - h.h12 * direction.x();
  return determinant(h) / std::hypot(x, y);
}

}  // namespace

SizeField::SizeField(const Surface& surface, const ResolvedSizing& sizing,
                     const PatchSources& sources, double precision)
    : surface_(surface),
      differences_(sizing.curvature_from == CurvatureFrom::Differences
                       ? std::make_shared<DifferenceSurface>(surface)
                       : nullptr),
      domain_(surface.domain()),
      bounds_(sources.bounds.value_or(sizing.bounds)),
      length_(sizing),
      stretch_(sizing.stretch),
      is_isotropic_(sizing.isotropic),
      speeds_(greatest_speeds()) {
  add_all_sources(sources, sizing.grade, precision);
  if (length_.is_off()) return;
  add_discs();
}

SizeField SizeField::without_sag() const {
  SizeField result = *this;
  result.length_ = length_.without_sag();
  return result;
}

/// A disc reaches over the cells around its vertex: farther cells that are near in space, as those
/// of the other side of a sheet, do not see it.
void SizeField::add_discs() {
  const CellCount cells = surface_.cells();
  const auto count = [](int n) { return static_cast<std::size_t>(n); };
  discs_.resize(count(cells.u) * count(cells.v));
  for (const SingularPoint& singular : surface_.singular_points()) {
    const Disc disc = make_disc(singular);
    const Uv at = surface_.to_cells(singular.at);
    const int column = static_cast<int>(std::lround(at.u)),
              row = static_cast<int>(std::lround(at.v));
    for (int j = std::max(row - 1, 0); j <= std::min(row, cells.v - 1); ++j) {
      for (int i = std::max(column - 1, 0); i <= std::min(column, cells.u - 1); ++i) {
        discs_[count(j) * count(cells.u) + count(i)].push_back(disc);
      }
    }
  }
}

/// The index of the cell of a point, rows along u.
std::size_t SizeField::cell_at(Uv uv) const {
  const CellCount cells = surface_.cells();
  const Uv at = surface_.to_cells(uv);
  const int column = std::clamp(static_cast<int>(at.u), 0, cells.u - 1);
  const int row = std::clamp(static_cast<int>(at.v), 0, cells.v - 1);
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.u) +
         static_cast<std::size_t>(column);
}

void SizeField::add_all_sources(const PatchSources& sources, double grade, double precision) {
  for (const EverywhereSource& source : sources.everywhere) {
    const SizeTensor size =
        at_source(source, [&] { return bounds_.clamp(bounds_.tensor(source.size)); });
    everywhere_ = everywhere_ ? bounds_.clamp(minimum(*everywhere_, size)) : size;
  }
  fields_ = sources.fields;
  fans_ = sources.fans;
  rings_ = sources.rings;
  for (const TableSource& source : sources.tables) {
    tables_.push_back(at_source(source, [&] {
      return std::make_shared<NodeInterpolation>(
          interpolate_table(source, surface_, bounds_, precision));
    }));
  }
  std::vector<PlacedSize> placed;
  for (const InsideSource& source : sources.inside) {
    at_source(source, [&] {
      areas_.push_back({source.polygon, bounds_.clamp(bounds_.tensor(source.wish.size))});
      add_border(source, surface_, bounds_, placed);
    });
  }
  for (const AlongSource& source : sources.along) {
    at_source(source, [&] { add_along(source, surface_, bounds_, placed); });
  }
  const bool is_interpolated =
      !has_area_source() && (!placed.empty() || !sources.trees.empty()) && !sources.at.empty();
  if (is_interpolated) {
    tables_.push_back(
        std::make_shared<NodeInterpolation>(surface_, point_nodes(sources.at, surface_, bounds_)));
  }
  for (const AtSource& source : sources.at) {
    at_source(source, [&] { add_at(source, surface_, bounds_, placed); });
  }
  add_required_points(sources);
  if (grade == 0) add_nearest_points(sources);
  add_cells();
  add_tree(std::make_shared<SourceTree>(std::move(placed), grade));
  for (const auto& tree : sources.trees) add_tree(tree);
  has_wishes_ =
      everywhere_ || !areas_.empty() || !fields_.empty() || !tables_.empty() || !trees_.empty();
}

void SizeField::add_required_points(const PatchSources& sources) {
  const auto add_curve_points = [this](const Curve& curve) {
    for (int i = 0; i <= kSamplesOnCurve; ++i) {
      required_points_.push_back(
          domain_.fold(domain_.clamp(curve.evaluate(double(i) / kSamplesOnCurve))));
    }
  };
  for (const AtSource& source : sources.at) required_points_.push_back(domain_.clamp(source.at));
  for (const auto& table : tables_) {
    for (const Uv uv : table->points()) {
      required_points_.push_back(domain_.fold(domain_.clamp(uv)));
    }
  }
  for (const AlongSource& source : sources.along) {
    for (const auto& curve : source.curves) add_curve_points(*curve);
  }
  for (const InsideSource& source : sources.inside) {
    for (std::size_t i = 0; i < source.polygon.size(); ++i) {
      add_curve_points(
          SegmentCurve(source.polygon[i], source.polygon[(i + 1) % source.polygon.size()]));
    }
  }
}

/// Without gradation, sizes in space are not seen beyond their reach.
void SizeField::add_nearest_points(const PatchSources& sources) {
  std::vector<Uv> places;
  std::vector<Vec3> points;
  for (int i = 1; i <= kPlacesOfSurface && !sources.trees.empty(); ++i) {
    places.push_back(domain_.fold(quasirandom_point(domain_, i)));
    points.push_back(surface_.evaluate(places.back(), Order::Position).point);
  }
  for (const auto& tree : sources.trees) {
    for (const PlacedSize& placed : tree->sizes()) {
      const Vec3 middle = 0.5 * (placed.from + placed.to);
      const auto nearest =
          std::min_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
            return (a - middle).squaredNorm() < (b - middle).squaredNorm();
          });
      const Uv guess = places[static_cast<std::size_t>(nearest - points.begin())];
      const NearPoint found = find_near_point(surface_, middle, guess);
      const double extent = 0.5 * (placed.to - placed.from).norm();
      if (found.distance <= reach(placed) + extent) required_points_.push_back(found.uv);
    }
  }
}

/// What is in a cell may be too small to be seen from far apart, too.
void SizeField::add_cells() {
  const CellCount cells = surface_.cells();
  if (cells.u * cells.v == 1) return;
  for (int j = 0; j < cells.v; ++j) {
    for (int i = 0; i < cells.u; ++i) {
      required_points_.push_back(surface_.from_cells({i + kCellShare, j + kCellShare}));
    }
  }
}

void SizeField::add_tree(std::shared_ptr<const SourceTree> tree) {
  if (!tree->empty()) trees_.push_back(std::move(tree));
}

bool SizeField::has_area_source() const {
  return !length_.is_off() || everywhere_ || !areas_.empty() || !fields_.empty() ||
         !tables_.empty() || !rings_.empty();
}

bool SizeField::has_source() const { return has_area_source() || !trees_.empty(); }

/// The principal curvatures that count for sizes. The jet is that of the point.
PrincipalCurvatures SizeField::curvatures(Uv uv, const Jet& jet) const {
  PrincipalCurvatures k = principal_curvatures(jet);
  if (fans_.empty()) return k;
  const std::size_t cell = cell_at(uv);
  for (const WideFan& fan : fans_) {
    if (fan.turns[cell] < INFINITY) k = without_ripples(k, jet, fan.centre, fan.turns[cell]);
  }
  return k;
}

SizeTensor SizeField::size_from_curvature(Uv uv, const Jet& jet) const {
  const PrincipalCurvatures k = curvatures(uv, jet);
  double h1 = bounds_.clamp(length_.of_surface(k.k1));
  double h2 = bounds_.clamp(length_.of_surface(k.k2));
  h1 = std::min(h1, stretch_ * h2);
  h2 = std::min(h2, stretch_ * h1);
  return size_tensor(h1, h2, k.cos2, k.sin2);
}

/// The part of a ring around a singular point in one quarter of the directions from it: the least
/// size there, and the least distance in space.
SizeField::Disc SizeField::quarter_ring(const Disc& so_far, Uv at, Uv towards,
                                        double distance) const {
  Disc ring = so_far;
  for (int i = 0; i < kRingSamples; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / (kRingSamples - 1);
    const Uv on_ring{at.u + towards.u * distance * std::cos(angle),
                     at.v + towards.v * distance * std::sin(angle)};
    const Uv regular = surface_.beside_roundings(domain_.fold(on_ring));
    const Jet jet = second_order(regular);
    const PrincipalCurvatures k = curvatures(regular, jet);
    const double greatest = std::max(std::abs(k.k1), std::abs(k.k2));
    ring.size = std::min(ring.size, std::max(bounds_.hmin, length_.around_vertex(greatest)));
    ring.radius = std::min(ring.radius, (jet.point - ring.centre).norm());
  }
  return ring;
}

/// The ring at a distance (in cells) from a singular point, as far as it lies in the domain.
SizeField::Disc SizeField::ring_around(Uv at, double distance) const {
  Disc ring{surface_.evaluate(at, Order::Position).point, INFINITY, bounds_.hmax};
  const CellCount cells = surface_.cells();
  const double width = (domain_.u1 - domain_.u0) / cells.u;
  const double height = (domain_.v1 - domain_.v0) / cells.v;
  for (const double towards_v : {height, -height}) {
    if (at.v == (towards_v > 0 ? domain_.v1 : domain_.v0)) continue;
    for (const double towards_u : {width, -width}) {
      if (at.u == (towards_u > 0 ? domain_.u1 : domain_.u0)) continue;
      ring = quarter_ring(ring, at, {towards_u, towards_v}, distance);
    }
  }
  return ring;
}

SizeField::Disc SizeField::make_disc(const SingularPoint& singular) const {
  // Rings of half the size of the one before, until a ring is as near as half the size on it.
  double distance = 0.5;
  Disc ring = ring_around(singular.at, distance);
  while (ring.radius > 0.5 * ring.size && 0.5 * distance >= singular.reach) {
    distance *= 0.5;
    ring = ring_around(singular.at, distance);
  }
  return ring;
}

void SizeField::blend_with_discs(Uv uv, Sample& sample) const {
  for (const Disc& disc : discs_[cell_at(uv)]) {
    const double squared = (sample.point - disc.centre).squaredNorm();
    if (squared >= 4 * disc.radius * disc.radius) continue;
    const double share = std::min(1.0, 2 - std::sqrt(squared) / disc.radius);
    SizeTensor& h = sample.size;
    const SizeTensor inside = isotropic(disc.size);
    h = {(1 - share) * h.h11 + share * inside.h11, (1 - share) * h.h12,
         (1 - share) * h.h22 + share * inside.h22};
  }
}

Jet SizeField::second_order(Uv uv) const {
  return (differences_ ? *differences_ : surface_).evaluate(uv, Order::Second);
}

/// Set the size that follows from the curvature, if there is a tangent plane here or beside.
void SizeField::add_curvature(Uv uv, const Jet& jet, Sample& sample) const {
  const Uv regular =
      is_regular(sample.form) ? surface_.beside_roundings(uv) : beside_pole(surface_, uv);
  const Jet there = regular == uv ? jet : second_order(regular);
  if (!is_regular(first_form_factor(there.du, there.dv))) return;
  sample.size = size_from_curvature(regular, there);
  blend_with_discs(uv, sample);
}

void SizeField::add_sources(Uv uv, const Jet& jet, Sample& sample) const {
  SizeTensor& size = sample.size;
  if (everywhere_) size = minimum(size, *everywhere_);
  for (const Area& area : areas_) {
    if (contains(area.polygon, uv)) size = minimum(size, area.size);
  }
  const SurfacePoint point = {uv, sample.point, sample.form};
  for (const FieldSource& field : fields_) {
    size = minimum(size, bounds_.clamp(size_of_field(field, surface_, point)));
  }
  for (const auto& table : tables_) {
    size = minimum(size, table->at(point).size);
  }
  if (!trees_.empty()) {
    const TangentFrame frame = tangent_frame(jet);
    for (const auto& tree : trees_) size = tree->minimum_at(frame, size);
  }
  // Where stretched sizes cross, their minimum is shorter than both.
  size = bounds_.clamp(size);
}

/// A pole has the sizes around that hold beside it, for nodes beside it average with its own.
void SizeField::add_rings(Uv uv, Sample& sample) const {
  for (const Ring& ring : rings_) {
    FirstFormFactor form = sample.form;
    if (!is_regular(form)) {
      const Jet jet = surface_.evaluate(beside_pole(surface_, uv), Order::First);
      form = first_form_factor(jet.du, jet.dv);
    }
    if (!is_regular(form)) continue;
    // The frame's first axis is along p_u; p_v is (l21, l22) in it.
    const Eigen::Vector2d along_u(1, 0);
    const Eigen::Vector2d along_v = Eigen::Vector2d(form.l21, form.l22).normalized();
    const Eigen::Vector2d& line = ring.is_along_u ? along_u : along_v;
    const double element = length_along(sample.size, ring.is_along_u ? along_v : along_u);
    const double around = size_around(ring.length_at(uv, element), bounds_);
    if (around >= bounds_.hmax) continue;
    const double x = line.x(), y = line.y();
    sample.size = minimum(sample.size, size_tensor(around, bounds_.hmax, x * x - y * y, 2 * x * y));
  }
}

/// Greatest lengths of p_u and p_v at a few places.
SizeField::Speeds SizeField::greatest_speeds() const {
  Speeds speeds;
  for (const double t : {0.1, 0.5, 0.9}) {
    for (const double s : {0.1, 0.5, 0.9}) {
      const Jet jet = surface_.evaluate(domain_.fold(domain_.at(s, t)), Order::First);
      speeds.u = std::max(speeds.u, jet.du.norm());
      speeds.v = std::max(speeds.v, jet.dv.norm());
    }
  }
  return speeds;
}

/// The first form at a point. At a pole, a derivative that should vanish may be rounding: then it
/// does.
FirstFormFactor SizeField::form_of(const Jet& jet) const {
  const bool has_u = jet.du.squaredNorm() > kNoSpeed * kNoSpeed * speeds_.u * speeds_.u;
  const bool has_v = jet.dv.squaredNorm() > kNoSpeed * kNoSpeed * speeds_.v * speeds_.v;
  return first_form_factor(has_u ? jet.du : Vec3(Vec3::Zero()),
                           has_v ? jet.dv : Vec3(Vec3::Zero()));
}

SizeField::Sample SizeField::at(Uv uv) const {
  uv = domain_.fold(uv);
  const bool is_curved = !length_.is_off();
  const Jet jet = is_curved ? second_order(uv) : surface_.evaluate(uv, Order::First);
  Sample sample;
  sample.point = jet.point;
  sample.form = form_of(jet);
  sample.size = isotropic(bounds_.hmax);
  if (is_curved) add_curvature(uv, jet, sample);
  if (has_wishes_) add_sources(uv, jet, sample);
  add_rings(uv, sample);
  if (is_isotropic_) sample.size = isotropic(size_range(sample.size).least);
  return sample;
}

}  // namespace surfmesh
