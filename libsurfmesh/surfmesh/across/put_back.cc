// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/put_back.hh"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "surfmesh/across/face_order.hh"
#include "surfmesh/across/returning_region.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"

namespace surfmesh {
namespace {

/// Numbers of elements of one kind for those that regions could not number themselves: such as
/// other regions have given up, then new ones.
class SpareNumbers {
 public:
  explicit SpareNumbers(std::size_t count) : bound_(count) {}

  void add(const std::vector<int>& given_up) {
    free_.insert(free_.end(), given_up.begin(), given_up.end());
  }

  int take() {
    if (free_.empty()) return static_cast<int>(bound_++);
    const int number = free_.back();
    free_.pop_back();
    return number;
  }

  /// All numbers in use are below this.
  std::size_t bound() const { return bound_; }

  /// Call `move(from, to)` for elements that take the place of such as are gone: the last ones.
  template <class Move>
  void close_gaps(Move move) {
    // The greatest first: then the last element is never one that is gone.
    std::sort(free_.begin(), free_.end(), std::greater<>());
    for (const int gap : free_) {
      const int last = static_cast<int>(--bound_);
      if (last != gap) move(last, gap);
    }
    free_.clear();
  }

 private:
  std::size_t bound_;
  std::vector<int> free_;
};

class PutBack {
 public:
  PutBack(std::span<ReturningRegion> regions, PolyMesh& result)
      : regions_(regions),
        result_(result),
        patch_of_(require(result, keys::face_patch)),
        contour_of_(require(result, keys::edge_contour)),
        uv_of_(require(result, keys::corner_uv)),
        metric_of_(require(result, keys::corner_metric)),
        beyond_(attach_if_new(result)),
        vertices_(result.n_vertices()),
        edges_(result.n_edges()),
        is_taken_(result.n_faces(), 0) {}

  PutBackReport run() {
    share_indices(regions_.size(), [this](std::size_t r) {
      for (const FaceHandle fh : regions_[r].taken()) is_taken_[index(fh)] = 1;
    });
    number_rest();
    const FaceOrder order(result_, is_taken_, regions_);
    result_.resize(std::max(result_.n_vertices(), vertices_.bound()),
                   std::max(result_.n_edges(), edges_.bound()),
                   std::max(result_.n_faces(), order.count()));
    report_.places.resize(result_.n_vertices());
    write_faces(order);
    close_gaps();
    report_.places.resize(vertices_.bound());
    result_.resize(vertices_.bound(), edges_.bound(), order.count());
    return std::move(report_);
  }

 private:
  static decltype(keys::corner_beyond)::Handle attach_if_new(PolyMesh& result) {
    const auto handle = find(result, keys::corner_beyond);
    return handle.is_valid() ? handle : attach(result, keys::corner_beyond, 0);
  }

  void number_rest() {
    for (const ReturningRegion& region : regions_) {
      vertices_.add(region.vertices().given_up);
      edges_.add(region.edges().given_up);
    }
    for (ReturningRegion& region : regions_) {
      for (const int v : region.vertices().wanting) {
        region.set_number(VertexHandle(v), vertices_.take());
      }
      for (const int e : region.edges().wanting) region.set_number(EdgeHandle(e), edges_.take());
    }
  }

  /// Regions and runs of faces write to different elements, so that all may be written at once. The
  /// halfedges of the faces wait, for the place of a face may still be that of another one.
  void write_faces(const FaceOrder& order) {
    const auto sides = std::make_unique_for_overwrite<int[]>(order.count());
    share_indices(regions_.size(), [&](std::size_t r) {
      write_region(regions_[r], order.numbers_of(r), sides.get());
      write_vertices(regions_[r]);
    });
    share_indices(order.runs().size(),
                  [&](std::size_t i) { number_run(order.runs()[i], sides.get()); });
    share_ranges(order.count(), [&](std::size_t first, std::size_t end) {
      for (std::size_t f = first; f < end; ++f) {
        result_.set_halfedge_handle(FaceHandle(static_cast<int>(f)), HalfedgeHandle(sides[f]));
      }
    });
    write_patches(order.first_of_patches());
  }

  void write_region(const ReturningRegion& region, std::map<int, std::size_t> numbers, int* sides) {
    region.for_each_face([&](int patch, std::span<const ReturningCorner> corners) {
      const std::size_t number = numbers[patch]++;
      sides[number] = region.in_result(corners.front().side).idx();
      const ReturningCorner* before = &corners.back();
      for (const ReturningCorner& corner : corners) {
        link(region, *before, corner, FaceHandle(static_cast<int>(number)));
        write_corner(corner, region.in_result(before->side));
        before = &corner;
      }
    });
  }

  /// Let the side that leaves a corner of a face be followed by that of the next one.
  void link(const ReturningRegion& region, const ReturningCorner& corner,
            const ReturningCorner& next, FaceHandle fh) {
    const HalfedgeHandle side = region.in_result(corner.side);
    const HalfedgeHandle next_side = region.in_result(next.side);
    const VertexHandle between = region.in_result(next.vertex);
    result_.set_vertex_handle(side, between);
    result_.set_face_handle(side, fh);
    result_.set_next_halfedge_handle(side, next_side);
    if (next.is_inner) result_.set_halfedge_handle(between, next_side);
    if (region.is_new(corner.side)) result_.property(contour_of_, result_.edge_handle(side)) = -1;
  }

  /// `into` leads to the corner.
  void write_corner(const ReturningCorner& corner, HalfedgeHandle into) {
    result_.property(uv_of_, into) = corner.uv;
    result_.property(metric_of_, into) = corner.metric;
    result_.property(beyond_, into) = corner.is_beyond ? 1 : 0;
  }

  void write_vertices(const ReturningRegion& region) {
    for (const MovedVertex& moved : region.moved()) {
      const VertexHandle vh = region.in_result(moved.vertex);
      result_.set_point(vh, to_openmesh(moved.point));
      report_.places[index(vh)] = moved.place;
    }
    for (const auto& [vh, side] : region.relinked()) result_.set_halfedge_handle(vh, side);
  }

  void number_run(const FaceRun& run, int* sides) {
    std::size_t number = run.number;
    for (std::size_t f = run.first; f < run.end; ++f) {
      if (is_taken_[f] != 0) continue;
      const FaceHandle before(static_cast<int>(f)), now(static_cast<int>(number));
      sides[number++] = result_.halfedge_handle(before).idx();
      if (now == before) continue;
      for_each_corner(result_, before,
                      [&](HalfedgeHandle heh) { result_.set_face_handle(heh, now); });
    }
  }

  void write_patches(const std::vector<std::size_t>& first_of_patches) {
    auto& patches = result_.property(patch_of_).data_vector();
    share_indices(first_of_patches.size() - 1, [&](std::size_t p) {
      std::fill(patches.begin() + static_cast<std::ptrdiff_t>(first_of_patches[p]),
                patches.begin() + static_cast<std::ptrdiff_t>(first_of_patches[p + 1]),
                static_cast<int>(p));
    });
  }

  void close_gaps() {
    vertices_.close_gaps([this](int from, int to) {
      const VertexHandle last(from), gap(to);
      detail::renumber_element(result_, last, gap);
      result_.set_point(gap, result_.point(last));
      report_.places[index(gap)] = report_.places[index(last)];
      report_.numbers.emplace(from, to);
    });
    edges_.close_gaps([this](int from, int to) {
      const EdgeHandle last(from), gap(to);
      detail::renumber_element(result_, last, gap);
      result_.copy_all_properties(last, gap, true);
      for (const unsigned k : {0u, 1u}) {
        result_.copy_all_properties(result_.halfedge_handle(last, k),
                                    result_.halfedge_handle(gap, k), true);
      }
    });
  }

  std::span<ReturningRegion> regions_;
  PolyMesh& result_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::edge_contour)::Handle contour_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  decltype(keys::corner_metric)::Handle metric_of_;
  decltype(keys::corner_beyond)::Handle beyond_;
  SpareNumbers vertices_, edges_;
  std::vector<char> is_taken_;  ///< by face of the result
  PutBackReport report_;
};

}  // namespace

PutBackReport put_back(std::span<ReturningRegion> regions, PolyMesh& result) {
  return PutBack(regions, result).run();
}

}  // namespace surfmesh
