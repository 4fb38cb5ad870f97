// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.hh"

#include <vector>

namespace surfmesh {

OutputFile& Outputs::add(const std::filesystem::path& path) {
  return outputs_.emplace_back(path).file;
}

void Outputs::commit(int status) {
  std::vector<OutputFile*> files;
  for (Output& output : outputs_) files.push_back(&output.file);
  // This may take a while, on a slow disk.
  for (OutputFile* file : files) file->finish();
  commit_against_signals(status, [&] { OutputFile::commit_all(files); });
}

}  // namespace surfmesh
