// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>

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

}  // namespace surfmesh
