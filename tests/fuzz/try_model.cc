// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "fuzz/checks.hh"
#include "fuzz/targets.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/report.hh"

namespace surfmesh::fuzz {
namespace {

constexpr double kSeconds = 1;
constexpr std::size_t kMostElements = 20000;

bool write_seed_files() {
  for (const Seed& seed : seed_files()) write_scratch(seed.name, seed.bytes);
  return true;
}

}  // namespace

bool try_model(Bytes bytes) {
  static const bool has_files = write_seed_files();
  demand(has_files, "the files beside the model are written");
  const auto path = write_scratch("model.json", std::string(bytes.begin(), bytes.end()));
  return accepts([&] {
    Deadline deadline(kSeconds);
    ModelInput input = load_model(path, {}, &deadline);
    check_usable(input.model);
    input.options.threads = 1;
    input.options.max_elements = kMostElements;
    const Report report = estimate_mesh(input.model, input.sources, input.options, &deadline);
    demand(report.estimated_elements >= 0, "the number of elements is estimated");
    demand(!to_json(report).empty() && !to_text(report).empty(), "reports can be written");
  });
}

}  // namespace surfmesh::fuzz
