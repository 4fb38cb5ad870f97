// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Cuts a text into lines and words and counts the lines, for the readers of line-based formats.
///
/// Words are separated by blanks; a word that begins with # and all after it on its line is a
/// comment; lines end with LF, CR LF or CR. Numbers are read whatever the locale.
class TextScanner {
 public:
  /// Whether a backslash at the end of a line joins it with the next.
  enum class Joining { Off, Backslash };

  /// The text must outlive the scanner; `name` stands in messages.
  /// Throws   InvalidInput if there is a NUL byte, naming its line
  TextScanner(std::string_view text, std::string name, Joining joining);

  /// Go to the next line that has a word; false at the end of the text.
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

  /// Take three words as a position.
  /// Throws   InvalidInput
  Vec3 next_point();

  /// Throw InvalidInput with "name:line: reason", for the current line or another.
  [[noreturn]] void fail(std::string_view reason) const { fail_at(line_, reason); }
  [[noreturn]] void fail_at(int line, std::string_view reason) const;

  /// Throw InvalidInput with "name: reason", for faults of the file as a whole.
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

/// A word as it stands in messages: in quotes, at most 40 bytes, unprintable ones as '?'.
std::string quoted(std::string_view word);

/// Warnings of reading one file. Of each kind the first is kept and the others are counted, so
/// that a bad file of a million lines does not make a million warnings.
class WarningList {
 public:
  explicit WarningList(std::string name) : name_(std::move(name)) {}

  /// Warn at a line; two warnings are of one kind if their `kind` is the same.
  void add(int line, std::string text, std::string_view kind);
  void add(int line, const std::string& text) { add(line, text, text); }

  /// "name:line: text", in the order of the lines.
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
