// SPDX-License-Identifier: BSD-3-Clause
#include "paper/tables.hh"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace surfmesh::paper {
namespace {

using Json = nlohmann::ordered_json;

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "–";
}

std::string cell_text(const Cell& cell, int digits) {
  const std::string ours = number(cell.ours, digits);
  return cell.papers ? fmt::format("{} ({})", ours, number(cell.papers, digits)) : ours;
}

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json row_json(const Table& table, const Row& row) {
  Json json = {{"variant", row.label}};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    json[table.columns[i].name] = {{"ours", or_null(row.cells[i].ours)},
                                   {"paper", or_null(row.cells[i].papers)}};
  }
  return json;
}

}  // namespace

std::string to_markdown(const Table& table) {
  std::string text = fmt::format("### {}\n\n| |", table.title);
  for (const Column& column : table.columns) text += fmt::format(" {} |", column.name);
  text += "\n|---|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += "--:|";
  text += "\n";
  for (const Row& row : table.rows) {
    text += fmt::format("| {} |", row.label);
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      text += fmt::format(" {} |", cell_text(row.cells[i], table.columns[i].digits));
    }
    text += "\n";
  }
  return text;
}

std::string to_json(const std::vector<Table>& tables, const std::string& version,
                    const std::string& machine) {
  Json json = {{"version", version}, {"machine", machine}, {"tables", Json::object()}};
  for (const Table& table : tables) {
    Json rows = Json::array();
    for (const Row& row : table.rows) rows.push_back(row_json(table, row));
    json["tables"][table.key] = {{"title", table.title}, {"rows", rows}};
  }
  return json.dump(2) + "\n";
}

}  // namespace surfmesh::paper
