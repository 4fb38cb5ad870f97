// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_in_pieces.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "mesh_command.hh"
#include "mesh_input.hh"
#include "output_paths.hh"
#include "signals.hh"
#include "standard_output.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/piece_file.hh"
#include "surfmesh/formats/piece_folder.hh"
#include "surfmesh/formats/piece_text.hh"
#include "terminal.hh"
#ifdef SURFMESH_HAS_METIS
#include "surfmesh_metis/deal_by_metis.hh"
#endif

namespace surfmesh {
namespace {

/// Hands pieces on, and removes what is half written where a signal ends the program at once.
class GuardedSink final : public PieceSink {
 public:
  explicit GuardedSink(PieceOutput& output) : output_(output) {}

  void begin(const PieceIndex& index) override {
    output_.begin(index);
    guard_.emplace(output_.temporary());
  }
  void write(int piece, const MeshPiece& mesh) override { output_.write(piece, mesh); }
  void finish() override { output_.finish(); }

  /// Remove nothing from now on.
  void release() { guard_.reset(); }

 private:
  PieceOutput& output_;
  std::optional<RemovedOnSignal> guard_;
};

/// True if a folder would have a name as files of meshes have.
bool looks_like_file(const std::filesystem::path& folder) {
  return has_mesh_ending(folder) || folder.extension() == ".pvtu";
}

/// What can be told before any work.
void check_arguments(const MeshArguments& arguments) {
  const std::string& output = arguments.output;
  if (!output.empty() && !has_piece_text(output)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: ranks can write .obj and .ply, or a folder of --pieces", output));
  }
  if (looks_like_file(arguments.pieces)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: --pieces takes the name of a folder; -o writes one file",
                            arguments.pieces));
  }
  const std::array inputs = {std::filesystem::path(arguments.input)};
  for (const std::string& path : {output, arguments.report}) {
    if (path.empty()) continue;
    check_writable(path);
    check_not_overwritten(inputs, path);
  }
  if (!output.empty() && !arguments.report.empty() && is_same_file(output, arguments.report)) {
    throw Error(ErrorCode::Io, fmt::format("{} is the output, too", arguments.report));
  }
}

void check_options(const PipelineOptions& options) {
  if (!options.output.normals && !options.output.uv && !options.output.texture) return;
  throw Error(ErrorCode::InvalidOption,
              "a mesh in pieces has no normals, (u,v) or texture coordinates: leave out --normals, "
              "--uv and --texture, or normals, uv and texture of a model file; surfmesh mesh "
              "without --pieces writes them");
}

/// Tell that elements were asked to cross contours, which those of pieces cannot.
void tell_unused_across(Report& report) {
  const auto given = std::find_if(report.given.begin(), report.given.end(),
                                  [](const GivenOption& a) { return a.name == "across"; });
  if (given == report.given.end() || given->value != "on") return;
  report.notices.push_back(
      warning(NoticeKind::UnusedOption,
              fmt::format("across = on of the {} has no effect in pieces", name(given->origin))));
}

/// One run of the command on a rank.
class PiecesRun {
 public:
  PiecesRun(const MeshArguments& arguments, Exchange& exchange, Progress& progress)
      : arguments_(arguments), exchange_(exchange), progress_(progress) {}

  /// Returns an exit status.
  int run() {
    agree_on_errors_of(exchange_, [this] {
      check_arguments(arguments_);
      input_.read(arguments_, progress_);
      check_options(input_.input().options);
      input_.check_not_replaced(std::array{arguments_.output, arguments_.report});
    });
    const std::unique_ptr<PieceOutput> output = make_output();
    GuardedSink sink(*output);
    Report report = mesh(sink);
    commit(report, *output, sink);
    return tell_of(report);
  }

 private:
  std::unique_ptr<PieceOutput> make_output() {
    if (!arguments_.pieces.empty()) {
      return std::make_unique<PieceFolder>(arguments_.pieces, exchange_);
    }
    return std::make_unique<PieceFile>(arguments_.output, exchange_);
  }

  Report mesh(PieceSink& sink) {
    const ModelInput& input = input_.input();
    const PiecesOptions pieces = pieces_options(arguments_);
    try {
      return mesh_pieces(input.model, input.sources, input.options, pieces, exchange_, sink,
                         &progress_);
    } catch (const AgreedError& error) {
      if (error.code() == ErrorCode::Io) throw;  // of an output: the input has been read
      throw AgreedError(error.code(), text_at_input(arguments_.input, error));
    }
  }

  void commit(Report& report, PieceOutput& output, GuardedSink& sink) {
    input_.describe(arguments_.input, report);
    tell_unused_across(report);
    report.output = arguments_.pieces.empty() ? arguments_.output : arguments_.pieces;
    report.wall_seconds = input_.seconds_so_far();
    if (exchange_.rank() != 0) {
      // Rank 0 waits for this before it puts all in its place. Then the name of what is temporary
      // is free for others, and this rank may not know of it yet where a signal ends it.
      sink.release();
      agree_on_error(exchange_, std::nullopt);
      return output.commit(nullptr);
    }
    std::optional<OutputFile> file;
    agree_on_errors_of(exchange_, [&] {
      if (arguments_.report.empty()) return;
      file.emplace(arguments_.report);
      file->write(to_json(report));
      file->finish();
    });
    const RemovedOnSignal guard(file ? file->temporary() : std::filesystem::path());
    commit_against_signals(status_of(report), [&] { output.commit(file ? &*file : nullptr); });
  }

  int tell_of(const Report& report) {
    progress_.clear();
    int status = status_of(report);
    if (!arguments_.is_quiet) {
      status = print_summary(to_text(report, text_style(arguments_.is_verbose)), status);
    }
    print_notices(report.notices, arguments_.verbosity());
    return status;
  }

  const MeshArguments& arguments_;
  Exchange& exchange_;
  Progress& progress_;
  MeshInput input_;
};

/// Tell of an error that all ranks have. It may be a signal, of which one of them knows.
int tell_agreed_failure(const AgreedError& error, Exchange& exchange, Progress& progress) {
  const std::vector<int> signals = gather_one(exchange, caught_signal());
  const int signal = *std::max_element(signals.begin(), signals.end());
  if (error.code() != ErrorCode::Cancelled || signal == 0) return tell_failure(error, progress);
  progress.clear();
  tell("surfmesh: stopped by a signal\n");
  return kKilledBySignal + signal;
}

}  // namespace

PiecesOptions pieces_options(const MeshArguments& arguments) {
  PiecesOptions options{.pieces = arguments.piece_count};
#ifdef SURFMESH_HAS_METIS
  if (arguments.by_metis) options.deal = deal_by_metis;
#endif
  return options;
}

int mesh_in_pieces(const MeshArguments& arguments, Exchange& exchange,
                   const std::function<void(int)>& abort_all) {
  catch_signals();
  const bool is_first = exchange.rank() == 0;
  Progress progress(is_first && !arguments.is_quiet && is_terminal());
  try {
    return PiecesRun(arguments, exchange, progress).run();
  } catch (const AgreedError& error) {
    return tell_agreed_failure(error, exchange, progress);
  } catch (const std::exception& error) {
    be_silent(!is_first && caught_signal() != 0);
    const int status = tell_failure(error, progress);
    be_silent_on_signals();  // it is told, and to end the others takes a while
    if (abort_all) abort_all(status);
    return status;
  }
}

}  // namespace surfmesh
