// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>

#include "surfmesh_cad/read_cad.hh"

// What reads CAD files, for the other module, which is built of the same sources.
PYBIND11_MODULE(_surfmesh_cad, module) {
  module.doc() = "Reads STEP, IGES and BREP files by OpenCASCADE for surfmesh.";
  module.attr("reader") = pybind11::capsule(reinterpret_cast<void*>(&surfmesh::read_cad));
}
