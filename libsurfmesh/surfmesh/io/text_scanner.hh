// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Splits a text into lines and words and counts the lines, for readers of line-based formats.
///
/// Words are separated by blanks. A word that begins with # starts a comment, up to the end of the
/// line. Lines end with LF, CR LF or CR. Reading numbers does not depend on the locale.
class TextScanner {
 public:
  /// Whether a backslash at the end of a line joins it with the next.
  enum class Joining { Off, Backslash };

  /// The text must outlive the scanner. `name` is for messages.
  /// Throws   InvalidInput if the text contains a NUL byte, naming its line
  TextScanner(std::string_view text, std::string name, Joining joining);

  /// Go to the next line with a word; false at the end of the text.
  bool next_line();

  /// The next word of this line; empty at the end of the line.
  std::string_view next_word();

  /// The line of the last word, from 1.
  int line() const { return line_; }

  /// Read a word as a finite number; `what` names it in the message.
  /// Throws   InvalidInput
  double to_number(std::string_view word, std::string_view what) const;

  /// Read a word as an integer; `what` names it in the message.
  /// Throws   InvalidInput
  int to_integer(std::string_view word, std::string_view what) const;

  /// Read the next three words as a position.
  /// Throws   InvalidInput
  Vec3 next_point();

  /// Throw InvalidInput with "name:line: reason", for the current line or another.
  [[noreturn]] void fail(std::string_view reason) const { fail_at(line_, reason); }
  [[noreturn]] void fail_at(int line, std::string_view reason) const;

  /// Throw InvalidInput with "name: reason", for errors of the file as a whole.
  [[noreturn]] void fail_whole(std::string_view reason) const;

  const std::string& name() const { return name_; }

 private:
  bool is_at_join() const;
  void skip_blanks();
  void skip_line_end();

  const char* position_;
  const char* end_;
  std::string name_;
  Joining joining_;
  int line_ = 1;
  bool is_inside_line_ = false;
};

/// A word as messages show it: in quotes, at most 40 bytes, unprintable ones as '?'.
std::string quoted(std::string_view word);

/// Warnings from reading one file. The first of each kind is kept and the others are counted, so
/// that a bad file of a million lines does not give a million warnings.
class WarningList {
 public:
  explicit WarningList(std::string name) : name_(std::move(name)) {}

  /// Warn about a line. Two warnings are of the same kind if their `kind` is equal.
  void add(int line, std::string text, std::string_view kind);
  void add(int line, const std::string& text) { add(line, text, text); }

  /// The warnings as "name:line: text", in the order of the lines.
  Notices notices() const;

 private:
  struct Entry {
    std::string kind;
    std::string text;
    int line = 0;
    int more = 0;
  };

  std::string name_;
  std::vector<Entry> entries_;
};

}  // namespace surfmesh
