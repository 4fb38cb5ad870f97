// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace surfmesh {

/// True for what separates words: a blank, a tabulator, an end of a line.
inline bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// The integer that a word is, with or without a sign; nothing if it is none.
std::optional<std::int64_t> integer_of(std::string_view word);

/// The number that a word is, which may be NaN or infinite: one that is out of range is 0 or
/// infinite. Nothing if it is none.
std::optional<double> real_of(std::string_view word);

/// Takes the numbers of a file one after the other, which are words of text or binary, as it is
/// told. In text, # begins a comment where it stands for one.
class NumberScanner {
 public:
  enum class Comments { Off, Hash };

  /// The bytes must outlive the scanner; `name` is for messages.
  NumberScanner(std::string_view bytes, std::string name, Comments comments = Comments::Off)
      : bytes_(bytes), name_(std::move(name)), has_comments_(comments == Comments::Hash) {}

  void set_text() { is_binary_ = false; }
  void set_binary(std::endian order) {
    is_binary_ = true;
    is_swapped_ = order != std::endian::native;
  }
  bool is_binary() const { return is_binary_; }

  std::size_t offset() const { return offset_; }
  std::size_t rest() const { return bytes_.size() - offset_; }
  void go_to(std::size_t offset) { offset_ = offset; }
  std::string_view bytes() const { return bytes_; }

  /// An integer of so many bytes, 4 or 8; `what` names it in messages.
  /// Throws   InvalidInput
  std::int64_t integer(int size, std::string_view what);

  /// A number of so many bytes, 4 or 8, which may be NaN or infinite.
  /// Throws   InvalidInput
  double number(int size, std::string_view what);

  /// The same, if it is finite.
  /// Throws   InvalidInput
  double finite(int size, std::string_view what);

  /// How many things follow, of which each takes `least` bytes of the file or more: so a count that
  /// lies makes no room for more.
  /// Throws   InvalidInput for a count below 0 or one that the rest of the file cannot hold
  std::size_t count(int size, std::size_t least, std::string_view what);

  /// In text, whatever `binary` is set to: the next word, and the rest of the line without its end.
  /// Empty at the end of the file.
  std::string_view word();
  std::string_view line();

  /// Throws   InvalidInput if the file ends before
  void skip(std::size_t count);

  /// Throw InvalidInput with "name:line: reason" in text and "name: byte N: reason" in binary,
  /// where the last number or word begins, or elsewhere.
  [[noreturn]] void fail(std::string_view reason) const { fail_at(last_, reason); }
  [[noreturn]] void fail_at(std::size_t offset, std::string_view reason) const;

  const std::string& name() const { return name_; }

 private:
  template <class Number>
  Number take();
  void skip_blanks();
  std::string_view number_word(std::string_view what);

  std::string_view bytes_;
  std::string name_;
  bool has_comments_;
  bool is_binary_ = false;
  bool is_swapped_ = false;
  std::size_t offset_ = 0;
  std::size_t last_ = 0;  ///< where the last number or word begins
};

}  // namespace surfmesh
