// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <span>
#include <string>

#include "mesh_arguments.hh"
#include "progress.hh"
#include "read_model.hh"
#include "surfmesh/pipeline/report.hh"

namespace surfmesh {

/// The model of a run of `mesh`, with the clocks of the run.
class MeshInput {
 public:
  /// Throws   as read_model
  void read(const MeshArguments& arguments, Progress& progress);

  const ModelInput& input() const { return model_.input; }

  /// Throws   Io where an output, if its path is not empty, would replace a file that was read
  void check_not_replaced(std::span<const std::string> outputs) const;

  /// Tell in a report what the run was asked for.
  void describe(const std::string& path, Report& report) const;

  double seconds_so_far() const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  ReadModel model_;
  double read_seconds_ = 0;
};

/// How a run ends that made what the report tells of.
int status_of(const Report& report);

}  // namespace surfmesh
