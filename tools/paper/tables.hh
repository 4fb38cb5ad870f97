// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace surfmesh::paper {

/// A figure of ours and the paper's, if it gives one.
struct Cell {
  std::optional<double> ours;
  std::optional<double> papers = {};
};

struct Row {
  std::string label;
  std::vector<Cell> cells;
};

struct Column {
  std::string name;
  int digits = 0;  ///< behind the point
};

struct Table {
  std::string key;  ///< in tables.json
  std::string title;
  std::vector<Column> columns;
  std::vector<Row> rows;
};

/// The table in Markdown: ours, and the paper's in parentheses behind it.
std::string to_markdown(const Table& table);

/// All tables as JSON text, with numbers in full.
std::string to_json(const std::vector<Table>& tables, const std::string& version,
                    const std::string& machine);

}  // namespace surfmesh::paper
