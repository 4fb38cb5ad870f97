// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/file_writer.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/shared_vertices.hh"

namespace surfmesh {
namespace {

/// Pieces that are in memory at a time, half a megabyte each: enough for many threads.
constexpr std::size_t kPiecesInMemory = 64;

}  // namespace

void FileWriter::pieces(std::size_t count,
                        const std::function<void(std::size_t, std::size_t, TextBuffer&)>& format) {
  const std::size_t piece_count = (count + kPiece - 1) / kPiece;
  std::vector<TextBuffer> buffers(std::min(piece_count, kPiecesInMemory));
  for (std::size_t done = 0; done < piece_count; done += buffers.size()) {
    const std::size_t now = std::min(buffers.size(), piece_count - done);
    share_indices(now, [&](std::size_t i) {
      const std::size_t first = (done + i) * kPiece;
      buffers[i].clear();
      format(first, std::min(count, first + kPiece), buffers[i]);
    });
    for (std::size_t i = 0; i < now; ++i) text(buffers[i].text());
  }
}

void check_finite(const OpenMesh::Vec3d& point, VertexHandle vh) {
  if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2])) return;
  throw Error(ErrorCode::Geometry, fmt::format("the position of vertex {} is ({}, {}, {})",
                                               vh.idx(), point[0], point[1], point[2]));
}

void write_points(const PolyMesh& mesh, std::string_view first_word, FileWriter& writer) {
  const SharedVertices vertices(mesh);
  writer.pieces(mesh.n_vertices(), [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
    for (std::size_t v = first; v < end; ++v) {
      const VertexHandle vh(static_cast<int>(v));
      if (!vertices.is_first(vh)) continue;
      const OpenMesh::Vec3d& point = mesh.point(vh);
      check_finite(point, vh);
      if (first_word.empty()) {
        buffer.number('\n', point[0]);
      } else {
        buffer.text("\n");
        buffer.text(first_word);
        buffer.number(' ', point[0]);
      }
      buffer.number(' ', point[1]);
      buffer.number(' ', point[2]);
    }
  });
}

}  // namespace surfmesh
