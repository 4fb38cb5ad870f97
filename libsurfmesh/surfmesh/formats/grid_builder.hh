// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/formats/grid_file.hh"

namespace surfmesh {

/// What readers of grids make of cells. Vertices that are given to it are in range.
class GridBuilder {
 public:
  /// `name` is for messages.
  explicit GridBuilder(std::string name) : name_(std::move(name)) {}

  /// Add a face, which belongs to the patch with this number in the file.
  ///
  /// Returns  false if it is left out, as it has no three different vertices
  /// Throws   InvalidInput for a vertex that comes twice but not in a row
  bool add_face(std::span<const int> vertices, std::int64_t reference);

  /// Add a side that belongs to the contour with this number in the file.
  void add_side(int from, int to, std::int64_t reference);

  void add_tetrahedron(const std::array<int, 4>& vertices) { grid.tetrahedra.push_back(vertices); }

  /// Note a part of the file that is not read, "points": the words of all of a kind are the same.
  void leave_out(const std::string& what, std::size_t count = 1) { left_out_[what] += count; }

  /// Note what an element of higher order has beside its corners.
  void leave_out_middles() { leave_out("nodes on sides of elements of higher order"); }

  /// The numbers of patches as they are in the file, by face.
  std::span<const std::int64_t> references() const { return references_; }

  /// Make patches of the numbers in the file, as index_numbers does; `none` is that of no patch. If
  /// all are, there are no patches.
  ///
  /// Returns  the numbers in the file, by patch
  std::vector<std::int64_t> number_patches(std::int64_t none);

  /// Make contours of the sides that are sides of faces, likewise.
  ///
  /// Returns  the numbers in the file, by contour
  std::vector<std::int64_t> number_contours();

  /// The grid, with the notices of what was left out.
  GridFile finish();

  GridFile grid;

 private:
  struct Side {
    int from;
    int to;
    std::int64_t reference;
  };

  std::string name_;
  std::vector<std::int64_t> references_;
  std::vector<Side> sides_;
  std::map<std::string, std::size_t> left_out_;
  std::vector<int> corners_;
  std::size_t face_count_ = 0;
  std::size_t mended_ = 0;
};

/// Replace numbers by indices: numbers that count from 1, with few gaps, by those that count from
/// 0, as write_mesh numbers patches and contours; others by their ranks. `none` becomes -1.
///
/// Returns  the numbers, by index
std::vector<std::int64_t> index_numbers(std::span<const std::int64_t> numbers, std::int64_t none,
                                        std::vector<int>& indices);

}  // namespace surfmesh
