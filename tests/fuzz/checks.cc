// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/checks.hh"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include "surfmesh/core/validate.hh"

namespace surfmesh::fuzz {
namespace {

double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

class Folder {
 public:
  Folder() {
    if (const char* kept = std::getenv("SURFMESH_FUZZ_KEEP")) {
      path_ = kept;
      is_kept_ = true;
    } else {
      const std::filesystem::path memory = "/dev/shm";
      const bool has_memory = access(memory.c_str(), W_OK) == 0;
      path_ = (has_memory ? memory : std::filesystem::temp_directory_path()) /
              ("surfmesh_fuzz." + std::to_string(getpid()));
    }
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    if (!is_kept_) std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool is_kept_ = false;
};

/// Points of a parameter from 0 to 1, its ends among them.
constexpr double kShares[] = {0, 0.3, 0.5, 1};

void check_surface(const Surface& surface) {
  const Domain domain = surface.domain();
  for (const double s : kShares) {
    for (const double t : kShares) {
      accepts([&] {
        const Jet jet = surface.evaluate(domain.fold(domain.at(s, t)), Order::Second);
        demand(jet.point.allFinite(), "points of surfaces are finite");
      });
    }
  }
}

}  // namespace

const std::filesystem::path& scratch_folder() {
  static const Folder folder;
  return folder.path();
}

std::filesystem::path write_scratch(const std::string& name, std::string_view text) {
  const std::filesystem::path path = scratch_folder() / name;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path.string());
  return path;
}

Deadline::Deadline(double seconds) : end_(processor_seconds() + seconds) {}

bool Deadline::is_cancelled() { return processor_seconds() > end_; }

void check_usable(const Model& model) {
  if (!accepts([&] { check(model); })) return;
  check_indices(model);
  for (const Patch& patch : model.patches) check_surface(*patch.surface);
  for (const Contour& contour : model.contours) {
    for (const ContourUse& use : contour.uses) {
      for (const double t : kShares) {
        accepts([&] { demand(model.point(use, t).allFinite(), "points of contours are finite"); });
      }
    }
  }
}

void check_links(const PolyMesh& mesh, std::string_view stage) {
  const std::vector<std::string> faults = find_faults(mesh);
  demand(faults.empty(),
         std::string(stage) + ": " + (faults.empty() ? std::string() : faults.front()));
}

void check_proper(const PolyMesh& mesh, std::string_view stage) {
  check_links(mesh, stage);
  for (const VertexHandle vh : mesh.vertices()) {
    demand(mesh.is_isolated(vh) || to_eigen(mesh.point(vh)).allFinite(),
           std::string(stage) + ": a position is not finite");
  }
}

}  // namespace surfmesh::fuzz
