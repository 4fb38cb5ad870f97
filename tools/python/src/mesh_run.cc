// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hh"
#include "held_mesh.hh"
#include "held_sources.hh"
#include "model_input.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/pipeline/check_mesh.hh"
#include "surfmesh/pipeline/option_table.hh"
#include "surfmesh/pipeline/set_option.hh"
#include "watched_run.hh"

namespace surfmesh::python {
namespace {

namespace py = pybind11;

using Input = std::shared_ptr<const HeldInput>;

/// What one run is asked for, made with the GIL. The model is shared, unless contours of it are
/// named.
struct Request {
  Request(const HeldInput& held, const HeldSources& more, const Settings& settings)
      : sources(held.input.sources), options(held.input.options), given(held.given) {
    append(more.sources, sources);
    for (const auto& [name, value] : settings) {
      set_option(options, name, value);
      add_given({name, value, OptionOrigin::Python}, given);
    }
  }

  Sources sources;
  PipelineOptions options;
  std::vector<GivenOption> given;
};

/// The model with contours named along which sizes are asked for; null if there are none.
std::unique_ptr<const Model> with_named(const Model& model, const std::set<int>& along) {
  if (along.empty()) return nullptr;
  auto named = std::make_unique<Model>(model);
  for (const int contour : along) named->contour(contour).is_named = true;
  return named;
}

/// What is not known to the library of a report.
void describe(const HeldInput& held, const Request& request, double wall_seconds, Report& report) {
  report.input = held.path;
  report.files = held.input.files;
  report.given = request.given;
  report.seconds[Stage::Read] = held.read_seconds;
  report.wall_seconds = wall_seconds;
}

class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::shared_ptr<HeldMesh> mesh(const HeldInput& held, const HeldSources& more,
                               const Settings& settings, const py::object& progress) {
  const Clock clock;
  const Request request(held, more, settings);
  const auto named = with_named(held.input.model, more.along);
  const Model& model = named ? *named : held.input.model;
  std::unique_ptr<MeshResult> result;
  run_watched(progress, [&](Observer& observer) {
    result.reset(new MeshResult(mesh_model(model, request.sources, request.options, &observer)));
    describe(held, request, clock.seconds(), result->report);
  });
  return std::make_shared<HeldMesh>(std::unique_ptr<const MeshResult>(std::move(result)));
}

/// The report of an estimate as JSON text.
std::string estimate(const HeldInput& held, const HeldSources& more, const Settings& settings,
                     const py::object& progress) {
  const Clock clock;
  const Request request(held, more, settings);
  const auto named = with_named(held.input.model, more.along);
  Report report;
  run_watched(progress, [&](Observer& observer) {
    report = estimate_mesh(named ? *named : held.input.model, request.sources, request.options,
                           &observer);
  });
  describe(held, request, clock.seconds(), report);
  return to_json(report);
}

/// Sizes asked for in the call judge a mesh; otherwise those that it was made by do. A sag is a
/// distance, no size.
JudgedBy judged_by(const Settings& settings) {
  const bool asks_for_sizes =
      std::any_of(settings.begin(), settings.end(), [](const auto& setting) {
        return find_option(setting.first).group == OptionGroup::Sizes &&
               setting.first != ranges::kSag.name;
      });
  return asks_for_sizes ? JudgedBy::SizesOfRun : JudgedBy::StoredMetric;
}

/// What a model asks of a mesh that is checked; nothing without one.
std::optional<Request> request_of(const Input& model, const HeldSources& more,
                                  const Settings& settings) {
  if (!model) return {};
  return std::make_optional<Request>(*model, more, settings);
}

/// Measure a mesh, and its fit to a model if there is one.
MeshCheck checked(const MeshArraysFile& faces, const MeshFile& file, const Input& model,
                  const std::optional<Request>& request, const Settings& settings,
                  Observer& observer) {
  MeshCheck check = check_mesh(faces, &observer);
  check.stored = measure_stored_metric(file.mesh);
  if (!request) return check;
  ModelInput input = model->input;
  input.sources = request->sources;
  input.options = request->options;
  append(input.model.notices, check.notices);
  check.patch_names = mesh_names(input.model).patches;
  MeshFile measured = file;
  add_fit(check, measure_fit(measured, input, judged_by(settings), &observer));
  check.model = model->path;
  return check;
}

std::string check_file(const std::filesystem::path& path, const Input& model,
                       const HeldSources& more, const Settings& settings,
                       const py::object& progress) {
  const auto request = request_of(model, more, settings);
  MeshCheck check;
  run_watched(progress, [&](Observer& observer) {
    check = checked(read_mesh_arrays(path), read_mesh(path), model, request, settings, observer);
  });
  check.mesh = path.string();
  return to_json(check);
}

std::string check_held(const HeldMesh& held, const Input& model, const HeldSources& more,
                       const Settings& settings, const py::object& progress) {
  const auto request = request_of(model, more, settings);
  MeshCheck check;
  run_watched(progress, [&](Observer& observer) {
    MeshArraysFile faces;
    faces.mesh = mesh_arrays(held.mesh(), held.names(), ArrayParts::Faces);
    const MeshFile file{held.mesh(), held.names(), {}};
    check = checked(faces, file, model, request, settings, observer);
  });
  return to_json(check);
}

}  // namespace

void bind_runs(py::module_& module) {
  module.def("mesh", &mesh, py::arg("model"), py::arg("sources"), py::arg("settings"),
             py::arg("progress"), "Mesh a model.");
  module.def("estimate", &estimate, py::arg("model"), py::arg("sources"), py::arg("settings"),
             py::arg("progress"), "The report of an estimate as JSON text.");
  module.def("check_file", &check_file, py::arg("path"), py::arg("model"), py::arg("sources"),
             py::arg("settings"), py::arg("progress"), "Check a mesh file; JSON text.");
  module.def("check_held", &check_held, py::arg("mesh"), py::arg("model"), py::arg("sources"),
             py::arg("settings"), py::arg("progress"), "Check a mesh; JSON text.");
}

}  // namespace surfmesh::python
