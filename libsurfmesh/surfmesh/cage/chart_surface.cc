// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/chart_surface.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// A point is found when it is missed by less than this share of a face: what is left is corrected
/// to first order.
constexpr double kMiss = 1e-7;

/// Steps of Newton's method and from face to face, of which five are usual.
constexpr int kMostSteps = 60;

/// Slope of a chart that its faces never have: they turn by 69° at most. The slopes of vertices are
/// cut at it.
constexpr double kMostSlope = 4;

/// How much the slope changes over the width of a face, at most: more is that of slivers.
constexpr double kMostBend = 4;

/// Faces around a corner that are gone through one after the other, at most.
constexpr int kMostTurns = 8;

/// Share of a squared miss that a step along the border leaves at most. Where more is left some
/// times, the point is beyond the border; once or twice it may be so near an extraordinary vertex,
/// where derivatives are not those of the surface.
constexpr double kNearer = 0.25;
constexpr int kMostSlowSteps = 3;

/// Share of a face by which a step may lead beyond it: less than is missed in the end.
constexpr double kBeyond = 1e-9;

/// Twice the area of a triangle, positive if it turns counter-clockwise.
double doubled_area(Uv a, Uv b, Uv c) { return cross(b - a, c - a); }

double squared_norm(Uv step) { return step.u * step.u + step.v * step.v; }

/// The inverse of the matrix whose columns are two steps.
struct InverseSteps {
  InverseSteps(Uv a, Uv b) {
    const double determinant = cross(a, b);
    row_a = {b.v / determinant, -b.u / determinant};
    row_b = {-a.v / determinant, a.u / determinant};
  }

  Uv operator()(Uv step) const {
    return {row_a.u * step.u + row_a.v * step.v, row_b.u * step.u + row_b.v * step.v};
  }

  Uv row_a, row_b;
};

/// The point at a share of a side of a domain.
Uv on_side(const Domain& domain, int side, double share) {
  return lerp(domain.corner(side), domain.corner((side + 1) % domain.corner_count()), share);
}

/// How far a point is inside of a side of a unit square or triangle, in units of its height.
double inside_of(const Domain& domain, int side, Uv at) {
  if (domain.shape == Domain::Shape::Triangle) {
    return side == 0 ? at.v : side == 1 ? 1 - at.u - at.v : at.u;
  }
  return side == 0 ? at.v : side == 1 ? 1 - at.u : side == 2 ? 1 - at.v : at.u;
}

/// The share of a side that a point on it is at.
double share_of(const Domain& domain, int side, Uv at) {
  if (domain.shape == Domain::Shape::Triangle) {
    return side == 0 ? at.u : side == 1 ? at.v : 1 - at.v;
  }
  return side == 0 ? at.u : side == 1 ? at.v : side == 2 ? 1 - at.u : 1 - at.v;
}

Uv middle_of(const Domain& domain) {
  return domain.shape == Domain::Shape::Triangle ? Uv{1.0 / 3, 1.0 / 3} : Uv{0.5, 0.5};
}

/// Shares of the corners in a point: barycentric in a triangle, bilinear in a square.
std::array<double, 4> corner_weights(const Domain& domain, Uv at) {
  const double s = at.u, t = at.v;
  if (domain.shape == Domain::Shape::Triangle) return {1 - s - t, s, t, 0};
  return {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
}

/// Where a step leaves a domain.
struct Exit {
  int side = -1;
  double share = 1;  ///< of the step
};

/// Of two sides in a corner, one that has a neighbour is left through.
Exit exit_of(const Domain& domain, Uv at, Uv step, const ChartFace& face) {
  Exit first;
  for (int side = 0; side < domain.corner_count(); ++side) {
    double before = inside_of(domain, side, at);
    if (before <= kBeyond) before = 0;
    const double after = inside_of(domain, side, at + step);
    if (after >= -kBeyond) continue;
    const double share = before / (before - after);
    const bool is_better =
        share == first.share && face.neighbours[static_cast<std::size_t>(side)].face >= 0;
    if (first.side < 0 || share < first.share || is_better) first = {side, share};
  }
  return first;
}

/// The point of a triangle or square next to one that is just outside.
Uv pulled_in(const Domain& domain, Uv at) {
  at = {std::clamp(at.u, 0.0, 1.0), std::clamp(at.v, 0.0, 1.0)};
  if (domain.shape == Domain::Shape::Triangle && at.u + at.v > 1) {
    const double half = (at.u + at.v - 1) / 2;
    at = {std::max(at.u - half, 0.0), std::max(at.v - half, 0.0)};
  }
  return at;
}

}  // namespace

ChartFrame ChartFrame::at(const Vec3& origin, const Vec3& normal) {
  const Vec3 along_u = normal.unitOrthogonal();
  return {origin, along_u, normal.cross(along_u), normal};
}

Chart::Chart(const ChartFrame& frame, std::vector<ChartFace> faces)
    : frame_(frame), faces_(std::move(faces)) {
  if (faces_.empty()) throw Error(ErrorCode::InvalidInput, "a chart has no faces");
  unit_ = faces_[0].surface->domain();
  const int count = unit_.corner_count();
  double area = 0;
  std::vector<std::array<Uv, 4>> slopes;  // at the corners of faces
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    std::array<Uv, 4>& corners = corners_.emplace_back();
    slopes.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const Uv corner = unit_.corner(std::min(static_cast<int>(i), count - 1));
      const Surface& surface = *faces_[f].surface;
      corners[i] = frame_.project(surface.evaluate(corner, Order::Position).point);
      const Jet jet = surface.evaluate(surface.beside_roundings(corner), Order::First);
      const Vec3 normal = jet.du.cross(jet.dv);
      slopes.back()[i] = slope_of(normal);
    }
    area += doubled_area(corners[0], corners[1], corners[2]) +
            doubled_area(corners[0], corners[2], corners[3]);
    for (int side = 0; side < count; ++side) {
      if (faces_[f].neighbours[static_cast<std::size_t>(side)].face < 0) {
        border_.push_back({f, side});
        const Uv along = corners[static_cast<std::size_t>((side + 1) % count)] -
                         corners[static_cast<std::size_t>(side)];
        squared_bulge_ = std::max(squared_bulge_, squared_norm(along) / 4);
      }
    }
  }
  face_size_ = std::sqrt(std::abs(area) / 2 / static_cast<double>(faces_.size()));
  number_vertices();
  measure_bends(slopes);
  sort_into_cells();
}

/// The slope of a plane over that of the chart.
Uv Chart::slope_of(const Vec3& normal) const {
  const Uv across = frame_.step(normal);
  const double steepness = std::hypot(across.u, across.v);
  const double upward = normal.dot(frame_.normal);
  if (!(steepness > 0)) return {0, 0};
  const bool is_wall = !(steepness <= kMostSlope * upward);
  return (is_wall ? -kMostSlope / steepness : -1 / upward) * across;
}

/// Number the vertices from 0.
void Chart::number_vertices() {
  const auto count = static_cast<std::size_t>(unit_.corner_count());
  std::vector<int> numbers;
  for (const ChartFace& face : faces_) {
    numbers.insert(numbers.end(), face.vertices.begin(),
                   face.vertices.begin() + unit_.corner_count());
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (const ChartFace& face : faces_) {
    std::array<std::size_t, 4>& vertices = vertices_.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      const auto found = std::lower_bound(numbers.begin(), numbers.end(), face.vertices[i]);
      vertices[i] = static_cast<std::size_t>(found - numbers.begin());
    }
  }
  bends_.resize(numbers.size());
}

/// At each vertex the mean of how slopes change over the faces around it, by their areas. The slope
/// of a vertex is the mean of those that its faces have there: around an extraordinary vertex they
/// differ.
void Chart::measure_bends(const std::vector<std::array<Uv, 4>>& slopes) {
  const auto count = static_cast<std::size_t>(unit_.corner_count());
  std::vector<Uv>& mean = slopes_;
  mean.assign(bends_.size(), Uv{0, 0});
  std::vector<double> faces(bends_.size(), 0), areas(bends_.size(), 0);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    for (std::size_t i = 0; i < count; ++i) {
      mean[vertices_[f][i]] = mean[vertices_[f][i]] + slopes[f][i];
      faces[vertices_[f][i]] += 1;
    }
  }
  for (std::size_t v = 0; v < mean.size(); ++v) mean[v] = (1 / faces[v]) * mean[v];
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    // Of a quad, that along its diagonals.
    const std::array<Uv, 4>& c = corners_[f];
    const auto slope = [&](std::size_t i) { return mean[vertices_[f][i]]; };
    const bool is_triangle = count == 3;
    const Uv a = c[is_triangle ? 1 : 2] - c[0], b = is_triangle ? c[2] - c[0] : c[3] - c[1];
    const Uv along_a = slope(is_triangle ? 1 : 2) - slope(0);
    const Uv along_b = is_triangle ? slope(2) - slope(0) : slope(3) - slope(1);
    const double area = cross(a, b);
    const InverseSteps inverse(a, b);
    const Bend bend{inverse.row_a.u * along_a.u + inverse.row_b.u * along_b.u,
                    0.5 * (inverse.row_a.v * along_a.u + inverse.row_b.v * along_b.u +
                           inverse.row_a.u * along_a.v + inverse.row_b.u * along_b.v),
                    inverse.row_a.v * along_a.v + inverse.row_b.v * along_b.v};
    if (!(area > 0)) continue;
    for (std::size_t i = 0; i < count; ++i) {
      Bend& sum = bends_[vertices_[f][i]];
      sum.uu += area * bend.uu;
      sum.uv += area * bend.uv;
      sum.vv += area * bend.vv;
      areas[vertices_[f][i]] += area;
    }
  }
  for (std::size_t v = 0; v < bends_.size(); ++v) {
    if (areas[v] == 0) continue;
    const double most = kMostBend / face_size_;
    const auto cut = [&](double sum) { return std::clamp(sum / areas[v], -most, most); };
    bends_[v] = {cut(bends_[v].uu), cut(bends_[v].uv), cut(bends_[v].vv)};
  }
}

Jet Chart::evaluate(Uv uv, Order order) const {
  const Found found = find(uv);
  Jet jet = tangent_at(found);
  jet.point += found.miss.u * jet.du + found.miss.v * jet.dv;
  if (!jet.point.allFinite()) {
    throw Error(
        ErrorCode::Geometry,
        fmt::format("the limit surface has no tangent plane at ({}, {}) of a chart", uv.u, uv.v));
  }
  if (order == Order::Position) return {jet.point};
  if (order == Order::First) return jet;
  const Bend bend = bend_at(found.place);
  jet.duu = bend.uu * frame_.normal;
  jet.duv = bend.uv * frame_.normal;
  jet.dvv = bend.vv * frame_.normal;
  return jet;
}

/// The place of a point, to first order from where the search has ended.
CagePlace Chart::place(Uv uv) const {
  const Found found = find(uv);
  Uv at = found.place.at;
  if (found.is_inside) {
    const InverseSteps inverse(frame_.step(found.jet.du), frame_.step(found.jet.dv));
    at = pulled_in(unit_, at + inverse(found.miss));
  }
  return cage_place(*faces_[found.place.face].surface, at);
}

std::optional<Vec3> Chart::point_on_faces(Uv uv) const {
  const Found found = find(uv);
  if (!found.is_inside) return std::nullopt;
  return found.jet.point;
}

/// Derivatives by the parameters of a face become those by the coordinates in the plane: at a fixed
/// point of the plane the surface moves along the normal only.
Jet Chart::in_plane(const Jet& jet) const {
  const InverseSteps inverse(frame_.step(jet.du), frame_.step(jet.dv));
  Jet result;
  result.point = jet.point;
  result.du = inverse.row_a.u * jet.du + inverse.row_b.u * jet.dv;
  result.dv = inverse.row_a.v * jet.du + inverse.row_b.v * jet.dv;
  return result;
}

/// Where nothing was found, and where the derivatives next to an extraordinary vertex make a wall
/// of the surface, the slopes of the vertices tell the tangent plane.
Jet Chart::tangent_at(const Found& found) const {
  if (found.is_inside) {
    const Jet jet = in_plane(found.jet);
    const double steepest = std::max(jet.du.squaredNorm(), jet.dv.squaredNorm());
    if (steepest <= 1 + kMostSlope * kMostSlope) return jet;
  }
  const std::array<double, 4> weights = corner_weights(unit_, found.place.at);
  Uv slope{0, 0};
  for (std::size_t i = 0; i < static_cast<std::size_t>(unit_.corner_count()); ++i) {
    slope = slope + weights[i] * slopes_[vertices_[found.place.face][i]];
  }
  return {found.jet.point, frame_.along_u + slope.u * frame_.normal,
          frame_.along_v + slope.v * frame_.normal};
}

Chart::Bend Chart::bend_at(const FacePoint& place) const {
  const std::array<double, 4> weights = corner_weights(unit_, place.at);
  Bend sum;
  for (std::size_t i = 0; i < static_cast<std::size_t>(unit_.corner_count()); ++i) {
    const Bend& bend = bends_[vertices_[place.face][i]];
    sum.uu += weights[i] * bend.uu;
    sum.uv += weights[i] * bend.uv;
    sum.vv += weights[i] * bend.vv;
  }
  return sum;
}

Chart::Found Chart::find(Uv uv) const {
  const Start from = start(uv);
  if (from.is_far_beyond) return look(uv, from.place);
  const Found first = search(uv, from.place);
  if (first.is_inside || !has_cell(uv)) return first;
  // Around an extraordinary vertex derivatives may lead in circles. Then one of the faces there has
  // the point.
  Found best = first;
  const std::size_t cell = row(uv.v) * columns_ + column(uv.u);
  for (std::size_t i = first_[cell]; i < first_[cell + 1] && !best.is_inside; ++i) {
    const Found found = search(uv, {in_cells_[i], middle_of(unit_)});
    if (squared_norm(found.miss) < squared_norm(best.miss)) best = found;
  }
  return best;
}

Chart::Found Chart::look(Uv uv, const FacePoint& place) const {
  const Jet jet = faces_[place.face].surface->evaluate(place.at, Order::First);
  const Uv miss = uv - frame_.project(jet.point);
  return {place, jet, miss, squared_norm(miss) <= kMiss * kMiss * face_size_ * face_size_};
}

/// Newton's method from a place on. Near an extraordinary vertex derivatives may be a few times too
/// small; so a step that leads away is halved.
Chart::Found Chart::search(Uv uv, const FacePoint& from) const {
  Found found = look(uv, from), best = found;
  double share = 1, miss_at_border = std::numeric_limits<double>::infinity();
  int turns = 0, slow_steps = 0;
  for (int step = 0; step < kMostSteps && !found.is_inside; ++step) {
    const Uv wanted =
        InverseSteps(frame_.step(found.jet.du), frame_.step(found.jet.dv))(found.miss);
    if (!std::isfinite(wanted.u) || !std::isfinite(wanted.v)) break;
    const Move move = go(found.place, share * wanted);
    const double miss = squared_norm(found.miss);
    turns = move.is_turn ? turns + 1 : 0;
    if (move.is_along_border) {
      slow_steps += miss > kNearer * miss_at_border ? 1 : 0;
      miss_at_border = miss;
    }
    if (turns > kMostTurns || slow_steps > kMostSlowSteps) break;
    const Found next = look(uv, move.to);
    const bool is_too_far = move.is_within_face && squared_norm(next.miss) > miss;
    share = is_too_far ? share / 2 : std::min(1.0, 2 * share);
    if (!is_too_far) found = next;
    if (squared_norm(found.miss) < squared_norm(best.miss)) best = found;
  }
  return best;
}

/// Go a step within a face, into the neighbour where it leaves the face, or along the border where
/// there is none.
Chart::Move Chart::go(const FacePoint& place, Uv step) const {
  const Exit exit = exit_of(unit_, place.at, step, faces_[place.face]);
  if (exit.side < 0) {
    return {{place.face, pulled_in(unit_, place.at + step)}, false, false, true};
  }
  const ChartFace::Neighbour neighbour =
      faces_[place.face].neighbours[static_cast<std::size_t>(exit.side)];
  if (neighbour.face < 0) {
    return {{place.face, pulled_in(unit_, place.at + step)}, false, true};
  }
  const Uv at_exit = pulled_in(unit_, place.at + exit.share * step);
  const double share = std::clamp(share_of(unit_, exit.side, at_exit), 0.0, 1.0);
  return {{static_cast<std::size_t>(neighbour.face), on_side(unit_, neighbour.side, 1 - share)},
          exit.share == 0};
}

/// A place near a point, which Newton's method starts from.
Chart::Start Chart::start(Uv uv) const {
  if (!std::isfinite(uv.u) || !std::isfinite(uv.v)) {
    throw Error(ErrorCode::Geometry, "a chart is evaluated at a point that is not finite");
  }
  if (has_cell(uv)) {
    const std::size_t cell = row(uv.v) * columns_ + column(uv.u);
    for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i) {
      if (contains(in_cells_[i], uv)) return {place_in(in_cells_[i], uv)};
    }
  }
  return nearest_on_border(uv);
}

/// Sides may bulge beyond the line between their ends, but not by half of their length; and the
/// nearest line may be that of a shorter one.
Chart::Start Chart::nearest_on_border(Uv uv) const {
  Start best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [face, side] : border_) {
    const std::array<Uv, 4>& c = corners_[face];
    const Uv a = c[static_cast<std::size_t>(side)];
    const Uv along = c[static_cast<std::size_t>((side + 1) % unit_.corner_count())] - a;
    const Uv to = uv - a;
    const double share =
        std::clamp((to.u * along.u + to.v * along.v) / squared_norm(along), 0.0, 1.0);
    const double distance = squared_norm(to - share * along);
    if (distance >= least) continue;
    least = distance;
    best = {{face, on_side(unit_, side, share)}, distance > squared_bulge_};
  }
  return best;
}

/// A point on a common side is in one of both faces, whose corners differ by rounding.
bool Chart::contains(std::size_t face, Uv uv) const {
  const std::array<Uv, 4>& c = corners_[face];
  const double rounding = kBeyond * face_size_ * face_size_;
  const std::size_t count = static_cast<std::size_t>(unit_.corner_count());
  for (std::size_t side = 0; side < count; ++side) {
    if (doubled_area(c[side], c[(side + 1) % count], uv) < -rounding) return false;
  }
  return true;
}

/// As if the face were flat.
Chart::FacePoint Chart::place_in(std::size_t face, Uv uv) const {
  const std::array<Uv, 4>& c = corners_[face];
  const bool is_upper = unit_.shape == Domain::Shape::Rectangle &&
                        doubled_area(c[1], c[3], uv) < 0;  // the triangle at corner 2
  const Uv origin = is_upper ? c[2] : c[0];
  const Uv beside_u = is_upper ? c[3] : c[1];
  const Uv beside_v = is_upper ? c[1] : unit_.shape == Domain::Shape::Triangle ? c[2] : c[3];
  const Uv share = InverseSteps(beside_u - origin, beside_v - origin)(uv - origin);
  const Uv at = is_upper ? Uv{1 - share.u, 1 - share.v} : share;
  return {face, pulled_in(unit_, at)};
}

bool Chart::has_cell(Uv uv) const {
  return uv.u >= lower_.u && uv.u <= upper_.u && uv.v >= lower_.v && uv.v <= upper_.v;
}

std::size_t Chart::column(double u) const {
  const double share = (u - lower_.u) / (upper_.u - lower_.u);
  return std::min(static_cast<std::size_t>(std::max(share, 0.0) * static_cast<double>(columns_)),
                  columns_ - 1);
}

std::size_t Chart::row(double v) const {
  const double share = (v - lower_.v) / (upper_.v - lower_.v);
  return std::min(static_cast<std::size_t>(std::max(share, 0.0) * static_cast<double>(rows_)),
                  rows_ - 1);
}

void Chart::sort_into_cells() {
  lower_ = upper_ = corners_[0][0];
  for (const auto& corners : corners_) {
    for (const Uv corner : corners) {
      lower_ = {std::min(lower_.u, corner.u), std::min(lower_.v, corner.v)};
      upper_ = {std::max(upper_.u, corner.u), std::max(upper_.v, corner.v)};
    }
  }
  const double width = upper_.u - lower_.u, height = upper_.v - lower_.v;
  const double count = static_cast<double>(faces_.size());
  const double side = std::sqrt(width * height / count);
  columns_ = static_cast<std::size_t>(std::clamp(width / side, 1.0, count));
  rows_ = static_cast<std::size_t>(std::clamp(height / side, 1.0, count));
  std::vector<std::vector<std::size_t>> in_cells(columns_ * rows_);
  for (std::size_t f = 0; f < corners_.size(); ++f) {
    Uv low = corners_[f][0], high = low;
    for (const Uv corner : corners_[f]) {
      low = {std::min(low.u, corner.u), std::min(low.v, corner.v)};
      high = {std::max(high.u, corner.u), std::max(high.v, corner.v)};
    }
    for (std::size_t j = row(low.v); j <= row(high.v); ++j) {
      for (std::size_t i = column(low.u); i <= column(high.u); ++i) {
        in_cells[j * columns_ + i].push_back(f);
      }
    }
  }
  first_.push_back(0);
  for (const std::vector<std::size_t>& faces : in_cells) {
    in_cells_.insert(in_cells_.end(), faces.begin(), faces.end());
    first_.push_back(in_cells_.size());
  }
}

}  // namespace surfmesh
