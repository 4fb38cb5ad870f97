// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/copy_mesh.hh"

#include <string>

namespace surfmesh {
namespace {

/// Hand clones of some properties to `add`, but for those that `has` knows by their names: points,
/// which each mesh has from the start.
template <class Iterator, class Has, class Add>
void copy_properties(Iterator first, Iterator last, Has has, Add add) {
  for (; first != last; ++first) {
    if (*first == nullptr || has((*first)->name())) continue;
    std::unique_ptr<OpenMesh::BaseProperty> clone((*first)->clone());
    add(clone.get());
    clone.release();
  }
}

/// Copy into a new mesh.
void copy_into(const PolyMesh& mesh, PolyMesh& to) {
  to.assign(mesh);
  copy_properties(
      mesh.vprops_begin(), mesh.vprops_end(),
      [&](const std::string& name) { return to._get_vprop(name) != nullptr; },
      [&](OpenMesh::BaseProperty* property) { to._add_vprop(property); });
  copy_properties(
      mesh.hprops_begin(), mesh.hprops_end(),
      [&](const std::string& name) { return to._get_hprop(name) != nullptr; },
      [&](OpenMesh::BaseProperty* property) { to._add_hprop(property); });
  copy_properties(
      mesh.eprops_begin(), mesh.eprops_end(),
      [&](const std::string& name) { return to._get_eprop(name) != nullptr; },
      [&](OpenMesh::BaseProperty* property) { to._add_eprop(property); });
  copy_properties(
      mesh.fprops_begin(), mesh.fprops_end(),
      [&](const std::string& name) { return to._get_fprop(name) != nullptr; },
      [&](OpenMesh::BaseProperty* property) { to._add_fprop(property); });
}

}  // namespace

std::unique_ptr<PolyMesh> copy_of(const PolyMesh& mesh) {
  auto copy = std::make_unique<PolyMesh>();
  copy_into(mesh, *copy);
  return copy;
}

CopiedMesh::CopiedMesh(const CopiedMesh& other) : PolyMesh() { copy_into(other, *this); }

}  // namespace surfmesh
