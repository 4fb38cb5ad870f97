// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <cstdio>
#include <iostream>
#include <streambuf>

namespace surfmesh {

/// OpenCASCADE prints nothing while this exists: a library must not write to the terminal.
class QuietMessages {
 public:
  QuietMessages() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~QuietMessages() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
  QuietMessages(const QuietMessages&) = delete;
  QuietMessages& operator=(const QuietMessages&) = delete;

 private:
  Message_SequenceOfPrinters printers_;
};

/// Nothing comes out at std::cout while this exists: readers write there.
class QuietOutput {
 public:
  QuietOutput() : buffer_(std::cout.rdbuf(&nothing_)) {}
  ~QuietOutput() { std::cout.rdbuf(buffer_); }
  QuietOutput(const QuietOutput&) = delete;
  QuietOutput& operator=(const QuietOutput&) = delete;

 private:
  /// Takes all that is written.
  class Nothing : public std::streambuf {
    int overflow(int c) override { return c == EOF ? 0 : c; }
  };

  Nothing nothing_;
  std::streambuf* buffer_;
};

}  // namespace surfmesh
