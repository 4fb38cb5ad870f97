// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/msh_reader.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/msh_model.hh"
#include "surfmesh/formats/msh_views.hh"
#include "surfmesh/formats/number_scanner.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh {
namespace {

using msh::Model;
using msh::NodeNumbers;
using msh::Shape;

/// Of integers that are not indices in the format's words, and of numbers.
constexpr int kInt = 4, kDouble = 8;

class MshReader {
 public:
  MshReader(std::string_view bytes, const std::string& name)
      : scanner_(bytes, name), model_(name), views_(scanner_) {}

  GridFile run() {
    read_format();
    while (const auto section = next_section()) {
      read_section(*section);
      end_section(*section);
    }
    if (!has_nodes_) fail_whole("the file has no $Nodes");
    GridFile grid = model_.finish(views_.left_out());
    grid.at_points = views_.finish();
    return grid;
  }

 private:
  [[noreturn]] void fail_whole(std::string_view reason) const {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: {}", scanner_.name(), reason));
  }

  /// The name of the next section, without its $.
  std::optional<std::string> next_section() {
    scanner_.set_text();
    const std::string_view word = scanner_.word();
    if (word.empty()) return std::nullopt;
    if (word[0] != '$' || word.starts_with("$End")) {
      scanner_.fail(fmt::format("{} stands where a section begins", surfmesh::quoted(word)));
    }
    scanner_.line();
    return std::string(word.substr(1));
  }

  void end_section(const std::string& section) {
    scanner_.set_text();
    const std::string_view word = scanner_.word();
    if (word == fmt::format("$End{}", section)) return;
    scanner_.fail(word.empty()
                      ? fmt::format("the file ends in ${}, it is cut short", section)
                      : fmt::format("{} stands where ${} ends", surfmesh::quoted(word), section));
  }

  void read_format() {
    const auto section = next_section();
    if (section != "MeshFormat")
      scanner_.fail(
          "no Gmsh file, for it does not begin with "
          "$MeshFormat");
    const std::string version(scanner_.word());
    if (version != "4.1" && version != "2.2" && version != "2" && version != "2.1") {
      scanner_.fail(
          fmt::format("version {} of Gmsh's files is not read; `gmsh -save -format "
                      "msh41` writes 4.1",
                      surfmesh::quoted(version)));
    }
    is_4_ = version == "4.1";
    const std::int64_t is_binary = scanner_.integer(kInt, "the kind of the file");
    const std::int64_t size = scanner_.integer(kInt, "the size of numbers");
    if (is_binary != 0 && is_binary != 1) scanner_.fail("the kind of the file is not 0 or 1");
    if (size != 4 && size != 8) scanner_.fail("the size of numbers is not 4 or 8");
    index_size_ = static_cast<int>(size);
    scanner_.line();
    if (is_binary == 1) read_byte_order();
    end_section("MeshFormat");
  }

  void read_byte_order() {
    const std::size_t start = scanner_.offset();
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      scanner_.go_to(start);
      scanner_.set_binary(order);
      if (scanner_.integer(kInt, "one") == 1) {
        order_ = order;
        return;
      }
    }
    scanner_.fail("the byte order is neither little nor big");
  }

  /// Numbers are read as the header says from here.
  void begin_numbers() {
    if (order_) scanner_.set_binary(*order_);
  }

  void read_section(const std::string& section) {
    if (section == "PhysicalNames") return read_physical_names();
    if (section == "NodeData") {
      const auto begin = [this] { begin_numbers(); };
      return views_.read_at_nodes(begin, model_.numbers());
    }
    if (section == "ElementNodeData") {
      const auto begin = [this] { begin_numbers(); };
      return views_.read_at_element_nodes(begin, model_);
    }
    if (section == "ElementData") views_.leave_out("views with values of elements");
    if (section == "Nodes") {
      has_nodes_ = true;
      return is_4_ ? read_nodes_4() : read_nodes_2();
    }
    if (section == "Elements") return is_4_ ? read_elements_4() : read_elements_2();
    if (section == "Entities" && is_4_) return read_entities();
    skip_section(section);
  }

  /// Go to the end of a section whose contents are of no use here.
  void skip_section(const std::string& section) {
    const std::size_t end =
        scanner_.bytes().find(fmt::format("$End{}", section), scanner_.offset());
    if (end == std::string_view::npos) {
      scanner_.fail(fmt::format("${} does not end, the file is cut short", section));
    }
    scanner_.go_to(end);
  }

  void read_physical_names() {
    const std::size_t count = scanner_.count(kInt, 1, "the number of names");
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t dimension = scanner_.integer(kInt, "the dimension of a name");
      const std::int64_t tag = scanner_.integer(kInt, "the tag of a name");
      std::string_view line = scanner_.line();
      const std::size_t first = line.find('"'), last = line.rfind('"');
      if (first == last) scanner_.fail("a name has no quotes");
      model_.add_name(dimension, tag, std::string(line.substr(first + 1, last - first - 1)));
    }
  }

  Vec3 read_point() {
    Vec3 point;
    for (int k = 0; k < 3; ++k) point[k] = scanner_.finite(kDouble, "a coordinate");
    return point;
  }

  void read_nodes_2() {
    const std::size_t count = scanner_.count(kInt, 8, "the number of nodes");
    if (order_) scanner_.line();
    begin_numbers();
    model_.reserve_nodes(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t tag = scanner_.integer(kInt, "the number of a node");
      model_.add_node(tag, read_point());
    }
    finish_nodes();
  }

  void finish_nodes() {
    if (!model_.finish_nodes()) fail_whole("two nodes have the same number");
  }

  void read_nodes_4() {
    begin_numbers();
    const std::size_t blocks = scanner_.count(index_size_, 1, "the number of blocks of nodes");
    const std::size_t count = scanner_.count(index_size_, 8, "the number of nodes");
    scanner_.integer(index_size_, "the least number of a node");
    scanner_.integer(index_size_, "the greatest number of a node");
    model_.reserve_nodes(count);
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::int64_t dimension = scanner_.integer(kInt, "the dimension of an entity");
      scanner_.integer(kInt, "the tag of an entity");
      const bool has_parameters = scanner_.integer(kInt, "whether nodes are parametric") != 0;
      const std::size_t size = scanner_.count(index_size_, 1, "the number of nodes of a block");
      std::vector<std::int64_t> tags(size);
      for (std::int64_t& tag : tags) tag = scanner_.integer(index_size_, "the number of a node");
      for (const std::int64_t tag : tags) {
        model_.add_node(tag, read_point());
        for (std::int64_t k = 0; has_parameters && k < dimension && k < 3; ++k) {
          scanner_.number(kDouble, "a parameter of a node");
        }
      }
    }
    finish_nodes();
  }

  void read_entities() {
    begin_numbers();
    std::array<std::size_t, 4> counts;
    for (std::size_t& count : counts) {
      count = scanner_.count(index_size_, 1, "the number of entities");
    }
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (std::size_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
        read_entity(dimension);
      }
    }
  }

  void read_entity(int dimension) {
    const std::int64_t tag = scanner_.integer(kInt, "the tag of an entity");
    for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) {
      scanner_.number(kDouble, "a coordinate of an entity");
    }
    std::vector<std::int64_t> physicals(
        scanner_.count(index_size_, 2, "the number of physical groups"));
    for (std::int64_t& physical : physicals) {
      physical = scanner_.integer(kInt, "the tag of a physical group");
    }
    model_.add_entity(dimension, tag, physicals);
    if (dimension == 0) return;
    const std::size_t bounds = scanner_.count(index_size_, 2, "the number of bounding entities");
    for (std::size_t k = 0; k < bounds; ++k) scanner_.integer(kInt, "the tag of an entity");
  }

  Shape read_shape() {
    const std::int64_t type = scanner_.integer(kInt, "the type of an element");
    const auto shape = msh::shape_of(type);
    if (!shape) scanner_.fail(fmt::format("the type {} of an element is not known", type));
    return *shape;
  }

  /// The nodes of an element, as indices.
  void read_element_nodes(const Shape& shape, int size) {
    nodes_.clear();
    for (int k = 0; k < shape.nodes; ++k) {
      const std::int64_t tag = scanner_.integer(size, "a node of an element");
      const int node = model_.numbers().index(tag);
      if (node < 0)
        scanner_.fail(fmt::format("an element has the node {}, which is not there", tag));
      nodes_.push_back(node);
    }
  }

  void need_nodes() {
    if (!has_nodes_) scanner_.fail("$Elements stand before $Nodes");
  }

  void read_elements_4() {
    need_nodes();
    begin_numbers();
    const std::size_t blocks = scanner_.count(index_size_, 1, "the number of blocks of elements");
    scanner_.count(index_size_, 1, "the number of elements");
    scanner_.integer(index_size_, "the least number of an element");
    scanner_.integer(index_size_, "the greatest number of an element");
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::int64_t dimension = scanner_.integer(kInt, "the dimension of an entity");
      const std::int64_t entity = scanner_.integer(kInt, "the tag of an entity");
      const Shape shape = read_shape();
      const std::size_t size = scanner_.count(index_size_, 1, "the number of elements of a block");
      if (dimension != shape.dimension) {
        scanner_.fail("elements of a block are not of the dimension of its entity");
      }
      for (std::size_t i = 0; i < size; ++i) {
        const std::int64_t tag = scanner_.integer(index_size_, "the number of an element");
        read_element_nodes(shape, index_size_);
        model_.add_element(tag, shape, nodes_, entity, 0);
      }
    }
  }

  /// Tags are the physical group and the entity, and numbers of partitions.
  void read_element_2(std::int64_t tag, const Shape& shape, std::int64_t tags) {
    std::int64_t physical = 0, entity = 0;
    for (std::int64_t k = 0; k < tags; ++k) {
      const std::int64_t value = scanner_.integer(kInt, "a tag of an element");
      if (k == 0) physical = value;
      if (k == 1) entity = value;
    }
    read_element_nodes(shape, kInt);
    model_.add_element(tag, shape, nodes_, entity, physical);
  }

  void read_elements_2() {
    need_nodes();
    std::size_t count = scanner_.count(kInt, 4, "the number of elements");
    if (!order_) {
      for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t tag = scanner_.integer(kInt, "the number of an element");
        const Shape shape = read_shape();
        read_element_2(tag, shape, scanner_.integer(kInt, "the number of tags"));
      }
      return;
    }
    scanner_.line();
    begin_numbers();
    while (count > 0) {
      const Shape shape = read_shape();
      const std::size_t size = scanner_.count(kInt, 4, "the number of elements of a block");
      const std::int64_t tags = scanner_.integer(kInt, "the number of tags");
      if (size == 0 || size > count) scanner_.fail("blocks have other numbers of elements in all");
      for (std::size_t i = 0; i < size; ++i) {
        const std::int64_t tag = scanner_.integer(kInt, "the number of an element");
        read_element_2(tag, shape, tags);
      }
      count -= size;
    }
  }

  NumberScanner scanner_;
  Model model_;
  msh::Views views_;
  bool is_4_ = false;
  int index_size_ = kDouble;
  std::optional<std::endian> order_;  ///< of a binary file
  bool has_nodes_ = false;
  std::vector<int> nodes_;
};

}  // namespace

GridFile parse_msh_grid(std::string bytes, const std::string& name) {
  return MshReader(bytes, name).run();
}

}  // namespace surfmesh
