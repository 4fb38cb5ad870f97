// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

/// The figures of tables 1 to 5 of the paper, in the order of its columns; empty for a row that it
/// does not have.
namespace surfmesh::paper::published {

/// NP, NE, μ_t, σ_t, μ_o, σ_o. Rows T_t, T_o, Q_t, Q_o.
std::vector<double> table1(std::string_view row);

/// NT and NT/s in thousands, μ, σ, μ_o, σ_o.
std::vector<double> table2(std::string_view variant);

/// m_s, m_t, m_o, N_s, N_t, N_o in percent, and the control triangles, which the text gives.
std::vector<double> table3(std::string_view variant);

/// NT and NT/s in thousands, t_g and t_c in seconds, μ_o, σ_o.
std::vector<double> table4(int nodes, std::string_view variant);

/// m_s, m_t, m_o, m_r, N_s, N_t, N_o in percent.
std::vector<double> table5(int nodes, std::string_view variant);

}  // namespace surfmesh::paper::published
