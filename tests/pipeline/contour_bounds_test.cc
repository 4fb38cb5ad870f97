// SPDX-License-Identifier: BSD-3-Clause
// What the nodes of contours have to hold, on many models and with sizes that differ across them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "support/model_folders.hh"
#include "surfmesh/boundary/contour_nodes.hh"
#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/control/surface_metric_field.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/load_model.hh"

namespace surfmesh {
namespace {

using testing::kModels;

/// Lengths of segments are integrated along their chords, not along their curves, and by a sum
/// whose error is below this share.
constexpr double kLengthError = 0.02;

/// Segments may be so many times the number that the finest patch wants.
constexpr double kMostSegments = 1.25;

/// A step of t that is short for every contour.
constexpr double kStep = 1e-5;

/// Between nodes of cells of two elements, sizes differ by as much as they grow in half an element.
constexpr double kDisagreement = 0.25;

struct BoundsCase {
  std::string name;  ///< of the model's file
  double grade = 0;
  bool has_sources = false;  ///< sizes that differ from patch to patch by up to twenty times
};

void PrintTo(const BoundsCase& bounds, std::ostream* out) {
  *out << bounds.name << (bounds.grade > 0 ? ", graded" : "")
       << (bounds.has_sources ? ", with sources" : "");
}

class ContourBounds : public ::testing::TestWithParam<BoundsCase> {
 protected:
  void SetUp() override {
    input_ = load_model(kModels / GetParam().name);
    input_.options.sizing.grade = GetParam().grade;
    if (GetParam().has_sources) add_sources();
    spaces_ = make_control_spaces(input_.model, input_.sources,
                                  resolve(input_.options.sizing, input_.model.diagonal),
                                  input_.options.control)
                  .spaces;
    for (std::size_t p = 0; p < spaces_.size(); ++p) {
      fields_.push_back(
          std::make_unique<SurfaceMetricField>(*input_.model.patches[p].surface, *spaces_[p]));
      pointers_.push_back(fields_.back().get());
    }
  }

  /// Sizes that change along the patches in other ways in each.
  void add_sources() {
    for (int p = 0; p < static_cast<int>(input_.model.patches.size()); ++p) {
      const double size = (0.02 + 0.02 * (p % 3)) * input_.model.diagonal;
      const Domain domain = input_.model.patches[static_cast<std::size_t>(p)].surface->domain();
      const auto share = [domain, p](Uv uv) {
        const double u = (uv.u - domain.u0) / (domain.u1 - domain.u0);
        const double v = (uv.v - domain.v0) / (domain.v1 - domain.v0);
        return p % 2 == 0 ? 0.5 * (u + v) : 1 - 0.5 * (u + v);
      };
      FieldSource source;
      source.patch = p;
      source.size = [=](Uv uv, const Vec3&) { return size * (0.1 + 2 * share(uv) * share(uv)); };
      input_.sources.fields.push_back(source);
    }
  }

  /// The metric length of segment i of a contour, in the patch where it is longest.
  double longest(std::size_t contour, const ContourNodes& nodes, std::size_t i) const {
    double length = 0;
    for (std::size_t use = 0; use < nodes.uv.size(); ++use) {
      const int patch = input_.model.contours[contour].uses[use].patch;
      const SegmentCurve segment(nodes.uv[use][i], nodes.uv[use][i + 1]);
      const MetricArc arc(segment, *pointers_[static_cast<std::size_t>(patch)]);
      length = std::max(length, arc.length());
    }
    return length;
  }

  /// The metric length of a short step along a contour in the patch of a use.
  double step_length(const ContourUse& use, double t) const {
    const Uv from = use.curve->evaluate(t), to = use.curve->evaluate(t + kStep);
    QueryHint hint;
    const Metric metric = pointers_[static_cast<std::size_t>(use.patch)]->at(from, hint);
    return std::sqrt(squared_length(metric, to - from));
  }

  ModelInput input_;
  std::vector<std::unique_ptr<ControlSpace>> spaces_;
  std::vector<std::unique_ptr<SurfaceMetricField>> fields_;
  std::vector<const MetricField*> pointers_;
};

TEST_P(ContourBounds, AreHeldByAllNodes) {
  const auto nodes = place_contour_nodes(input_.model, pointers_).contours;
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    const Contour& contour = input_.model.contours[c];
    if (contour.is_degenerate || contour.uses.empty()) continue;
    SCOPED_TRACE(contour.name);
    double wanted = 0;
    for (int i = 0; i < nodes[c].segment_count(); ++i) {
      const double length = longest(c, nodes[c], static_cast<std::size_t>(i));
      EXPECT_LE(length, std::numbers::sqrt2 * (1 + kLengthError)) << "segment " << i;
      wanted += length;
    }
    // Closed contours, and those at poles, have at least 3.
    EXPECT_LE(nodes[c].segment_count(), std::max(3.0, kMostSegments * wanted + 1));
  }
}

TEST_P(ContourBounds, AreWantedAlikeByAllPatches) {
  if (GetParam().grade == 0) return;  // only gradation goes on across contours
  for (const Contour& contour : input_.model.contours) {
    if (contour.is_degenerate || contour.uses.size() < 2) continue;
    for (double t = 0.013; t < 0.99; t += 0.041) {
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (const ContourUse& use : contour.uses) {
        if (!use.is_same_speed) continue;
        least = std::min(least, step_length(use, t));
        most = std::max(most, step_length(use, t));
      }
      EXPECT_LE(most, (1 + kDisagreement) * least) << contour.name << " at " << t;
    }
  }
}

std::vector<BoundsCase> bounds_cases() {
  std::vector<BoundsCase> result;
  for (const char* name : {"cube.obj", "knob.obj", "vault.obj", "icosahedron.off", "torus.obj",
                           "cylinder.json", "torus.json", "sphere.json", "pipes.json",
                           "pipe_on_plate.json", "window.json", "perforated.json"}) {
    for (const double grade : {0.0, 1.5}) {
      for (const bool has_sources : {false, true}) result.push_back({name, grade, has_sources});
    }
  }
  return result;
}

INSTANTIATE_TEST_SUITE_P(Models, ContourBounds, ::testing::ValuesIn(bounds_cases()),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           std::replace(name.begin(), name.end(), '.', '_');
                           name += test.param.grade > 0 ? "_graded" : "";
                           return name + (test.param.has_sources ? "_with_sources" : "");
                         });

}  // namespace
}  // namespace surfmesh
