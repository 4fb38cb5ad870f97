// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/piece_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/formats/piece_points.hh"
#include "surfmesh/io/file_at_offsets.hh"

namespace surfmesh {
namespace {

/// Text that is written to the spool at once.
constexpr std::size_t kBlock = std::size_t{1} << 18;

void flush(TextBuffer& buffer, SpoolFile& spool) {
  spool.write(buffer.text());
  buffer.clear();
}

/// The vertices that a piece writes, ascending by their ids: those that no piece before it has.
std::vector<std::size_t> own_vertices(int piece, const MeshPiece& mesh) {
  std::vector<char> is_own(mesh.points.size(), 1);
  for (const SharedWithPiece& shared : mesh.neighbours) {
    if (shared.piece > piece) continue;
    for (const int vertex : shared.vertices) is_own[static_cast<std::size_t>(vertex)] = 0;
  }
  std::vector<std::size_t> own;
  for (std::size_t v = 0; v < is_own.size(); ++v) {
    if (is_own[v]) own.push_back(v);
  }
  const auto by_id = [&](std::size_t a, std::size_t b) { return mesh.ids[a] < mesh.ids[b]; };
  if (!std::is_sorted(own.begin(), own.end(), by_id)) std::sort(own.begin(), own.end(), by_id);
  return own;
}

}  // namespace

PieceFile::PieceFile(std::filesystem::path path, Exchange& exchange)
    : path_(std::move(path)), exchange_(exchange) {}

void PieceFile::make_file(const PieceIndex& index) {
  text_ = piece_text(path_, index);
  if (exchange_.rank() != 0) return;
  file_ = std::make_unique<OutputFile>(path_);
  temporary_ = file_->temporary();
  if (!temporary_.empty()) return;
  throw Error(ErrorCode::Io, fmt::format("cannot write {}: it is no file, into which ranks could "
                                         "write at any place",
                                         path_.string()));
}

void PieceFile::begin(const PieceIndex& index) {
  agree_on_errors_of(exchange_, [&] { make_file(index); });
  temporary_ = text_of_rank_0(exchange_, temporary_.string());
  agree_on_errors_of(exchange_, [&] {
    vertices_.emplace(temporary_.parent_path());
    faces_.emplace(temporary_.parent_path());
  });
}

void PieceFile::write(int piece, const MeshPiece& mesh) {
  check_points(mesh);
  add_vertices(mesh, own_vertices(piece, mesh));
  add_faces(piece, mesh);
}

void PieceFile::add_vertices(const MeshPiece& mesh, const std::vector<std::size_t>& own) {
  std::vector<VertexRun>& runs = parts_.vertices;
  TextBuffer buffer;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::int64_t id = mesh.ids[own[i]];
    const bool goes_on = i > 0 && id == runs.back().first_id + runs.back().count;
    if (!goes_on) runs.push_back({id, 0, 0});
    const std::size_t before = buffer.size();
    text_->add_vertex(mesh.points[own[i]], buffer);
    ++runs.back().count;
    runs.back().bytes += buffer.size() - before;
    if (buffer.size() >= kBlock) flush(buffer, *vertices_);
  }
  flush(buffer, *vertices_);
}

void PieceFile::add_faces(int piece, const MeshPiece& mesh) {
  if (mesh.faces.empty()) return;
  const std::uint64_t before = faces_->size();
  TextBuffer buffer;
  std::vector<std::int64_t> ids;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const int patch = mesh.patches[f];
    const bool is_new = f == 0 || patch != mesh.patches[f - 1];
    if (is_new) parts_.patches.push_back({piece, patch});
    if (is_new && f > 0) buffer.text(text_->before_patch(patch));
    ids.clear();
    for (const int vertex : mesh.faces[f])
      ids.push_back(mesh.ids[static_cast<std::size_t>(vertex)]);
    text_->add_face(ids, patch, buffer);
    if (buffer.size() >= kBlock) flush(buffer, *faces_);
  }
  flush(buffer, *faces_);
  parts_.faces.push_back({piece, mesh.patches.front(), mesh.patches.back(),
                          static_cast<std::int64_t>(mesh.faces.size()), faces_->size() - before});
}

void PieceFile::write_all(const PieceFileLayout& layout) {
  FileAtOffsets file(temporary_, path_);
  if (exchange_.rank() == 0) {
    file.write(layout.head, 0);
    file.write(layout.before_faces, layout.before_faces_offset);
    file.write("\n", layout.end);
  }
  std::uint64_t first = 0;
  for (const VertexRun& run : parts_.vertices) {
    vertices_->copy(first, run.bytes, file, layout.vertices.at(run.first_id));
    first += run.bytes;
  }
  first = 0;
  for (const FaceText& faces : parts_.faces) {
    const auto [offset, before] = layout.faces.at(faces.piece);
    file.write(before, offset);
    faces_->copy(first, faces.bytes, file, offset + before.size());
    first += faces.bytes;
  }
  file.close();
}

void PieceFile::finish() {
  const PieceFileParts parts = parts_of_all_ranks(exchange_, parts_);
  agree_on_errors_of(exchange_, [&] { write_all(lay_out(parts, *text_)); });
}

void PieceFile::commit(OutputFile* with) {
  agree_on_errors_of(exchange_, [&] {
    if (!file_) return;
    std::vector<OutputFile*> files = {file_.get()};
    if (with) files.push_back(with);
    OutputFile::commit_all(files);
  });
  temporary_.clear();
}

}  // namespace surfmesh
