// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// The stages of a run, in the order of the data flow. Corrections within a patch and the splitting
/// of chords between patches belong to Assemble; those of quads to Quad.
///
/// A new one is listed in kStages, too, and gets its name in stage.cc.
enum class Stage {
  Read,
  Control,
  Boundary,
  Triangulate,
  Refine,
  Improve,
  Quad,
  Assemble,
  Across,
  Write
};

/// All of them: what the sums and the report go by.
inline constexpr std::array kStages = {
    Stage::Read,    Stage::Control, Stage::Boundary, Stage::Triangulate, Stage::Refine,
    Stage::Improve, Stage::Quad,    Stage::Assemble, Stage::Across,      Stage::Write};

/// The name of a stage, as used in reports: "read", "control", ...
std::string_view name(Stage stage);

/// True for the stages that make the mesh itself, whose time the paper's triangles per second
/// count: all but reading, control space and writing.
constexpr bool is_meshing(Stage stage) { return stage > Stage::Control && stage < Stage::Write; }

/// A value for each stage, T() at first.
template <class T>
class PerStage {
 public:
  T& operator[](Stage stage) { return values_[static_cast<std::size_t>(stage)]; }
  const T& operator[](Stage stage) const { return values_[static_cast<std::size_t>(stage)]; }

  /// Add the values stage by stage.
  PerStage& operator+=(const PerStage& other) {
    for (const Stage stage : kStages) (*this)[stage] += other[stage];
    return *this;
  }

  /// The sum over the stages for which `is_counted` holds.
  template <class IsCounted>
  T sum(IsCounted is_counted) const {
    T total{};
    for (const Stage stage : kStages) {
      if (is_counted(stage)) total += (*this)[stage];
    }
    return total;
  }

  /// The sum over all stages.
  T sum() const {
    return sum([](Stage) { return true; });
  }

  friend bool operator==(const PerStage&, const PerStage&) = default;

 private:
  std::array<T, kStages.size()> values_{};
};

}  // namespace surfmesh
