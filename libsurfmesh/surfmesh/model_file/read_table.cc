// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_table.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/text_scanner.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

enum class Columns { Size, Lengths, Metric };

constexpr std::size_t kMostColumns = 5;

/// What some programs write before UTF-8 text.
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Bounds of lengths, and of metrics whose lengths they are. Beyond, squares and determinants would
/// overflow or vanish when sizes are computed, where nothing tells the line any more.
constexpr double kLeastLength = 1e-50, kGreatestLength = 1e50;
constexpr double kLeastEntry = 1e-100, kGreatestEntry = 1e100;

bool is_within(double value, double least, double greatest) {
  return value >= least && value <= greatest;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& name, const Domain& domain)
      : rest_(text), name_(name), domain_(domain) {
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
  }

  std::vector<TableNode> run() {
    std::vector<TableNode> nodes;
    bool has_header = false;
    while (!rest_.empty()) {
      const std::string_view line = next_line();
      if (line.empty() || line[0] == '#') continue;
      if (has_header) {
        nodes.push_back(read_row(cells_of(line)));
      } else {
        read_header(cells_of(line));
        has_header = true;
      }
    }
    if (nodes.empty()) throw Error(ErrorCode::InvalidInput, name_ + ": the table has no rows");
    return nodes;
  }

 private:
  [[noreturn]] void fail(std::string_view reason) const {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}:{}: {}", name_, line_, reason));
  }

  std::string_view next_line() {
    const std::size_t end = rest_.find('\n');
    const std::string_view line = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    return line;
  }

  void read_header(const std::vector<std::string_view>& cells) {
    using Header = std::vector<std::string_view>;
    if (cells == Header{"u", "v", "size"}) {
      columns_ = Columns::Size;
    } else if (cells == Header{"u", "v", "ls", "lt", "angle"}) {
      columns_ = Columns::Lengths;
    } else if (cells == Header{"u", "v", "m11", "m12", "m22"}) {
      columns_ = Columns::Metric;
    } else {
      fail("the first line must name the columns: u,v,size or u,v,ls,lt,angle or u,v,m11,m12,m22");
    }
    count_ = cells.size();
  }

  double read_number(std::string_view cell) const {
    double value = 0;
    const char* end = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data(), end, value);
    if (cell.empty() || error != std::errc() || stop != end || !std::isfinite(value)) {
      fail(fmt::format("{} is not a number", quoted(cell)));
    }
    return value;
  }

  TableNode read_row(const std::vector<std::string_view>& cells) const {
    if (cells.size() != count_) {
      fail(fmt::format("the row has {} values, the table {} columns", cells.size(), count_));
    }
    std::array<double, kMostColumns> values{};
    std::transform(cells.begin(), cells.end(), values.begin(),
                   [this](std::string_view cell) { return read_number(cell); });
    TableNode node;
    node.uv = {values[0], values[1]};
    check_inside_domain(node.uv);
    if (columns_ == Columns::Metric) {
      node.metric = {values[2], values[3], values[4]};
      check_metric(node.metric);
      return node;
    }
    const bool is_one = columns_ == Columns::Size;
    node.size = {Length::units(values[2]), Length::units(is_one ? values[2] : values[3])};
    // Divided first: the greatest angles would overflow.
    if (!is_one) node.size.angle = values[4] * (std::numbers::pi / 180);
    check_length(node.size.along.value);
    check_length(node.size.across.value);
    return node;
  }

  void check_metric(const Metric& m) const {
    const bool is_positive = m.m11 > 0 && m.m22 > 0;
    if (is_positive && !(is_within(m.m11, kLeastEntry, kGreatestEntry) &&
                         is_within(m.m22, kLeastEntry, kGreatestEntry))) {
      fail(fmt::format("m11 and m22 must be between {} and {}", kLeastEntry, kGreatestEntry));
    }
    // An m12 whose square overflows is far too large for the others.
    if (!(is_positive && determinant(m) > 0)) fail("the metric is not positive definite");
  }

  void check_length(double length) const {
    if (!(length > 0)) fail("a size must be above 0");
    if (!is_within(length, kLeastLength, kGreatestLength)) {
      fail(fmt::format("a size must be between {} and {}", kLeastLength, kGreatestLength));
    }
  }

  void check_inside_domain(Uv uv) const {
    const bool is_inside = uv.u >= domain_.u0 && uv.u <= domain_.u1 && uv.v >= domain_.v0 &&
                           uv.v <= domain_.v1 && domain_.fold(uv) == uv;
    if (!is_inside) fail(fmt::format("the point ({}, {}) is outside of the domain", uv.u, uv.v));
  }

  std::string_view rest_;
  std::string name_;
  Domain domain_;
  Columns columns_ = Columns::Size;
  std::size_t count_ = 0;
  int line_ = 0;
};

}  // namespace

std::vector<TableNode> parse_table(std::string_view text, const std::string& name,
                                   const Domain& domain) {
  return TableReader(text, name, domain).run();
}

std::vector<TableNode> read_table(const std::filesystem::path& path, const Domain& domain) {
  return parse_table(read_file(path), path.string(), domain);
}

}  // namespace surfmesh
