// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "surfmesh/formats/grid_builder.hh"

/// The parts of Gmsh's files, and what becomes of them.
namespace surfmesh::msh {

/// A type of elements: its corners come first among its nodes.
struct Shape {
  int dimension;
  int corners;
  int nodes;
};

/// Nothing for a type that Gmsh does not document.
std::optional<Shape> shape_of(std::int64_t type);

/// Numbers in a file, which may be any, to indices.
class NodeNumbers {
 public:
  void reserve(std::size_t count) { numbers_.reserve(count); }
  void add(std::int64_t number) { numbers_.push_back(number); }

  /// To call when all are there. Returns false if a number is there twice: the first one counts.
  bool finish();

  /// -1 for a number that is not there.
  int index(std::int64_t number) const;

  std::size_t size() const { return numbers_.size(); }

 private:
  std::vector<std::int64_t> numbers_;
  std::vector<int> dense_;  ///< by number, where these are nearly as many as the greatest
  std::unordered_map<std::int64_t, int> sparse_;
};

/// Takes entities, nodes and elements, and makes a grid of them.
class Model {
 public:
  explicit Model(std::string name) : builder_(std::move(name)) {}

  void add_name(std::int64_t dimension, std::int64_t physical, std::string name);
  void add_entity(int dimension, std::int64_t tag, std::span<const std::int64_t> physicals);

  void reserve_nodes(std::size_t count);
  void add_node(std::int64_t number, const Vec3& point);
  /// Returns  false if two nodes have the same number
  bool finish_nodes() { return numbers_.finish(); }
  const NodeNumbers& numbers() const { return numbers_; }

  /// `physical` is a group of the element itself, where the format has that in place of groups of
  /// entities: an element in several groups is then there several times. 0 is none.
  void add_element(std::int64_t number, const Shape& shape, std::span<const int> nodes,
                   std::int64_t entity, std::int64_t physical);

  /// The nodes of an element of any kind, by its number; empty for none. No elements are added
  /// after the first call.
  std::span<const int> nodes_of(std::int64_t number);

  /// `left_out` is what is not read of the file besides, with how much of that there is.
  GridFile finish(const std::map<std::string, std::size_t>& left_out);

 private:
  struct Element {
    std::int64_t number;
    std::int64_t entity;
    std::int64_t physical;
    std::size_t first;  ///< of its nodes
    Shape shape;
  };

  /// What is a patch: an entity, and physical groups.
  using Part = std::pair<std::int64_t, std::set<std::int64_t>>;

  std::span<const int> corners(const Element& element) const {
    return {nodes_.data() + element.first, static_cast<std::size_t>(element.shape.corners)};
  }

  Part part_of(const Element& element) const;
  std::map<const Element*, std::set<std::int64_t>> join_repeated(std::set<const Element*>& again);
  std::string name_of_group(std::int64_t physical) const;
  void build_faces();
  void name_groups(std::span<const std::int64_t> numbers,
                   const std::map<std::int64_t, Part>& parts);
  void build_sides();
  void build_others();

  GridBuilder builder_;
  NodeNumbers numbers_;
  std::vector<Element> elements_;
  std::vector<int> nodes_;       ///< of the elements, as indices
  NodeNumbers element_numbers_;  ///< made when they are asked for
  bool is_numbered_ = false;
  std::map<std::pair<std::int64_t, std::int64_t>, std::string> names_;
  std::map<std::pair<int, std::int64_t>, std::set<std::int64_t>> groups_;  ///< of entities
};

}  // namespace surfmesh::msh
