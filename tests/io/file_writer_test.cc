// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/file_writer.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "support/folders.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

/// What `write` puts into a file.
template <class Write>
std::string written(Write write) {
  const TestFolder folder;
  const std::string path = folder / "file";
  OutputFile file(path);
  FileWriter writer(file);
  write(writer);
  writer.flush();
  file.commit();
  return read_text(path);
}

TEST(TextBuffer, HoldsTextNumbersAndBytes) {
  TextBuffer buffer;
  buffer.text("a");
  buffer.number(' ', std::numeric_limits<double>::lowest());
  buffer.number(',', -7);
  buffer.bytes(std::uint16_t{0x4142});
  buffer.big_endian(std::uint16_t{0x4142});
  EXPECT_EQ(buffer.text(), "a -1.7976931348623157e+308,-7BAAB");
  buffer.clear();
  EXPECT_EQ(buffer.size(), 0u);
  EXPECT_EQ(buffer.text(), "");
}

TEST(FileWriter, WritesPiecesInTheirOrderForAnyNumberOfThreads) {
  constexpr int count = 1'000'000;
  std::string expected = "begin";
  for (int i = 0; i < count; ++i) expected.append(" ").append(std::to_string(i));
  expected += " end";
  for (const int threads : {1, 2, 8}) {
    std::string text;
    with_threads(threads, [&] {
      text = written([&](FileWriter& writer) {
        writer.text("begin");
        writer.pieces(count, [](std::size_t first, std::size_t end, TextBuffer& buffer) {
          for (std::size_t i = first; i < end; ++i) buffer.number(' ', i);
        });
        writer.text(" end");
      });
    });
    EXPECT_TRUE(text == expected) << threads;
  }
}

TEST(FileWriter, WritesNoPieceOfNothing) {
  EXPECT_EQ(written([](FileWriter& writer) {
              writer.pieces(0, [](std::size_t, std::size_t, TextBuffer& b) { b.text("x"); });
            }),
            "");
}

TEST(FileWriter, ThrowsTheErrorOfTheFirstPieceThatFails) {
  const auto fail = [](std::size_t first, std::size_t, TextBuffer&) {
    if (first >= 3 * FileWriter::kPiece) throw std::runtime_error(std::to_string(first));
  };
  try {
    written([&](FileWriter& writer) { writer.pieces(20 * FileWriter::kPiece, fail); });
    ADD_FAILURE() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), std::to_string(3 * FileWriter::kPiece));
  }
}

TEST(FileWriter, PassesLongTextOn) {
  std::string text(3'000'000, 'x');
  const std::string found = written([&](FileWriter& writer) {
    writer.text("a");
    writer.text(text);
    writer.text("b");
  });
  text.insert(text.begin(), 'a');
  text.push_back('b');
  EXPECT_TRUE(found == text);
}

}  // namespace
}  // namespace surfmesh
