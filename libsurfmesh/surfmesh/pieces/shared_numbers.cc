// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/shared_numbers.hh"

#include <algorithm>
#include <map>
#include <utility>

namespace surfmesh {
namespace {

/// By number, those of vertices of the model and of nodes on contours.
std::vector<Vec3> contour_points(const Model& model, const std::vector<ContourNodes>& nodes,
                                 const NodeNumbers& numbers) {
  std::vector<Vec3> points(static_cast<std::size_t>(numbers.contour_count()), Vec3::Zero());
  for (std::size_t v = 0; v < model.vertices.size(); ++v) points[v] = model.vertices[v].position;
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    for (int i = 1; i < nodes[c].segment_count(); ++i) {
      points[static_cast<std::size_t>(numbers(static_cast<int>(c), i))] =
          nodes[c].points[static_cast<std::size_t>(i)];
    }
  }
  return points;
}

/// Call `visit(number)` for the vertices of a boundary that other tiles may have.
template <class Visit>
void for_each_shared(const PatchBoundary& boundary, Visit visit) {
  for (const BoundaryLoop& loop : boundary.loops) {
    for (const BoundaryNode& node : loop) {
      if (node.vertex >= 0) visit(node.vertex);
    }
  }
  for (const PoleFan& fan : boundary.fans) visit(fan.pole);
}

}  // namespace

SharedNumbers::SharedNumbers(const Model& model, const std::vector<ContourNodes>& nodes,
                             const NodeNumbers& numbers,
                             const std::vector<const PatchBoundary*>& boundaries,
                             const std::vector<int>& piece_of,
                             const std::vector<int>& rank_of_piece)
    : ids_(static_cast<std::size_t>(numbers.count()), -1),
      points_(contour_points(model, nodes, numbers)),
      neighbours_(rank_of_piece.size()) {
  std::vector<Place> places;
  for (std::size_t t = 0; t < boundaries.size(); ++t) {
    for_each_shared(*boundaries[t], [&](int number) {
      ids_[static_cast<std::size_t>(number)] = 0;
      places.push_back({number, piece_of[t]});
    });
  }
  for (std::int64_t& id : ids_) {
    if (id == 0) id = count_++;
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  collect_neighbours(places, rank_of_piece);
}

void SharedNumbers::collect_neighbours(const std::vector<Place>& places,
                                       const std::vector<int>& rank_of_piece) {
  const auto rank_of = [&](const Place& place) {
    return rank_of_piece[static_cast<std::size_t>(place.piece)];
  };
  std::map<std::pair<int, int>, std::vector<int>> numbers_of;  // by piece and the other one
  for (auto first = places.begin(); first != places.end();) {
    const auto last = std::find_if(
        first, places.end(), [first](const Place& place) { return place.number != first->number; });
    if (last - first > 1) ++of_several_pieces_;
    if (std::any_of(first, last, [&](const Place& at) { return rank_of(at) != rank_of(*first); })) {
      ++of_several_ranks_;
    }
    for (auto a = first; a != last; ++a) {
      for (auto b = first; b != last; ++b) {
        if (a != b) numbers_of[{a->piece, b->piece}].push_back(a->number);
      }
    }
    first = last;
  }
  for (auto& [pieces, numbers] : numbers_of) {
    neighbours_[static_cast<std::size_t>(pieces.first)].push_back(
        {pieces.second, std::move(numbers)});
  }
}

}  // namespace surfmesh
