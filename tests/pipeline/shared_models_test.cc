// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "support/expect_valid.hh"
#include "support/notices.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

const std::filesystem::path kShared = SURFMESH_SHARED_DIR;

struct CageCase {
  const char* name;
  const char* file;
  double curvature;
};

void PrintTo(const CageCase& cage, std::ostream* out) { *out << cage.name; }

/// Euler characteristic of a cage, and whether every edge has two faces.
struct CageTopology {
  long euler = 0;
  bool is_closed = true;
};

CageTopology topology_of(const Cage& cage) {
  std::map<std::pair<int, int>, int> edges;
  for (const std::vector<int>& face : cage.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      ++edges[std::minmax(face[k], face[(k + 1) % face.size()])];
    }
  }
  CageTopology result;
  result.euler = static_cast<long>(cage.points.size()) - static_cast<long>(edges.size()) +
                 static_cast<long>(cage.faces.size());
  for (const auto& [edge, count] : edges) result.is_closed = result.is_closed && count == 2;
  return result;
}

class SharedCage : public ::testing::TestWithParam<CageCase> {
 protected:
  void SetUp() override {
    const auto path = kShared / "models" / GetParam().file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no cage " << path;
    cage_ = read_cage(path);
  }

  MeshResult mesh(int level, double hmin_factor) const {
    PipelineOptions options;
    options.sizing.curvature = GetParam().curvature;
    options.sizing.hmin = Length::share(options.sizing.least_size().value * hmin_factor);
    return mesh_model(model_from_cage(cage_, {.approximation_level = level}), {}, options);
  }

  Cage cage_;
};

TEST_P(SharedCage, GivesAProperMeshWithTheTopologyOfTheCage) {
  const MeshResult result = mesh(8, 1);
  testing::expect_valid(result.mesh);
  EXPECT_EQ(result.report.mesh.is_closed, topology_of(cage_).is_closed);
  EXPECT_EQ(result.report.mesh.euler, topology_of(cage_).euler);
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(Cages, SharedCage,
                         ::testing::Values(CageCase{"Spot", "spot_control_mesh.obj", 0.5},
                                           CageCase{"Car", "opensubdiv/catmark_car.obj", 1},
                                           CageCase{"Pawn", "opensubdiv/catmark_pawn.obj", 0.5}),
                         [](const auto& test) { return std::string(test.param.name); });

/// Not the car, which takes long.
class SmallSharedCage : public SharedCage {};

TEST_P(SmallSharedCage, HasAsManyTrianglesAtAnyLevelOfApproximation) {
  const auto coarse = static_cast<double>(mesh(6, 1).mesh.n_faces());
  const auto fine = static_cast<double>(mesh(8, 1).mesh.n_faces());
  EXPECT_NEAR(coarse, fine, 0.1 * fine);
}

/// Without creases: on semi-sharp ones the least size is the size.
class SmoothSharedCage : public SharedCage {};

TEST_P(SmoothSharedCage, HasAsManyTrianglesWithHalfOfTheLeastSize) {
  const auto before = static_cast<double>(mesh(8, 1).mesh.n_faces());
  const auto after = static_cast<double>(mesh(8, 0.5).mesh.n_faces());
  EXPECT_NEAR(after, before, 0.1 * before);
}

INSTANTIATE_TEST_SUITE_P(Cages, SmoothSharedCage,
                         ::testing::Values(CageCase{"Spot", "spot_control_mesh.obj", 0.5}),
                         [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(Cages, SmallSharedCage,
                         ::testing::Values(CageCase{"Spot", "spot_control_mesh.obj", 0.5},
                                           CageCase{"Pawn", "opensubdiv/catmark_pawn.obj", 0.5}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SharedCaseC2, ReachesItsFigures) {
  const auto path = kShared / "bench" / "c2.json";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no model " << path;
  const ModelInput input = load_model(path);
  const Report report = mesh_model(input.model, input.sources, input.options).report;
  EXPECT_NEAR(static_cast<double>(report.mesh.triangles), 42'000, 0.08 * 42'000);
  EXPECT_GE(report.edges.unit_fraction, 0.98);
  EXPECT_GE(report.quality.mean, 0.93);
  EXPECT_GE(report.quality.min, 0.3);
}

}  // namespace
}  // namespace surfmesh
