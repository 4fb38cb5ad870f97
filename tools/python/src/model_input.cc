// SPDX-License-Identifier: BSD-3-Clause
#include "model_input.hh"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>

#include "arrays.hh"
#include "bindings.hh"
#include "clean_names.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/pipeline/set_option.hh"
#include "watched_run.hh"

namespace surfmesh::python {
namespace {

constexpr std::array kSchemes = {
    std::pair{"auto", Scheme::Auto}, std::pair{"catmark", Scheme::CatmullClark},
    std::pair{"loop", Scheme::Loop}, std::pair{"bilinear", Scheme::Bilinear}};

/// The function of the module that is linked with OpenCASCADE; none if that was not built.
CadReader cad_reader() {
  try {
    const auto reader = py::module_::import("surfmesh._surfmesh_cad").attr("reader");
    using Read = Model (*)(const std::filesystem::path&, const CadOptions&);
    return reinterpret_cast<Read>(reader.cast<py::capsule>().get_pointer());
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ImportError)) throw;
    return {};
  }
}

std::shared_ptr<HeldInput> read(const std::filesystem::path& path, const Settings& settings,
                                const std::string& scheme, const py::object& progress) {
  auto held = std::make_shared<HeldInput>();
  held->path = path.string();
  LoadOptions options = load_options(settings, scheme);
  if (has_cad_ending(path)) options.read_cad = cad_reader();
  run_watched(progress, [&](Observer& observer) {
    const double start = processor_seconds();
    held->input = load_model(path, options, &observer);
    held->given = options_of_file(held->input.options, held->input.model);
    held->read_seconds = processor_seconds() - start;
  });
  return held;
}

/// Points of a patch, and derivatives up to an order, one array (n, 3) for each.
py::list evaluate(const HeldInput& held, int patch, const Doubles& uvs, int order) {
  const Surface& surface = held.input.model.surface(patch);
  const std::vector<Uv> places = uvs_from(uvs);
  constexpr std::array kCounts = {1, 3, 6};
  std::vector<std::vector<double>> rows(
      static_cast<std::size_t>(kCounts.at(static_cast<std::size_t>(order))));
  {
    const py::gil_scoped_release release;
    for (const Uv uv : places) {
      const Jet jet = surface.evaluate(uv, static_cast<Order>(order));
      const std::array values = {&jet.point, &jet.du, &jet.dv, &jet.duu, &jet.duv, &jet.dvv};
      for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].insert(rows[i].end(), values[i]->begin(), values[i]->end());
      }
    }
  }
  py::list arrays;
  for (auto& values : rows) arrays.append(to_array(std::move(values), 3));
  return arrays;
}

py::tuple domain(const HeldInput& held, int patch) {
  const Domain all = held.input.model.surface(patch).domain();
  return py::make_tuple(py::make_tuple(all.u0, all.u1), py::make_tuple(all.v0, all.v1));
}

py::tuple box(const HeldInput& held) {
  const auto& all = held.input.model.box;
  return py::make_tuple(py::make_tuple(all.min().x(), all.min().y(), all.min().z()),
                        py::make_tuple(all.max().x(), all.max().y(), all.max().z()));
}

py::dict effective_options(const HeldInput& held) {
  py::dict options;
  for (const std::string_view name : option_names()) {
    options[py::str(std::string(name))] = get_option(held.input.options, name);
  }
  return options;
}

}  // namespace

Scheme parse_scheme(const std::string& name) {
  const auto found = std::find_if(kSchemes.begin(), kSchemes.end(),
                                  [&](const auto& scheme) { return scheme.first == name; });
  if (found != kSchemes.end()) return found->second;
  fail_option("scheme", name, "auto, catmark, loop or bilinear");
}

LoadOptions load_options(const Settings& settings, const std::string& scheme) {
  PipelineOptions options;
  for (const auto& [name, value] : settings) set_option(options, name, value);
  return {.cages = {.scheme = parse_scheme(scheme),
                    .patches = options.patches,
                    .weld = options.weld,
                    .orient = options.orient,
                    .crease_angle = options.crease_angle,
                    .surface = options.surface,
                    .fit = options.fit},
          .joining = options.joining,
          .cad = {.sew = options.sew}};
}

void bind_input(py::module_& module) {
  py::class_<HeldInput, std::shared_ptr<HeldInput>>(module, "HeldInput",
                                                    "A model that C++ holds, and what it asks for.")
      .def(
          "find_patch",
          [](const HeldInput& held, const std::string& name) {
            return find_patch(held.input.model, name);
          },
          py::arg("name"), "The index of a patch.")
      .def(
          "find_group",
          [](const HeldInput& held, const std::string& name) {
            return find_group(held.input.model, name);
          },
          py::arg("name"), "The indices of the patches of a group.")
      .def(
          "patch_names",
          [](const HeldInput& held) { return clean_names(mesh_names(held.input.model).patches); },
          "Names of patches.")
      .def(
          "contour_names",
          [](const HeldInput& held) { return clean_names(mesh_names(held.input.model).contours); },
          "Names of contours.")
      .def(
          "groups",
          [](const HeldInput& held) {
            py::list list;
            for (const Group& group : mesh_names(held.input.model).groups) {
              list.append(py::make_tuple(clean_text(group.name), group.patches));
            }
            return list;
          },
          "Names of groups with their patches.")
      .def(
          "notices", [](const HeldInput& held) { return held.input.model.notices; },
          "What there is to tell of the model.")
      .def(
          "diagonal", [](const HeldInput& held) { return held.input.model.diagonal; },
          "Length of the diagonal of the box.")
      .def("box", &box, "Least and greatest coordinates.")
      .def("domain", &domain, py::arg("patch"), "Ranges of u and v.")
      .def("evaluate", &evaluate, py::arg("patch"), py::arg("uv"), py::arg("order"),
           "Points and derivatives.")
      .def("options", &effective_options, "Options as the file of the model sets them.")
      .def(
          "path", [](const HeldInput& held) { return held.path; }, "Its file, or \"\".");
  module.def("read", &read, py::arg("path"), py::arg("settings"), py::arg("scheme"),
             py::arg("progress"), "Read a model.");
}

}  // namespace surfmesh::python
