// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <variant>

#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh::python {

/// A mesh as Python holds it, of a run or of a file: neither can be moved.
class HeldMesh {
 public:
  explicit HeldMesh(std::unique_ptr<const MeshResult> result) : run_(std::move(result)) {}
  explicit HeldMesh(std::unique_ptr<const MeshFile> file) : file_(std::move(file)) {}

  const PolyMesh& mesh() const { return run_ ? run_->mesh : file_->mesh; }
  const MeshNames& names() const { return run_ ? run_->names : file_->names; }
  const Notices& notices() const { return run_ ? run_->report.notices : file_->notices; }
  /// Null for a mesh of a file.
  const Report* report() const { return run_ ? &run_->report : nullptr; }

 private:
  std::unique_ptr<const MeshResult> run_;
  std::unique_ptr<const MeshFile> file_;
};

}  // namespace surfmesh::python
