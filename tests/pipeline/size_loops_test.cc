// SPDX-License-Identifier: BSD-3-Clause
// Closed-form surfaces at many sizes, from a hundredth of the radius to the radius. The environment
// variable SURFMESH_LOOP_SIZES sets the number of sizes; the full 200 take some minutes, by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/expect_valid.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kFewSizes = 25;
constexpr int kAllSizes = 200;

/// Least 3D quality of a triangle at a pole.
constexpr double kLeastPoleQuality = 0.2;

struct Shape {
  std::string name;
  SurfaceFormulas formulas;
  Domain domain;
  long euler = 0;
  bool is_closed = false;
  int pieces = 1;  ///< patches that share the range of u
};

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

/// With a base of radius 1, and the apex at v = 0.
Shape cone(int degrees, int pieces) {
  const double slope = 1 / std::tan(degrees * kPi / 180);
  return {"cone" + std::to_string(degrees) + "of" + std::to_string(pieces),
          {"v*cos(u)", "v*sin(u)", std::to_string(slope) + "*v"},
          {0, 2 * kPi, 0, 1},
          1,
          false,
          pieces};
}

Shape sphere_shape(int pieces) {
  return {"sphere" + std::string("of") + std::to_string(pieces),
          {"cos(v)*cos(u)", "cos(v)*sin(u)", "sin(v)"},
          {0, 2 * kPi, -kPi / 2, kPi / 2},
          2,
          true,
          pieces};
}

Shape cylinder_shape(int pieces) {
  return {"cylinder" + std::string("of") + std::to_string(pieces),
          {"cos(u)", "sin(u)", "v"},
          {0, 2 * kPi, 0, 3},
          0,
          false,
          pieces};
}

/// The small radius is 1.
Shape torus_shape(int pieces) {
  return {"torus" + std::string("of") + std::to_string(pieces),
          {"(2.5+cos(v))*cos(u)", "(2.5+cos(v))*sin(u)", "sin(v)"},
          {0, 2 * kPi, 0, 2 * kPi},
          0,
          true,
          pieces};
}

Model model_of_shape(const Shape& shape) {
  std::vector<testing::Shape> surfaces;
  for (int i = 0; i < shape.pieces; ++i) {
    Domain domain = shape.domain;
    domain.u0 = 2 * kPi * i / shape.pieces;
    domain.u1 = 2 * kPi * (i + 1) / shape.pieces;
    surfaces.push_back(std::make_shared<FormulaSurface>(shape.formulas, domain));
  }
  return testing::model_of(surfaces);
}

/// From a hundredth to 1, at uneven ratios; with few sizes from a thirtieth, for the time.
std::vector<double> sizes() {
  const char* asked = std::getenv("SURFMESH_LOOP_SIZES");
  const int count = asked ? std::atoi(asked) : kFewSizes;
  const double least = count < kAllSizes ? 0.03 : 0.01;
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    const double uneven = i + 0.4 * std::sin(7.0 * i);
    result.push_back(std::clamp(std::pow(least, 1 - uneven / (count - 1)), least, 1.0));
  }
  return result;
}

double quality_in_space(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double area = 0.5 * (b - a).cross(c - a).norm();
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return 4 * std::numbers::sqrt3 * area / squares;
}

struct Findings {
  std::size_t turned = 0;   ///< triangles that face another way than most of their patch
  double pole_quality = 1;  ///< least of the triangles at the model's point-like contours
};

class Inspector {
 public:
  Inspector(const Model& model, const PolyMesh& mesh)
      : model_(model),
        mesh_(mesh),
        patch_of_(require(mesh, keys::face_patch)),
        uv_of_(require(mesh, keys::corner_uv)),
        outwards_(model.patches.size()),
        inwards_(model.patches.size()) {
    for (const Contour& contour : model.contours) {
      if (contour.is_degenerate) {
        poles_.push_back(model.vertices[static_cast<std::size_t>(contour.start)].position);
      }
    }
  }

  Findings run() {
    for (const FaceHandle fh : mesh_.faces()) look_at(fh);
    for (std::size_t p = 0; p < outwards_.size(); ++p) {
      findings_.turned += std::min(outwards_[p], inwards_[p]);
    }
    return findings_;
  }

 private:
  void look_at(FaceHandle fh) {
    std::vector<Vec3> points;
    Uv middle{0, 0};
    for (const HalfedgeHandle heh : mesh_.fh_range(fh)) {
      points.push_back(to_eigen(mesh_.point(mesh_.to_vertex_handle(heh))));
      middle = middle + 1.0 / 3 * mesh_.property(uv_of_, heh);
    }
    const auto patch = static_cast<std::size_t>(mesh_.property(patch_of_, fh));
    const Jet jet = model_.patches[patch].surface->evaluate(middle, Order::First);
    const Vec3 normal = (points[1] - points[0]).cross(points[2] - points[0]);
    ++(normal.dot(jet.du.cross(jet.dv)) > 0 ? outwards_ : inwards_)[patch];
    const bool is_at_pole = std::any_of(points.begin(), points.end(), [this](const Vec3& point) {
      return std::find(poles_.begin(), poles_.end(), point) != poles_.end();
    });
    if (!is_at_pole) return;
    const double quality = quality_in_space(points[0], points[1], points[2]);
    findings_.pole_quality = std::min(findings_.pole_quality, quality);
  }

  const Model& model_;
  const PolyMesh& mesh_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  std::vector<std::size_t> outwards_, inwards_;  ///< triangles by patch
  std::vector<Vec3> poles_;
  Findings findings_;
};

void expect_right(const Shape& shape, const Model& model, const MeshResult& result) {
  testing::expect_valid(result.mesh);
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
  EXPECT_EQ(result.report.mesh.is_closed, shape.is_closed);
  EXPECT_EQ(result.report.mesh.euler, shape.euler);
  EXPECT_EQ(measure_topology(result.mesh).components, 1u);
  const Findings findings = Inspector(model, result.mesh).run();
  EXPECT_EQ(findings.turned, 0u);
  EXPECT_GE(findings.pole_quality, kLeastPoleQuality);
}

class SizeLoops : public ::testing::TestWithParam<Shape> {};

TEST_P(SizeLoops, OfSourcesGiveProperMeshes) {
  const Model model = model_of_shape(GetParam());
  for (const double size : sizes()) {
    SCOPED_TRACE(size);
    Sources sources;
    for (int p = 0; p < GetParam().pieces; ++p) {
      sources.everywhere.push_back({p, {Length::units(size), Length::units(size), 0}});
    }
    const PipelineOptions options{
        .sizing = {.curvature = 0, .hmin = Length::share(1e-4), .hmax = Length::share(1)}};
    expect_right(GetParam(), model, mesh_model(model, sources, options));
  }
}

TEST_P(SizeLoops, OfHmaxGiveProperMeshes) {
  const Model model = model_of_shape(GetParam());
  for (const double size : sizes()) {
    SCOPED_TRACE(size);
    const PipelineOptions options{
        .sizing = {.curvature = 0, .hmin = Length::share(1e-4), .hmax = Length::units(size)}};
    expect_right(GetParam(), model, mesh_model(model, {}, options));
  }
}

INSTANTIATE_TEST_SUITE_P(All, SizeLoops,
                         ::testing::Values(sphere_shape(1), sphere_shape(2), sphere_shape(3),
                                           cone(10, 1), cone(30, 1), cone(60, 1), cone(80, 1),
                                           cone(10, 2), cone(80, 2), cylinder_shape(1),
                                           cylinder_shape(2), torus_shape(1), torus_shape(2)),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace surfmesh
