// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hh"
#include "bindings.hh"
#include "functions.hh"
#include "model_input.hh"
#include "surfmesh/cage/creases.hh"
#include "surfmesh/core/at_location.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/formula/formula_curve.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/model/append_model.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/nurbs/nurbs_curve.hh"
#include "surfmesh/nurbs/nurbs_surface.hh"
#include "surfmesh/nurbs/sampled_surface.hh"
#include "surfmesh/pipeline/option_table.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh::python {
namespace {

using Loops = std::vector<std::vector<std::string>>;
using Constants = std::map<std::string, double>;
using Range = std::pair<double, double>;

/// Sides of sampled patches may be as far apart as both surfaces are from their functions, and the
/// errors are measured, not bounded.
constexpr double kJoiningPerError = 4;

struct NamedCage {
  std::string name;
  Cage cage;
};

/// The parts of a model until it is made.
struct Builder {
  std::vector<PatchInput> patches;
  std::vector<ContourInput> contours;
  std::vector<NamedCage> cages;
  std::vector<Group> groups;  ///< with indices of `patches`
  double greatest_error = 0;  ///< of sampled patches, model units
};

Domain domain_of(const Range& u, const Range& v) { return {u.first, u.second, v.first, v.second}; }

std::vector<NamedFormula> named(const std::vector<std::pair<std::string, std::string>>& where) {
  std::vector<NamedFormula> formulas;
  for (const auto& [name, text] : where) formulas.push_back({name, text});
  return formulas;
}

int add(Builder& builder, PatchInput patch) {
  builder.patches.push_back(std::move(patch));
  return static_cast<int>(builder.patches.size()) - 1;
}

void add_formulas(Builder& builder, const std::string& name, const std::array<std::string, 3>& xyz,
                  const std::vector<std::pair<std::string, std::string>>& where,
                  const Constants& constants, const Range& u, const Range& v, const Loops& loops) {
  const SurfaceFormulas formulas{xyz[0], xyz[1], xyz[2], named(where)};
  add(builder,
      {name, std::make_shared<const FormulaSurface>(formulas, domain_of(u, v), constants), loops});
}

/// Returns  error, (u,v) of the error, samples along u and v, evaluations, diagonal of the samples
py::tuple add_function_patch(Builder& builder, const std::string& name, const py::object& function,
                             const Range& u, const Range& v, const Loops& loops,
                             const std::string& tolerance, std::size_t max_samples) {
  const Sampling sampling =
      sample_surface(surface_function(function), domain_of(u, v),
                     {.tolerance = parse_length(tolerance), .max_samples = max_samples});
  builder.greatest_error = std::max(builder.greatest_error, sampling.error);
  add(builder, {name, sampling.surface, loops});
  return py::make_tuple(sampling.error, py::make_tuple(sampling.worst.u, sampling.worst.v),
                        py::make_tuple(sampling.columns, sampling.rows), sampling.evaluations);
}

/// A spline through points (rows along v, columns along u, 3).
void add_grid(Builder& builder, const std::string& name, const Doubles& points, const Range& u,
              const Range& v, const Loops& loops) {
  PointGrid grid{
      static_cast<std::size_t>(points.shape(1)), static_cast<std::size_t>(points.shape(0)), {}};
  for (py::ssize_t i = 0; i < points.size(); i += 3) {
    grid.points.emplace_back(points.data()[i], points.data()[i + 1], points.data()[i + 2]);
  }
  add(builder, {name, std::make_shared<const SampledSurface>(domain_of(u, v), grid), loops});
}

/// Rows of control points along u, as of NurbsNet.
void add_nurbs(Builder& builder, const std::string& name, const Doubles& points,
               const std::array<std::vector<double>, 2>& knots, const std::array<int, 2>& degree,
               const std::optional<Doubles>& weights, const std::array<bool, 2>& periodic,
               const std::optional<std::pair<Range, Range>>& domain, const Loops& loops) {
  NurbsNet net{.degree = degree, .knots = knots, .periodic = periodic};
  const auto all = points.unchecked<3>();
  for (py::ssize_t j = 0; j < all.shape(0); ++j) {
    std::vector<Vec3>& row = net.points.emplace_back();
    for (py::ssize_t i = 0; i < all.shape(1); ++i) {
      row.emplace_back(all(j, i, 0), all(j, i, 1), all(j, i, 2));
    }
    if (!weights) continue;
    const double* const first = weights->data() + j * all.shape(1);
    net.weights.emplace_back(first, first + all.shape(1));
  }
  auto surface =
      domain ? std::make_shared<const NurbsSurface>(net, domain_of(domain->first, domain->second))
             : std::make_shared<const NurbsSurface>(net);
  add(builder, {name, std::move(surface), loops});
}

/// A contour on a patch: a polyline with the contour's kinks, or a smooth curve.
std::shared_ptr<const Curve> curve_through(const Doubles& points, bool is_smooth) {
  std::vector<Uv> uvs = uvs_from(points);
  if (is_smooth) return std::make_shared<const SampledCurve>(uvs);
  NurbsPolygon polygon{.degree = 1, .points = uvs};
  const std::size_t last = uvs.size() - 1;
  polygon.knots.push_back(0);
  for (std::size_t i = 0; i <= last; ++i) {
    polygon.knots.push_back(static_cast<double>(i) / static_cast<double>(last));
  }
  polygon.knots.push_back(1);
  return std::make_shared<const NurbsCurve>(polygon);
}

ContourInput& contour_of(Builder& builder, const std::string& name) {
  const auto found = std::find_if(builder.contours.begin(), builder.contours.end(),
                                  [&](const ContourInput& c) { return c.name == name; });
  if (found != builder.contours.end()) return *found;
  return builder.contours.emplace_back(ContourInput{.name = name});
}

void add_contour_points(Builder& builder, const std::string& name, const std::string& patch,
                        const Doubles& points, bool is_smooth) {
  auto curve = curve_through(points, is_smooth);
  ContourInput& contour = contour_of(builder, name);
  const auto* polyline = dynamic_cast<const NurbsCurve*>(curve.get());
  if (polyline && contour.on.empty()) contour.breaks = polyline->breaks();
  contour.on.push_back({patch, std::move(curve)});
}

void add_contour_formulas(Builder& builder, const std::string& name, const std::string& patch,
                          const std::array<std::string, 2>& uv, const Range& t,
                          const Constants& constants) {
  const CurveRange range{t.first, t.second};
  auto curve =
      std::make_shared<const FormulaCurve>(CurveFormulas{uv[0], uv[1], {}}, range, constants);
  ContourInput& contour = contour_of(builder, name);
  contour.range = range;
  contour.on.push_back({patch, std::move(curve)});
}

void add_contour_projection(Builder& builder, const std::string& name, const std::string& patch) {
  contour_of(builder, name).on.push_back({patch, nullptr});
}

/// What a cage has besides points and faces.
struct CageTags {
  std::vector<std::tuple<std::vector<int>, double>> creases;  ///< chains of vertices
  std::vector<std::tuple<int, double>> corners;
  std::vector<int> holes;
  std::vector<std::pair<std::string, std::vector<int>>> groups;
  std::vector<std::pair<std::string, double>> group_creases;  ///< around groups
};

Cage cage_of(const Doubles& points, const Ints& corners, const Ints& offsets,
             const CageTags& tags) {
  Cage cage;
  cage.points = points_from(points);
  for (py::ssize_t f = 0; f + 1 < offsets.size(); ++f) {
    const int* const begin = corners.data() + offsets.data()[f];
    cage.faces.emplace_back(begin, corners.data() + offsets.data()[f + 1]);
  }
  check_ranges(cage);
  for (const auto& [group, faces] : tags.groups) cage.groups.push_back({group, faces});
  for (const auto& [chain, sharpness] : tags.creases) add_crease(chain, sharpness, cage);
  for (const auto& [group, sharpness] : tags.group_creases) {
    add_crease_around(group, sharpness, cage);
  }
  for (const auto& [vertex, sharpness] : tags.corners) cage.corners.push_back({vertex, sharpness});
  cage.holes = tags.holes;
  return cage;
}

/// The options that act where a model is made, as the model's report has them.
void note_options(const Settings& settings, ModelInput& input) {
  for (const auto& [name, value] : settings) {
    if (find_option(name).group != OptionGroup::Cages) continue;
    set_option(input.options, name, value);
    const std::string text = find_option(name).value_text(input.options);
    if (text == find_option(name).value_text({})) continue;
    const MadeWith made{name, text};
    auto& known = input.model.made_with;
    if (std::find(known.begin(), known.end(), made) == known.end()) known.push_back(made);
  }
}

Model patches_of(const Builder& builder, const LoadOptions& options) {
  JoinOptions joining{options.joining.value_or(JoinOptions().joining)};
  const double error = kJoiningPerError * builder.greatest_error;
  Model model = model_from_patches(builder.patches, builder.contours, joining);
  if (!options.joining && error > model.joining) {
    joining.joining = Length::units(error);
    model = model_from_patches(builder.patches, builder.contours, joining);
  }
  for (const Group& group : builder.groups) model.groups.push_back(group);
  return model;
}

void add_cages(const Builder& builder, const LoadOptions& options, Model& model) {
  const bool is_only = builder.cages.size() == 1 && builder.patches.empty();
  for (const NamedCage& named : builder.cages) {
    Model part =
        at_location(named.name, [&] { return model_from_cage(named.cage, options.cages); });
    if (is_only && named.name.empty()) {
      model = std::move(part);
      return;
    }
    Group& whole = part.groups.emplace_back();
    whole.name = named.name;
    for (std::size_t p = 0; p < part.patches.size(); ++p) {
      whole.patches.push_back(static_cast<int>(p));
    }
    append(model, std::move(part), named.name + ":");
  }
}

std::shared_ptr<HeldInput> build(const Builder& builder, const Settings& settings,
                                 const std::string& scheme) {
  if (builder.patches.empty() && builder.cages.empty()) {
    throw Error(ErrorCode::InvalidInput, "the model has no patches and no cages");
  }
  const LoadOptions options = load_options(settings, scheme);
  auto held = std::make_shared<HeldInput>();
  const py::gil_scoped_release release;
  const double start = processor_seconds();
  if (!builder.patches.empty()) held->input.model = patches_of(builder, options);
  add_cages(builder, options, held->input.model);
  note_options(settings, held->input);
  check(held->input.model);
  held->read_seconds = processor_seconds() - start;
  return held;
}

}  // namespace

void bind_builder(py::module_& module) {
  py::class_<Builder>(module, "Builder", "The parts of a model until it is made.")
      .def(py::init<>())
      .def("add_formulas", &add_formulas, py::arg("name"), py::arg("xyz"), py::arg("where"),
           py::arg("constants"), py::arg("u"), py::arg("v"), py::arg("loops"),
           "A patch of formulas.")
      .def("add_function", &add_function_patch, py::arg("name"), py::arg("function"), py::arg("u"),
           py::arg("v"), py::arg("loops"), py::arg("tolerance"), py::arg("max_samples"),
           "A patch of a function: error, its (u, v), samples, evaluations.")
      .def("add_grid", &add_grid, py::arg("name"), py::arg("points"), py::arg("u"), py::arg("v"),
           py::arg("loops"), "A patch through points.")
      .def("add_nurbs", &add_nurbs, py::arg("name"), py::arg("points"), py::arg("knots"),
           py::arg("degree"), py::arg("weights"), py::arg("periodic"), py::arg("domain"),
           py::arg("loops"), "A NURBS patch.")
      .def("add_contour_points", &add_contour_points, py::arg("name"), py::arg("patch"),
           py::arg("points"), py::arg("is_smooth"), "A contour through points on a patch.")
      .def("add_contour_formulas", &add_contour_formulas, py::arg("name"), py::arg("patch"),
           py::arg("uv"), py::arg("t"), py::arg("constants"), "A contour of formulas on a patch.")
      .def("add_contour_projection", &add_contour_projection, py::arg("name"), py::arg("patch"),
           "Another patch that a contour lies on.")
      .def(
          "take_contours",
          [](Builder& builder, const Builder& other) { builder.contours = other.contours; },
          py::arg("other"), "Have the contours of another builder instead.")
      .def(
          "add_cage",
          [](Builder& builder, const std::string& name, const Doubles& points, const Ints& corners,
             const Ints& offsets, const decltype(CageTags::creases)& creases,
             const decltype(CageTags::corners)& sharp_corners, const std::vector<int>& holes,
             const decltype(CageTags::groups)& groups,
             const decltype(CageTags::group_creases)& group_creases) {
            builder.cages.push_back(
                {name, cage_of(points, corners, offsets,
                               {creases, sharp_corners, holes, groups, group_creases})});
          },
          py::arg("name"), py::arg("points"), py::arg("corners"), py::arg("offsets"),
          py::arg("creases"), py::arg("sharp_corners"), py::arg("holes"), py::arg("groups"),
          py::arg("group_creases"), "A control cage.")
      .def(
          "add_group",
          [](Builder& builder, const std::string& name, const std::vector<int>& patches) {
            builder.groups.push_back({name, patches});
          },
          py::arg("name"), py::arg("patches"), "A group of patches, by their order.")
      .def("build", &build, py::arg("settings"), py::arg("scheme"), "Make the model.");
}

}  // namespace surfmesh::python
