// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/nurbs_net.hh"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string_view>

#include "surfmesh/core/error.hh"
#include "surfmesh/nurbs/full_knots.hh"

namespace surfmesh {
namespace {

using Fault = std::optional<NurbsFault>;

/// One direction, and how faults name it.
struct Direction {
  int degree;
  const std::vector<double>& knots;
  int point_count;
  bool is_periodic;
  std::string degree_path;
  std::string knots_path;
  std::string_view along;  ///< " along u", or empty
};

Fault count_fault(const Direction& d) {
  if (d.degree < 1 || d.degree > kMostDegree) {
    return NurbsFault{d.degree_path, fmt::format("a degree must be from 1 to {}", kMostDegree)};
  }
  const int least = d.is_periodic ? 2 : d.degree + 1;
  if (d.point_count < least) {
    return NurbsFault{"points", fmt::format("degree {}{} needs at least {} points, here are {}",
                                            d.degree, d.along, least, d.point_count)};
  }
  const int wanted = d.is_periodic ? d.point_count + 1 : d.point_count + d.degree + 1;
  if (static_cast<int>(d.knots.size()) == wanted) return {};
  const char* rule = d.is_periodic ? "points + 1, as it is periodic" : "points + degree + 1";
  return NurbsFault{d.knots_path,
                    fmt::format("{} points of degree {}{} need {} knots ({}), here are {}",
                                d.point_count, d.degree, d.along, wanted, rule, d.knots.size())};
}

Fault order_fault(const Direction& d) {
  for (std::size_t i = 0; i < d.knots.size(); ++i) {
    const std::string path = fmt::format("{}/{}", d.knots_path, i);
    if (!std::isfinite(d.knots[i])) return NurbsFault{path, "a knot must be finite"};
    if (i > 0 && d.knots[i] < d.knots[i - 1]) {
      return NurbsFault{
          path, fmt::format("a knot must not be smaller than the one before, {}", d.knots[i - 1])};
    }
  }
  return {};
}

/// True for a knot at an end of the surface, which may be there once more than others.
bool is_end(const FullKnots& all, double knot) {
  return all.period == 0 && (knot <= all.from() || knot >= all.to());
}

Fault multiplicity_fault(const Direction& d) {
  const FullKnots all = full_knots(d.knots, d.degree, d.is_periodic);
  if (!(all.to() > all.from())) {
    return NurbsFault{d.knots_path, "the knots must not all be equal, those beside the ends apart"};
  }
  int run = 1;
  for (int i = 1; i < static_cast<int>(all.knots.size()); ++i) {
    run = all[i] == all[i - 1] ? run + 1 : 1;
    if (run <= d.degree + (is_end(all, all[i]) ? 1 : 0)) continue;
    const int given = d.is_periodic ? (i - d.degree) % d.point_count : i;
    return NurbsFault{
        fmt::format("{}/{}", d.knots_path, given < 0 ? given + d.point_count : given),
        run > d.degree + 1
            ? fmt::format("a knot may be there {} times at most, as the degree is {}", d.degree + 1,
                          d.degree)
            : fmt::format("a knot inside may be there {} times at most, as the degree is {}; with "
                          "one more, there is a jump: divide it",
                          d.degree, d.degree)};
  }
  return {};
}

Fault direction_fault(const Direction& direction) {
  if (Fault fault = count_fault(direction)) return fault;
  if (Fault fault = order_fault(direction)) return fault;
  return multiplicity_fault(direction);
}

Fault row_fault(const NurbsNet& net) {
  if (net.points.empty()) return NurbsFault{"points", "there must be points"};
  const std::size_t length = net.points.front().size();
  for (std::size_t j = 0; j < net.points.size(); ++j) {
    const std::string path = fmt::format("points/{}", j);
    if (net.points[j].size() != length) {
      return NurbsFault{path, fmt::format("this row has {} points, the first one {}",
                                          net.points[j].size(), length)};
    }
    for (std::size_t i = 0; i < length; ++i) {
      if (!net.points[j][i].allFinite()) {
        return NurbsFault{fmt::format("{}/{}", path, i), "a point must be finite"};
      }
    }
  }
  return {};
}

Fault weight_fault(const std::vector<double>& weights, std::size_t wanted,
                   const std::string& path) {
  if (weights.size() != wanted) {
    return NurbsFault{path, fmt::format("there must be a weight for each of {} points, here are {}",
                                        wanted, weights.size())};
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (std::isfinite(weights[i]) && weights[i] > 0) continue;
    return NurbsFault{fmt::format("{}/{}", path, i), "a weight must be finite and above 0"};
  }
  return {};
}

Fault weight_fault(const NurbsNet& net) {
  if (net.weights.empty()) return {};
  if (net.weights.size() != net.points.size()) {
    return NurbsFault{"weights", fmt::format("there must be a row for each of {} rows of points, "
                                             "here are {}",
                                             net.points.size(), net.weights.size())};
  }
  for (std::size_t j = 0; j < net.weights.size(); ++j) {
    const std::string path = fmt::format("weights/{}", j);
    if (Fault fault = weight_fault(net.weights[j], net.points[j].size(), path)) return fault;
  }
  return {};
}

template <class Input>
void throw_fault(const Input& input) {
  const Fault fault = find_fault(input);
  if (!fault) return;
  throw Error(ErrorCode::InvalidInput, fmt::format("{}: {}", fault->path, fault->text));
}

}  // namespace

std::optional<NurbsFault> find_fault(const NurbsNet& net) {
  if (Fault fault = row_fault(net)) return fault;
  const auto across = static_cast<int>(net.points.front().size());
  if (Fault fault = direction_fault({net.degree[0], net.knots[0], across, net.periodic[0],
                                     "degree/0", "knots/0", " along u"})) {
    return fault;
  }
  if (Fault fault =
          direction_fault({net.degree[1], net.knots[1], static_cast<int>(net.points.size()),
                           net.periodic[1], "degree/1", "knots/1", " along v"})) {
    return fault;
  }
  return weight_fault(net);
}

std::optional<NurbsFault> find_fault(const NurbsPolygon& polygon) {
  for (std::size_t i = 0; i < polygon.points.size(); ++i) {
    if (std::isfinite(polygon.points[i].u) && std::isfinite(polygon.points[i].v)) continue;
    return NurbsFault{fmt::format("points/{}", i), "a point must be finite"};
  }
  if (Fault fault =
          direction_fault({polygon.degree, polygon.knots, static_cast<int>(polygon.points.size()),
                           polygon.periodic, "degree", "knots", ""})) {
    return fault;
  }
  if (polygon.weights.empty()) return {};
  return weight_fault(polygon.weights, polygon.points.size(), "weights");
}

void check(const NurbsNet& net) { throw_fault(net); }
void check(const NurbsPolygon& polygon) { throw_fault(polygon); }

}  // namespace surfmesh
