// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "paper/experiment.hh"
#include "paper/tables.hh"

namespace surfmesh::paper {

/// Makes the tables of section 5 from its three examples.
class Laboratory {
 public:
  /// Called with a line about what is done next.
  using Progress = std::function<void(const std::string&)>;

  /// `folder` holds example1.json to example3.json. Times of tables 2 and 4 in the paper's way are
  /// medians of so many runs, of the rows of a table in turn; all others are those of one run.
  /// Throws   as load_model
  Laboratory(const std::filesystem::path& folder, int rounds, Progress progress);

  /// Tables 1 to 5, and those that the paper does not have: all variants of example 3 in the
  /// paper's way and by today's defaults, the shares of figure 1, and conformity by thresholds.
  std::vector<Table> tables();

  Experiment& first() { return first_; }
  Experiment& second() { return second_; }
  Experiment& third() { return third_; }

 private:
  Table lengths_of_first();   // table 1
  Table figures_of_second();  // table 2
  Table classes_of_second();  // table 3
  Table figures_of_third();   // table 4
  Table classes_of_third();   // table 5
  Table variants_of_third(Way way);
  Table questions_by_stage();
  Table conformity_of_first();

  std::vector<Outcome> run_in_turn(Experiment& experiment, const std::vector<Variant>& variants);

  Experiment first_, second_, third_;
  int rounds_;
  Progress progress_;
  std::vector<Outcome> second_outcomes_;  ///< of the rows of table 2
  std::vector<Outcome> third_outcomes_;   ///< of the rows of table 4
};

/// The variants of the rows of tables 2 and 4.
std::vector<Variant> variants_of_second();
std::vector<Variant> variants_of_third();

/// The stages of figure 1, and the share of the questions that each of them asks.
struct StageShare {
  std::string name;
  double share = 0;
};
std::vector<StageShare> shares_by_stage(const Outcome& outcome);

}  // namespace surfmesh::paper
