// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_input.hh"

#include "exit_status.hh"
#include "output_paths.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {

void MeshInput::read(const MeshArguments& arguments, Progress& progress) {
  const double start = processor_seconds();
  model_ = read_model(arguments.input, arguments.scheme, arguments.settings(), progress);
  if (model_.input.options.sizing.sag) progress.expect_passes();
  read_seconds_ = processor_seconds() - start;
}

void MeshInput::check_not_replaced(std::span<const std::string> outputs) const {
  for (const std::string& path : outputs) {
    if (!path.empty()) check_not_overwritten(model_.input.files, path);
  }
}

void MeshInput::describe(const std::string& path, Report& report) const {
  report.input = path;
  report.files = model_.input.files;
  report.given = model_.given;
  report.seconds[Stage::Read] = read_seconds_;
}

double MeshInput::seconds_so_far() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

int status_of(const Report& report) { return has_shortfall(report.notices) ? kFellShort : kDone; }

}  // namespace surfmesh
