// SPDX-License-Identifier: BSD-3-Clause
#include "paper/published.hh"

#include <map>
#include <utility>

namespace surfmesh::paper::published {
namespace {

template <class Key>
std::vector<double> find(const std::map<Key, std::vector<double>>& rows, const Key& key) {
  const auto found = rows.find(key);
  return found == rows.end() ? std::vector<double>() : found->second;
}

using Rows = std::map<std::string_view, std::vector<double>>;
using RowsByNodes = std::map<std::pair<int, std::string_view>, std::vector<double>>;

}  // namespace

std::vector<double> table1(std::string_view row) {
  static const Rows rows = {{"T_t", {3063, 5970, 1.046, 0.17, 0.975, 0.21}},
                            {"T_o", {2730, 5284, 1.098, 0.23, 1.044, 0.15}},
                            {"Q_t", {2680, 2602, 1.047, 0.23, 0.979, 0.25}},
                            {"Q_o", {2641, 2553, 1.048, 0.21, 0.986, 0.19}}};
  return find(rows, row);
}

std::vector<double> table2(std::string_view variant) {
  static const Rows rows = {{"V_t", {25.0, 6.1, 1.003, 0.19, 1.008, 0.22}},
                            {"V_o", {25.5, 5.7, 1.003, 0.18, 1.003, 0.18}},
                            {"V_x", {25.5, 5.8, 1.003, 0.19, 1.005, 0.19}},
                            {"V_t+I", {28.0, 11.5, 1.006, 0.18, 1.016, 0.18}},
                            {"V_o+I", {28.7, 10.1, 1.012, 0.18, 1.012, 0.18}},
                            {"V_x+I", {28.7, 10.2, 1.012, 0.17, 1.012, 0.17}}};
  return find(rows, variant);
}

std::vector<double> table3(std::string_view variant) {
  static const Rows rows = {{"V_x", {0.6, 75.0, 24.4, 4.3, 80.1, 15.6, 622}},
                            {"V_x+I", {1.9, 73.4, 24.7, 11.3, 55.0, 37.7, 1466}}};
  return find(rows, variant);
}

std::vector<double> table4(int nodes, std::string_view variant) {
  static const RowsByNodes rows = {{{40'000, "V_x+IR"}, {42.7, 4.48, 9.5, 2.63, 0.985, 0.18}},
                                   {{40'000, "V_x+I"}, {42.8, 3.24, 13.2, 2.70, 0.984, 0.18}},
                                   {{40'000, "V_o"}, {42.7, 3.05, 14.0, 1.33, 0.983, 0.18}},
                                   {{10'000, "V_x+IR"}, {37.7, 5.48, 6.9, 0.5, 0.976, 0.19}},
                                   {{10'000, "V_x+I"}, {37.9, 4.42, 8.6, 0.52, 0.975, 0.16}},
                                   {{10'000, "V_o"}, {37.9, 4.36, 8.7, 0.28, 0.973, 0.19}},
                                   {{2'500, "V_x+IR"}, {25.8, 6.62, 3.9, 0.11, 0.943, 0.22}},
                                   {{2'500, "V_x+I"}, {26.1, 5.37, 4.9, 0.11, 0.938, 0.22}},
                                   {{2'500, "V_o"}, {26.0, 5.27, 4.9, 0.06, 0.938, 0.22}}};
  return find(rows, {nodes, variant});
}

std::vector<double> table5(int nodes, std::string_view variant) {
  static const RowsByNodes rows = {{{40'000, "V_x+IR"}, {0.6, 24.1, 48.7, 26.6, 9.1, 30.3, 60.6}},
                                   {{40'000, "V_x+I"}, {0.9, 32.8, 66.3, 0, 9.1, 30.3, 60.6}},
                                   {{40'000, "V_o"}, {0, 0, 100}},
                                   {{10'000, "V_x+IR"}, {0.2, 1.6, 71.6, 26.6, 5.2, 4.2, 90.6}},
                                   {{10'000, "V_x+I"}, {0.2, 2.1, 97.7, 0, 5.2, 4.2, 90.6}},
                                   {{10'000, "V_o"}, {0, 0, 100}},
                                   {{2'500, "V_x+IR"}, {0.3, 0.4, 72.3, 27.0, 0.8, 1.8, 97.4}},
                                   {{2'500, "V_x+I"}, {0.4, 0.5, 99.1, 0, 0.8, 1.8, 97.4}},
                                   {{2'500, "V_o"}, {0, 0, 100}}};
  return find(rows, {nodes, variant});
}

}  // namespace surfmesh::paper::published
