// SPDX-License-Identifier: BSD-3-Clause
#include "paper/laboratory.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "paper/published.hh"
#include "pictures/median.hh"

namespace surfmesh::paper {
namespace {

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

double thousands(double count) { return count / 1000; }

/// Elements a second, in thousands.
double speed(const Outcome& outcome) {
  return thousands(static_cast<double>(outcome.elements()) / outcome.generation_seconds());
}

/// Shares of the control triangles: N_s, N_t, N_o.
std::array<double, 3> shares_of_classes(const Outcome& outcome) {
  const Report::Classes& classes = outcome.report.control.classes;
  const std::size_t all = classes.single + classes.triangle + classes.circles;
  return {percent(classes.single, all), percent(classes.triangle, all),
          percent(classes.circles, all)};
}

/// Shares of the questions: m_s, m_t, m_o, m_r; of those that nodes with radii do not answer alone.
std::array<double, 4> shares_of_answers(const Outcome& outcome) {
  const QueryCounts answers = outcome.report.control.queries.sum();
  const std::size_t all = answers.total() - answers.extended;
  return {percent(answers.single, all), percent(answers.triangle, all),
          percent(answers.circles, all), percent(answers.reused, all)};
}

std::string row_label(const Variant& variant) {
  return variant.nodes == 0 ? label(variant)
                            : fmt::format("{}, {} nodes", label(variant), variant.nodes);
}

/// Figures of ours beside those of the paper, which may end earlier.
Row row(std::string label, const std::vector<double>& ours, const std::vector<double>& papers) {
  Row row{std::move(label), {}};
  for (std::size_t i = 0; i < ours.size(); ++i) {
    row.cells.push_back({ours[i], i < papers.size() ? std::optional(papers[i]) : std::nullopt});
  }
  return row;
}

std::vector<Column> columns_of_variants() {
  return {{"NT", 1},  {"NT/s", 1}, {"t_g", 3}, {"t_c", 3}, {"μ", 3},
          {"σ", 3},   {"μ_o", 3},  {"σ_o", 3}, {"m_s", 1}, {"m_t", 1},
          {"m_o", 1}, {"m_r", 1},  {"N_s", 1}, {"N_t", 1}, {"N_o", 1}};
}

/// The figures of those columns.
std::vector<double> figures_of(const Outcome& outcome) {
  std::vector<double> figures = {thousands(static_cast<double>(outcome.elements())),
                                 speed(outcome),
                                 outcome.generation_seconds(),
                                 outcome.control_seconds(),
                                 outcome.own.mean,
                                 outcome.own.deviation,
                                 outcome.by_circles.mean,
                                 outcome.by_circles.deviation};
  const auto m = shares_of_answers(outcome);
  const auto n = shares_of_classes(outcome);
  figures.insert(figures.end(), m.begin(), m.end());
  figures.insert(figures.end(), n.begin(), n.end());
  return figures;
}

}  // namespace

std::vector<Variant> variants_of_second() {
  return {{kT}, {kO}, {kX}, {kT, true}, {kO, true}, {kX, true}};
}

std::vector<Variant> variants_of_third() {
  std::vector<Variant> variants;
  for (const int nodes : {40'000, 10'000, 2'500}) {
    variants.push_back({kX, true, true, nodes});
    variants.push_back({kX, true, false, nodes});
    variants.push_back({kO, false, false, nodes});
  }
  return variants;
}

std::vector<StageShare> shares_by_stage(const Outcome& outcome) {
  const PerStage<QueryCounts>& queries = outcome.report.control.queries;
  const std::size_t all = queries.sum().total();
  const auto share = [&](Stage stage) { return percent(queries[stage].total(), all); };
  return {{"nodes of the boundary", share(Stage::Boundary)},
          {"triangulation of the boundary", share(Stage::Triangulate)},
          {"inner nodes", share(Stage::Refine)},
          {"smoothing", share(Stage::Improve)},
          {"quadrilaterals", share(Stage::Quad)}};
}

Laboratory::Laboratory(const std::filesystem::path& folder, int rounds, Progress progress)
    : first_(folder / "example1.json"),
      second_(folder / "example2.json"),
      third_(folder / "example3.json"),
      rounds_(rounds),
      progress_(std::move(progress)) {}

std::vector<Table> Laboratory::tables() {
  progress_("example 1");
  std::vector<Table> tables = {lengths_of_first()};
  progress_("example 2");
  second_outcomes_ = run_in_turn(second_, variants_of_second());
  tables.push_back(figures_of_second());
  tables.push_back(classes_of_second());
  progress_("example 3, the rows of table 4");
  third_outcomes_ = run_in_turn(third_, paper::variants_of_third());
  tables.push_back(figures_of_third());
  tables.push_back(classes_of_third());
  for (const Way way : {Way::Paper, Way::Today}) {
    progress_(way == Way::Paper ? "example 3, all variants in the paper's way"
                                : "example 3, all variants by today's defaults");
    tables.push_back(variants_of_third(way));
  }
  tables.push_back(questions_by_stage());
  tables.push_back(conformity_of_first());
  return tables;
}

/// Run the variants in turn, several times; times become the medians. Meshes are not kept.
std::vector<Outcome> Laboratory::run_in_turn(Experiment& experiment,
                                             const std::vector<Variant>& variants) {
  std::vector<Outcome> outcomes(variants.size());
  std::vector<std::vector<PerStage<double>>> seconds(variants.size());
  for (int round = 0; round < rounds_; ++round) {
    for (std::size_t i = 0; i < variants.size(); ++i) {
      outcomes[i] = experiment.run(variants[i], Way::Paper);
      outcomes[i].result.reset();
      seconds[i].push_back(outcomes[i].report.seconds);
    }
  }
  for (std::size_t i = 0; i < variants.size(); ++i) {
    for (const Stage stage : kStages) {
      std::vector<double> values;
      for (const PerStage<double>& run : seconds[i]) values.push_back(run[stage]);
      outcomes[i].report.seconds[stage] = median(std::move(values));
    }
  }
  return outcomes;
}

Table Laboratory::lengths_of_first() {
  Table table{"table1",
              "Table 1: example 1, by interpolation of sizes and by elements",
              {{"NP", 0},
               {"NE", 0},
               {"μ_t", 3},
               {"σ_t", 2},
               {"μ_o", 3},
               {"σ_o", 2},
               {"NE today", 0},
               {"μ_o today", 3},
               {"σ_o today", 2}},
              {}};
  for (const bool has_quads : {false, true}) {
    for (const Interpolation interpolation : {kT, kO}) {
      const std::string name =
          fmt::format("{}_{}", has_quads ? "Q" : "T", interpolation == kT ? "t" : "o");
      const Outcome papers = first_.run({interpolation}, Way::Paper, has_quads);
      const Outcome today = first_.run({interpolation}, Way::Today, has_quads);
      table.rows.push_back(row(
          name,
          {static_cast<double>(papers.report.mesh.vertices), static_cast<double>(papers.elements()),
           papers.by_triangles.mean, papers.by_triangles.deviation, papers.by_circles.mean,
           papers.by_circles.deviation, static_cast<double>(today.elements()),
           today.by_circles.mean, today.by_circles.deviation},
          published::table1(name)));
    }
  }
  return table;
}

Table Laboratory::figures_of_second() {
  Table table{"table2",
              "Table 2: example 2, NT in thousands, NT/s in thousands a second",
              {{"NT", 1},
               {"NT/s", 1},
               {"μ", 3},
               {"σ", 2},
               {"μ_o", 3},
               {"σ_o", 2},
               {"σ_o unsmoothed", 2},
               {"NT today", 1},
               {"NT/s today", 1},
               {"σ_o today", 2}},
              {}};
  const std::vector<Variant> variants = variants_of_second();
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const Outcome& papers = second_outcomes_[i];
    const Outcome unsmoothed = second_.run(variants[i], Way::Unsmoothed);
    const Outcome today = second_.run(variants[i], Way::Today);
    table.rows.push_back(
        row(label(variants[i]),
            {thousands(static_cast<double>(papers.elements())), speed(papers), papers.own.mean,
             papers.own.deviation, papers.by_circles.mean, papers.by_circles.deviation,
             unsmoothed.by_circles.deviation, thousands(static_cast<double>(today.elements())),
             speed(today), today.by_circles.deviation},
            published::table2(label(variants[i]))));
  }
  return table;
}

Table Laboratory::classes_of_second() {
  Table table{"table3",
              "Table 3: example 2, shares of questions and of control triangles in percent",
              {{"m_s", 1},
               {"m_t", 1},
               {"m_o", 1},
               {"N_s", 1},
               {"N_t", 1},
               {"N_o", 1},
               {"control triangles", 0},
               {"steps of a walk", 2}},
              {}};
  const std::vector<Variant> variants = variants_of_second();
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (variants[i].interpolation != kX) continue;
    const Outcome& outcome = second_outcomes_[i];
    const auto m = shares_of_answers(outcome);
    const auto n = shares_of_classes(outcome);
    table.rows.push_back(
        row(label(variants[i]),
            {m[0], m[1], m[2], n[0], n[1], n[2], static_cast<double>(outcome.report.control.faces),
             outcome.steps_of_a_walk()},
            published::table3(label(variants[i]))));
  }
  return table;
}

Table Laboratory::figures_of_third() {
  Table table{"table4",
              "Table 4: example 3, NT in thousands, NT/s in thousands a second, times in seconds",
              {{"NT", 1},
               {"NT/s", 1},
               {"t_g", 3},
               {"t_c", 3},
               {"μ_o", 3},
               {"σ_o", 2},
               {"σ_o unsmoothed", 2},
               {"t_g + t_c", 3},
               {"circumcentres given up", 0}},
              {}};
  const std::vector<Variant> variants = paper::variants_of_third();
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const Outcome& outcome = third_outcomes_[i];
    const Outcome unsmoothed = third_.run(variants[i], Way::Unsmoothed);
    table.rows.push_back(
        row(row_label(variants[i]),
            {thousands(static_cast<double>(outcome.elements())), speed(outcome),
             outcome.generation_seconds(), outcome.control_seconds(), outcome.by_circles.mean,
             outcome.by_circles.deviation, unsmoothed.by_circles.deviation,
             outcome.generation_seconds() + outcome.control_seconds(),
             static_cast<double>(outcome.report.refine.unconforming)},
            published::table4(variants[i].nodes, label(variants[i]))));
  }
  return table;
}

Table Laboratory::classes_of_third() {
  Table table{"table5",
              "Table 5: example 3, shares of questions and of control triangles in percent",
              {{"m_s", 1},
               {"m_t", 1},
               {"m_o", 1},
               {"m_r", 1},
               {"N_s", 1},
               {"N_t", 1},
               {"N_o", 1},
               {"steps of a walk", 2}},
              {}};
  const std::vector<Variant> variants = paper::variants_of_third();
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const Outcome& outcome = third_outcomes_[i];
    const auto m = shares_of_answers(outcome);
    const auto n = shares_of_classes(outcome);
    table.rows.push_back(row(row_label(variants[i]),
                             {m[0], m[1], m[2], m[3], n[0], n[1], n[2], outcome.steps_of_a_walk()},
                             published::table5(variants[i].nodes, label(variants[i]))));
  }
  return table;
}

Table Laboratory::variants_of_third(Way way) {
  const bool is_papers = way == Way::Paper;
  Table table{is_papers ? "variants_in_the_papers_way" : "variants_today",
              is_papers ? "All variants of example 3 in the paper's way, single runs"
                        : "All variants of example 3 by today's defaults, single runs (without R, "
                          "which is for smoothing by elements)",
              columns_of_variants(),
              {}};
  for (const int nodes : {40'000, 10'000, 2'500}) {
    for (const Interpolation interpolation : {kT, kO, kX}) {
      for (const int letters : {0, 1, 2, 3}) {
        const Variant variant{interpolation, letters % 2 == 1, letters >= 2, nodes};
        if (variant.is_reusing && !is_papers) continue;
        table.rows.push_back(row(row_label(variant), figures_of(third_.run(variant, way)), {}));
      }
    }
  }
  return table;
}

/// What the check of section 2.1, item 3, does at several thresholds; the paper does not give its
/// own.
Table Laboratory::conformity_of_first() {
  Table table{
      "conformity",
      "Conformity: example 1, V_o, in the paper's way, by the greatest logarithm of a ratio "
      "of lengths",
      {{"NT", 0}, {"circumcentres given up", 0}, {"μ_o", 3}, {"σ_o", 3}},
      {}};
  for (const double conformity : {0.0, 1.0, 0.5, 0.3, 0.2, 0.1}) {
    Variant variant{kO};
    variant.conformity = conformity;
    const Outcome outcome = first_.run(variant, Way::Paper);
    table.rows.push_back(row(conformity == 0 ? "by the circle" : fmt::format("{}", conformity),
                             {static_cast<double>(outcome.elements()),
                              static_cast<double>(outcome.report.refine.unconforming),
                              outcome.by_circles.mean, outcome.by_circles.deviation},
                             {}));
  }
  return table;
}

Table Laboratory::questions_by_stage() {
  Table table{
      "figure1", "Figure 1: questions by stage in percent, example 3 with quadrilaterals", {}, {}};
  const Variant variant{kX, true, true, 40'000};
  for (const Way way : {Way::Paper, Way::Today}) {
    const Outcome outcome = third_.run(variant, way, true);
    Row shares{way == Way::Paper ? "the paper's way" : "today's defaults", {}};
    for (const StageShare& stage : shares_by_stage(outcome)) {
      if (table.rows.empty()) table.columns.push_back({stage.name, 1});
      shares.cells.push_back({stage.share, {}});
    }
    table.rows.push_back(std::move(shares));
  }
  return table;
}

}  // namespace surfmesh::paper
