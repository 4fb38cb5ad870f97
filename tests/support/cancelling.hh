// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/observer.hh"

namespace surfmesh::testing {

/// Cancels a run as soon as it is asked.
class Cancelling : public Observer {
 public:
  void progress(std::string_view, std::size_t, std::size_t) override {}
  bool is_cancelled() override { return true; }
};

inline constexpr const char* kCancelled = "cancelled: the run was cancelled";

}  // namespace surfmesh::testing
