// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/targets.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/observer.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh::fuzz {

/// Throws   Finding unless it holds
inline void demand(bool holds, std::string_view law) {
  if (!holds) throw Finding(std::string(law));
}

/// Call what may refuse its input: with an Error that has a text.
/// Returns  whether it did not
template <class Body>
bool accepts(Body body) {
  try {
    body();
    return true;
  } catch (const Error& error) {
    demand(error.what()[0] != '\0', "an error tells its reason");
    return false;
  }
}

/// The formats for which something holds.
template <class Predicate>
std::vector<const MeshFormat*> formats_that(Predicate holds) {
  std::vector<const MeshFormat*> formats;
  for (const MeshFormat& format : mesh_formats()) {
    if (holds(format)) formats.push_back(&format);
  }
  return formats;
}

/// A folder in memory, if the system has one, for the files of this program; removed at its end.
/// With SURFMESH_FUZZ_KEEP=FOLDER it is that one, which stays.
const std::filesystem::path& scratch_folder();

/// Replaces a file of the scratch folder.
/// Returns  its path
std::filesystem::path write_scratch(const std::string& name, std::string_view text);

/// Ends a run after so many seconds of processor time.
class Deadline final : public Observer {
 public:
  explicit Deadline(double seconds);

  void progress(std::string_view, std::size_t, std::size_t) override {}
  bool is_cancelled() override;

 private:
  double end_;
};

/// Check a model that was accepted: its indices, and that surfaces and contours can be evaluated,
/// or tell with an Error of code Geometry where not.
void check_usable(const Model& model);

/// Check the half-edge structure: of meshes in parameters, too, which have no positions.
void check_links(const PolyMesh& mesh, std::string_view stage);

/// Check the half-edge structure, and that positions are finite.
void check_proper(const PolyMesh& mesh, std::string_view stage);

}  // namespace surfmesh::fuzz
