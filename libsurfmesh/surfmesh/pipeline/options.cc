// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/options.hh"

#include "surfmesh/pipeline/option_table.hh"

namespace surfmesh {

void check(const PipelineOptions& options) {
  for (const Option& option : option_table()) {
    std::visit([&](const auto& access) { check_option(*access.range, access.get(options)); },
               option.access);
  }
}

ElementKind element_kind(const PipelineOptions& options) {
  return options.quads.is_on ? ElementKind::Quads : ElementKind::Triangles;
}

}  // namespace surfmesh
