// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/comparison.hh"
#include "compare/peers.hh"
#include "compare/remesh_judge.hh"

namespace surfmesh::compare {

/// A cage whose limit surface is known, and is to be found again from a mesh of it.
struct RemeshTruth {
  std::string name;
  std::filesystem::path file;
  bool is_smooth = true;  ///< without creases and corners
};

/// The cages that are there: those of the repository and, unless it is quick, those in ../shared.
std::vector<RemeshTruth> remesh_truths(const Settings& settings);

/// A mesh that is remeshed.
struct RemeshInput {
  int triangles = 0;         ///< about
  bool is_adaptive = false;  ///< with sizes from curvature, stretched ones; else with one size
};

std::vector<RemeshInput> remesh_inputs(bool is_quick);

/// How long the sides of the new elements are, in lengths of those of the input.
enum class RemeshSizes { Half, Same, Fivefold, Curvature };

std::string name(RemeshSizes sizes);

/// What one tool made of the input.
struct RemeshRow {
  RemeshSizes sizes = RemeshSizes::Same;
  bool is_quads = false;
  ToolResult run = {};        ///< its `mesh` and `distance` are not set
  RemeshJudgement mesh = {};  ///< of the last round; not set after a failure
};

/// One mesh that every tool has remeshed. In each group of sizes the first row is that of surfmesh
/// with triangles.
struct RemeshResult {
  std::string name;
  std::string about;  ///< one sentence
  bool is_smooth = true;
  RemeshInput wanted = {};
  RemeshJudgement input = {};
  std::vector<RemeshRow> rows = {};
};

/// The mean distance of a mesh, or of its vertices, over that of the faces of the input, which is
/// to be at most this.
double wanted_share(const RemeshResult& result);

/// How many equilateral triangles of the sides asked for cover the input; 0 for sizes from
/// curvature.
double ideal_count(const RemeshResult& result, RemeshSizes sizes);

/// What surfmesh did not reach, a sentence for each, by comparison with the input and with the
/// other tools in the same group of sizes:
///
/// the share above, by the vertices at all sizes, and by the faces at half the sizes, as faces of
/// the same length are as far from any surface (but not of adaptive inputs); topology; turned and
/// crossing faces; features as near as those of the input; of long sides a count within 10 % of the
/// ideal; at uniform sizes, qualities as good and half the time.
std::vector<std::string> missed_aims(const RemeshResult& result);

/// Make a mesh of the limit surface of a cage by surfmesh, and remesh it by surfmesh and by the
/// peers that can, in turn.
///
/// Throws   Io if the input cannot be made. What a tool does wrong is told in its row
RemeshResult compare_remeshing(const RemeshTruth& truth, const RemeshJudge& judge,
                               const RemeshInput& input, const std::vector<Peer>& peers,
                               const Settings& settings);

}  // namespace surfmesh::compare
