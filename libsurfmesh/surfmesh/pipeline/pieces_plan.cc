// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/pieces_plan.hh"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/freed_memory.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/options_of_model.hh"
#include "surfmesh/pipeline/reach_sag.hh"
#include "surfmesh/pipeline/sag_notices.hh"
#include "surfmesh/pipeline/unused_options.hh"

namespace surfmesh::detail {
namespace {

PipelineOptions without_across(PipelineOptions options) {
  options.across.is_on = false;
  return options;
}

/// What the options ask for that pieces do not have.
Notices notices_of_pieces(const PipelineOptions& options, double sag) {
  Notices notices;
  if (options.across.is_on) {
    notices.push_back(information(
        NoticeKind::UnusedOption,
        "elements do not cross contours in pieces: each is made by itself (across = off)"));
  }
  if (sag > 0) {
    notices.push_back(warning(NoticeKind::UnusedOption,
                              "in pieces, the triangles of each tile are corrected for the sag one "
                              "by one; what the whole mesh has reached is not measured"));
  }
  if (options.output.normals || options.output.texture) {
    notices.push_back(warning(NoticeKind::UnusedOption,
                              "pieces have no normals and no texture coordinates (normals, "
                              "texture)"));
  }
  return notices;
}

/// Tell where there are fewer pieces than were asked for, and ranks without any.
Notices notices_of_deal(const TileDeal& deal, int asked, int ranks, int tile) {
  const int wanted = asked > 0 ? asked : ranks;
  if (deal.pieces >= wanted) return {};
  std::vector<int> busy = deal.rank_of_piece;
  busy.erase(std::unique(busy.begin(), busy.end()), busy.end());
  const std::size_t idle = static_cast<std::size_t>(ranks) - busy.size();
  std::string text =
      fmt::format("there {} only {}, as many as tiles", deal.pieces == 1 ? "is" : "are",
                  counted(static_cast<std::size_t>(deal.pieces), "piece", "pieces"));
  if (idle > 0) text += fmt::format(", and {} of {} ranks have nothing to do", idle, ranks);
  text += fmt::format("; {} makes more", tile == 0 ? std::string("a tile above 0")
                                                   : fmt::format("a tile below {}", tile));
  return {warning(NoticeKind::UnusedOption, std::move(text))};
}

}  // namespace

PiecesPlan::PiecesPlan(const Model& model, const Sources& sources, const PipelineOptions& options,
                       const RunContext& context)
    : model_(model),
      sources_(sources),
      asked_(options),
      options_(without_across(options)),
      context_(context),
      sizing_(resolve(options.sizing, model)),
      mesh_(model, sizing_, options_, context, report_) {}

void PiecesPlan::make(const PiecesOptions& pieces, int ranks) {
  begin_report();
  context_.begin_mesh();
  mesh_.take_spaces(control_spaces());
  divide();
  // Tables of arcs along contours take as much as all that is kept.
  return_freed_memory();
  deal_ = deal_out(tiles(), pieces.pieces, pieces.deal, ranks);
  append(notices_of_deal(deal_, pieces.pieces, ranks, options_.tile), report_.notices);
  std::vector<const PatchBoundary*> boundaries;
  for (const Tile& tile : tiles()) boundaries.push_back(&tile.boundary);
  shared_.emplace(model_, mesh_.nodes(), mesh_.numbers(), boundaries, deal_.piece_of,
                  deal_.rank_of_piece);
}

void PiecesPlan::drop_other_spaces(int rank) {
  std::vector<char> is_kept(model_.patches.size(), 0);
  for (std::size_t t = 0; t < tiles().size(); ++t) {
    if (deal_.rank_of(t) == rank) is_kept[patch_of(t)] = 1;
  }
  mesh_.keep_spaces(is_kept);
  return_freed_memory();
}

void PiecesPlan::need_spaces(const std::vector<std::size_t>& tiles) {
  const bool has_all = std::all_of(tiles.begin(), tiles.end(),
                                   [this](std::size_t t) { return mesh_.has_space(patch_of(t)); });
  if (!has_all) mesh_.restore_spaces(control_spaces());
}

std::size_t PiecesPlan::patch_of(std::size_t tile) const {
  return static_cast<std::size_t>(tiles()[tile].boundary.patch);
}

void PiecesPlan::begin_report() {
  report_.options = options_in_effect(model_, options_);
  report_.surfaces = model_.fits;
  if (sizing_.sag > 0) report_.sag.asked = sizing_.sag;
  append(model_.notices, report_.notices);
  append(options_too_late(model_, options_), report_.notices);
  append(unused_options(options_), report_.notices);
  append(notices_of_raised_sag(model_, asked_.sizing), report_.notices);
  append(notices_of_pieces(asked_, sizing_.sag), report_.notices);
}

ControlSpaces PiecesPlan::control_spaces() {
  const StageClock clock(report_.seconds[Stage::Control]);
  return make_control_spaces(model_, sources_, sizing_, options_.control, context_);
}

void PiecesPlan::divide() {
  ContourDemands demands;
  if (sizing_.sag > 0) demands.sag = sizing_.sag;
  if (options_.quads.is_on) demands.parity = SegmentParity::EvenPatches;
  mesh_.divide(demands, kCorrectedShare * sizing_.sag, nullptr);
}

}  // namespace surfmesh::detail
