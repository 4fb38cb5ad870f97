// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "surfmesh/formats/grid_file.hh"
#include "surfmesh/formats/msh_model.hh"
#include "surfmesh/formats/number_scanner.hh"

namespace surfmesh::msh {

/// Reads the views of a Gmsh file: values at nodes.
class Views {
 public:
  /// The scanner must outlive this.
  explicit Views(NumberScanner& scanner) : scanner_(scanner) {}

  /// Read $NodeData or $ElementNodeData; `begin` is called where numbers are binary from, if they
  /// are. Of a view with several time steps the last is kept.
  void read_at_nodes(const std::function<void()>& begin, const NodeNumbers& nodes);
  /// Values of elements at a node are averaged.
  void read_at_element_nodes(const std::function<void()>& begin, Model& model);

  /// What is not read, with how much there is.
  const std::map<std::string, std::size_t>& left_out() const { return left_out_; }
  void leave_out(const std::string& what) { ++left_out_[what]; }

  /// The values by node: NaN where a view has none.
  std::vector<GridValues> finish();

 private:
  struct Header {
    std::string name;
    int components = 1;
    std::size_t count = 0;
  };

  Header read_header();
  /// The values of a view, all NaN or 0.
  GridValues& view_of(const Header& header, std::size_t nodes, double value);

  NumberScanner& scanner_;
  std::vector<GridValues> views_;
  std::size_t numbers_ = 0;  ///< for which views made room
  std::map<std::string, std::size_t> left_out_;
};

}  // namespace surfmesh::msh
