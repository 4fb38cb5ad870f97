// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/medit_reader.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/grid_builder.hh"
#include "surfmesh/formats/number_scanner.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh {
namespace {

/// The codes of keywords in binary files (libMeshb) that are read.
constexpr std::array<std::pair<std::string_view, int>, 9> kCodes = {{{"Dimension", 3},
                                                                     {"Vertices", 4},
                                                                     {"Edges", 5},
                                                                     {"Triangles", 6},
                                                                     {"Quadrilaterals", 7},
                                                                     {"Tetrahedra", 8},
                                                                     {"Hexahedra", 10},
                                                                     {"End", 54},
                                                                     {"SolAtVertices", 62}}};

/// Beyond the keywords that are read, those whose elements are told as left out.
constexpr std::array<std::string_view, 4> kSolids = {"Hexahedra", "Prisms", "Pyramids",
                                                     "TetrahedraP2"};

/// Kinds of values in a .sol file.
enum class ValueKind { Scalar = 1, Vector = 2, SymmetricTensor = 3, Tensor = 4 };

/// Goes from keyword to keyword of a text or binary file.
class KeywordReader {
 public:
  KeywordReader(std::string_view bytes, const std::string& name)
      : scanner_(bytes, name, NumberScanner::Comments::Hash) {
    if (!begin_binary()) begin_text();
  }

  /// The next keyword, "27" for one of a binary file that has no name here; empty at the end.
  std::string next() {
    std::string word = scanner_.is_binary() ? next_of_binary() : next_of_text();
    return word == "End" ? "" : word;
  }

  void read_dimension() {
    dimension_ = static_cast<int>(kind("the dimension"));
    if (dimension_ != 2 && dimension_ != 3) scanner_.fail("the dimension is not 2 or 3");
  }

  int dimension() const {
    if (dimension_ == 0) scanner_.fail("no Dimension stands before this");
    return dimension_;
  }

  std::size_t count(std::size_t least, std::string_view what) {
    return scanner_.count(integer_size_, least, what);
  }
  std::int64_t integer(std::string_view what) { return scanner_.integer(integer_size_, what); }
  /// What has four bytes in binary files of all versions (libMeshb).
  std::int64_t kind(std::string_view what) { return scanner_.integer(sizeof(std::int32_t), what); }
  bool is_text() const { return !scanner_.is_binary(); }
  double number(std::string_view what) { return scanner_.number(number_size_, what); }
  double finite(std::string_view what) { return scanner_.finite(number_size_, what); }
  [[noreturn]] void fail(std::string_view reason) const { scanner_.fail(reason); }

 private:
  /// Binary files begin with an integer 1, in their byte order, and the version.
  bool begin_binary() {
    if (scanner_.rest() < 2 * sizeof(std::int32_t)) return false;
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      scanner_.set_binary(order);
      scanner_.go_to(0);
      if (scanner_.integer(4, "one") != 1) continue;
      set_version(scanner_.integer(4, "the version"));
      integer_size_ = version_ >= 4 ? 8 : 4;
      number_size_ = version_ >= 2 ? 8 : 4;
      return true;
    }
    scanner_.set_text();
    scanner_.go_to(0);
    return false;
  }

  void begin_text() {
    if (scanner_.word() != "MeshVersionFormatted") {
      scanner_.fail("no medit file, for it does not begin with MeshVersionFormatted");
    }
    set_version(integer("the version"));
  }

  void set_version(std::int64_t version) {
    if (version < 1 || version > 4) {
      scanner_.fail(fmt::format("version {} is not one from 1 to 4", version));
    }
    version_ = static_cast<int>(version);
  }

  /// Numbers of a keyword that is not read stand before the next.
  std::string next_of_text() {
    for (;;) {
      const std::string_view word = scanner_.word();
      if (word.empty()) return "";
      if (std::isalpha(static_cast<unsigned char>(word[0])) != 0) return std::string(word);
    }
  }

  /// A keyword's code, and where the next begins.
  std::string next_of_binary() {
    if (next_ > 0) scanner_.go_to(next_);
    if (scanner_.rest() == 0) return "";
    const std::int64_t code = scanner_.integer(4, "a keyword");
    const std::int64_t next = scanner_.integer(version_ >= 3 ? 8 : 4, "the place of a keyword");
    const auto known = std::find_if(kCodes.begin(), kCodes.end(),
                                    [&](const auto& entry) { return entry.second == code; });
    if (known != kCodes.end() && known->first == "End") return "";
    const bool goes_on = next > static_cast<std::int64_t>(scanner_.offset()) &&
                         next <= static_cast<std::int64_t>(scanner_.bytes().size());
    if (!goes_on) scanner_.fail(fmt::format("the next keyword is said to be at byte {}", next));
    next_ = static_cast<std::size_t>(next);
    return known == kCodes.end() ? std::to_string(code) : std::string(known->first);
  }

  NumberScanner scanner_;
  int version_ = 1;
  int dimension_ = 0;
  int integer_size_ = 4;
  int number_size_ = 8;
  std::size_t next_ = 0;  ///< where the next keyword of a binary file begins
};

/// The names that write_mesh keeps in comments of text files: "# patch 2 NAME" of a reference,
/// "# group 2 5: NAME" of several, "# contour 3 NAME" of a reference of edges.
class NamesInComments {
 public:
  explicit NamesInComments(std::string_view bytes) {
    constexpr std::string_view begin = "\n# ";
    for (std::size_t at = bytes.find(begin); at != bytes.npos; at = bytes.find(begin, at + 1)) {
      const std::size_t first = at + begin.size();
      const std::string_view line = bytes.substr(first, bytes.find('\n', first) - first);
      add(line.substr(0, line.find('\r')));
    }
  }

  /// `references` are by patch, ascending.
  void name_patches(std::span<const std::int64_t> references, MeshNames& names) const {
    names.patches = by_index(patches_, references);
    for (const auto& [group, members] : groups_) {
      std::vector<int> patches;
      for (const std::int64_t member : members) {
        const auto patch = index_of(member, references);
        if (patch) patches.push_back(static_cast<int>(*patch));
      }
      names.groups.push_back({group, std::move(patches)});
    }
    put_in_order(names.groups);
  }

  /// `references` are by contour, ascending.
  void name_contours(std::span<const std::int64_t> references, MeshNames& names) const {
    names.contours = by_index(contours_, references);
  }

 private:
  using Names = std::map<std::int64_t, std::string>;

  static std::optional<std::size_t> index_of(std::int64_t reference,
                                             std::span<const std::int64_t> references) {
    const auto found = std::lower_bound(references.begin(), references.end(), reference);
    if (found == references.end() || *found != reference) return std::nullopt;
    return static_cast<std::size_t>(found - references.begin());
  }

  /// Empty where nothing has a name.
  static std::vector<std::string> by_index(const Names& names,
                                           std::span<const std::int64_t> references) {
    std::vector<std::string> result;
    for (const auto& [reference, name] : names) {
      const auto index = index_of(reference, references);
      if (!index) continue;
      result.resize(references.size());
      result[*index] = name;
    }
    return result;
  }

  /// Take a number with the blank before it from the beginning of a text.
  static std::optional<std::int64_t> take_number(std::string_view& text) {
    std::int64_t number = 0;
    if (!text.starts_with(' ')) return std::nullopt;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
  }

  void add(std::string_view comment) {
    const auto take = [&](std::string_view word) {
      const bool is_it = comment.starts_with(word);
      if (is_it) comment.remove_prefix(word.size());
      return is_it;
    };
    if (take("group")) return add_group(comment);
    Names* names = take("patch") ? &patches_ : take("contour") ? &contours_ : nullptr;
    if (names == nullptr) return;
    const auto reference = take_number(comment);
    if (reference && comment.starts_with(' ')) (*names)[*reference] = comment.substr(1);
  }

  void add_group(std::string_view comment) {
    std::vector<std::int64_t> members;
    while (const auto member = take_number(comment)) members.push_back(*member);
    if (comment.starts_with(": ")) groups_.emplace_back(comment.substr(2), std::move(members));
  }

  Names patches_;
  Names contours_;
  std::vector<std::pair<std::string, std::vector<std::int64_t>>> groups_;
};

class MeditReader {
 public:
  MeditReader(std::string_view bytes, const std::string& name)
      : bytes_(bytes), reader_(bytes, name), name_(name), builder_(name) {}

  GridFile run() {
    for (std::string keyword = reader_.next(); !keyword.empty(); keyword = reader_.next()) {
      read(keyword);
    }
    if (!has_vertices_) {
      throw Error(ErrorCode::InvalidInput, fmt::format("{}: the file has no Vertices", name_));
    }
    const NamesInComments names(reader_.is_text() ? bytes_ : std::string_view());
    names.name_patches(builder_.number_patches(0), builder_.grid.names);
    names.name_contours(builder_.number_contours(), builder_.grid.names);
    return builder_.finish();
  }

 private:
  void read(const std::string& keyword) {
    if (keyword == "Dimension") return reader_.read_dimension();
    if (keyword == "Vertices") return read_vertices();
    if (keyword == "Edges") return read_elements(2, keyword);
    if (keyword == "Triangles") return read_elements(3, keyword);
    if (keyword == "Quadrilaterals" || keyword == "Tetrahedra") return read_elements(4, keyword);
    if (std::find(kSolids.begin(), kSolids.end(), keyword) != kSolids.end()) {
      builder_.leave_out(keyword, reader_.count(1, "the number of elements"));
    }
  }

  void read_vertices() {
    const int dimension = reader_.dimension();
    const std::size_t count = reader_.count(6, "the number of vertices");
    std::vector<Vec3>& points = builder_.grid.points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 point = Vec3::Zero();
      for (int k = 0; k < dimension; ++k) point[k] = reader_.finite("a coordinate");
      points.push_back(point);
      reader_.integer("the reference of a vertex");
    }
    has_vertices_ = true;
  }

  void read_elements(std::size_t corners, const std::string& keyword) {
    if (!has_vertices_) reader_.fail(fmt::format("{} stand before Vertices", keyword));
    const std::size_t count = reader_.count(2 * corners, "the number of elements");
    if (corners > 2) builder_.grid.faces.reserve(count, count * corners);
    std::array<int, 4> element{};
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < corners; ++k) element[k] = read_vertex();
      add(std::span(element).first(corners), reader_.integer("a reference"), keyword);
    }
  }

  /// As an index from 0.
  int read_vertex() {
    const std::int64_t number = reader_.integer("a vertex");
    const std::size_t count = builder_.grid.points.size();
    if (number < 1 || number > static_cast<std::int64_t>(count)) {
      reader_.fail(fmt::format("vertex {}, but there are {} vertices, from 1", number, count));
    }
    return static_cast<int>(number - 1);
  }

  void add(std::span<const int> element, std::int64_t reference, std::string_view keyword) {
    if (keyword == "Tetrahedra") {
      builder_.add_tetrahedron({element[0], element[1], element[2], element[3]});
    } else if (keyword == "Edges") {
      if (reference > 0) builder_.add_side(element[0], element[1], reference);
    } else {
      builder_.add_face(element, reference);
    }
  }

  std::string_view bytes_;
  KeywordReader reader_;
  std::string name_;
  GridBuilder builder_;
  bool has_vertices_ = false;
};

/// Values of one kind, as they are in the file.
struct ValueColumn {
  ValueKind kind;
  int components;
  bool is_read;
};

int components_of(ValueKind kind, int dimension) {
  switch (kind) {
    case ValueKind::Scalar:
      return 1;
    case ValueKind::Vector:
      return dimension;
    case ValueKind::SymmetricTensor:
      return dimension == 2 ? 3 : 6;
    case ValueKind::Tensor:
      break;
  }
  return dimension * dimension;
}

/// Files have xx, xy, yy, xz, yz, zz: the lower half, row by row.
void reorder(std::span<double> tensor) {
  const std::array<double, 6> m = {tensor[0], tensor[1], tensor[2],
                                   tensor[3], tensor[4], tensor[5]};
  const std::array<double, 6> ours = {m[0], m[2], m[5], m[1], m[4], m[3]};
  std::copy(ours.begin(), ours.end(), tensor.begin());
}

std::vector<ValueColumn> read_columns(KeywordReader& reader, GridFile& grid) {
  const std::int64_t count = reader.kind("the number of kinds of values");
  std::vector<ValueColumn> columns;
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t number = reader.kind("a kind of values");
    if (number < 1 || number > 4) {
      reader.fail(
          fmt::format("kind {} of values is none of scalar (1), vector (2), symmetric "
                      "tensor (3) or tensor (4)",
                      number));
    }
    const auto kind = static_cast<ValueKind>(number);
    const bool is_read = kind == ValueKind::Scalar || kind == ValueKind::SymmetricTensor;
    columns.push_back({kind, components_of(kind, reader.dimension()), is_read});
    if (!is_read) grid.unread.push_back("vectors and unsymmetric tensors of a .sol file");
  }
  return columns;
}

void read_values(KeywordReader& reader, GridFile& grid) {
  const std::size_t count = reader.count(1, "the number of values");
  if (count != grid.points.size()) {
    reader.fail(
        fmt::format("values at {} vertices, but the mesh has {}", count, grid.points.size()));
  }
  const std::vector<ValueColumn> columns = read_columns(reader, grid);
  const auto read = std::count_if(columns.begin(), columns.end(),
                                  [](const ValueColumn& column) { return column.is_read; });
  std::vector<GridValues> values;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    values.push_back({read == 1 ? "sol" : fmt::format("sol{}", c + 1),
                      columns[c].components,
                      {},
                      columns[c].kind == ValueKind::SymmetricTensor && reader.dimension() == 2});
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      std::array<double, 9> numbers{};
      const auto components = static_cast<std::size_t>(columns[c].components);
      for (std::size_t k = 0; k < components; ++k) numbers[k] = reader.number("a value");
      if (!columns[c].is_read) continue;
      if (components == 6) reorder(std::span(numbers).first(6));
      values[c].numbers.insert(values[c].numbers.end(), numbers.begin(),
                               numbers.begin() + static_cast<std::ptrdiff_t>(components));
    }
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].is_read) grid.at_points.push_back(std::move(values[c]));
  }
}

}  // namespace

GridFile parse_medit_grid(std::string bytes, const std::string& name) {
  return MeditReader(bytes, name).run();
}

void add_medit_values(std::string bytes, const std::string& name, GridFile& grid) {
  KeywordReader reader(bytes, name);
  bool has_values = false;
  for (std::string keyword = reader.next(); !keyword.empty(); keyword = reader.next()) {
    if (keyword == "Dimension") reader.read_dimension();
    if (keyword != "SolAtVertices") continue;
    read_values(reader, grid);
    has_values = true;
  }
  if (!has_values) {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: the file has no SolAtVertices", name));
  }
}

}  // namespace surfmesh
