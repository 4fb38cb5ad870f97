// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>

#include <filesystem>

#include "surfmesh_cad/read_cad.hh"

namespace {

surfmesh::Model read(const std::filesystem::path& path, const surfmesh::CadOptions& options) {
  return surfmesh::read_cad(path, options);
}

}  // namespace

// What reads CAD files, for the other module, which is built of the same sources.
PYBIND11_MODULE(_surfmesh_cad, module) {
  module.doc() = "Reads STEP, IGES and BREP files by OpenCASCADE for surfmesh.";
  module.attr("reader") = pybind11::capsule(reinterpret_cast<void*>(&read));
}
