// SPDX-License-Identifier: BSD-3-Clause
#include "cad/own_shapes.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "cad/meshed.hh"
#include "support/folders.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

using testing::OwnShape;
using testing::ShapeKind;

/// Share of the diagonal by which a mesh may be off its surface.
constexpr double kSag = 0.002;

class OwnShapes : public ::testing::TestWithParam<std::string> {
 protected:
  const OwnShape& shape() const { return testing::own_shape(GetParam()); }
  Model read() const { return read_cad(write_shape(shape(), folder_.path())); }

  TestFolder folder_;
};

PipelineOptions within_sag() {
  PipelineOptions options;
  options.sizing.sag = Length::share(kSag);
  return options;
}

TEST_P(OwnShapes, AreReadAsTheyAre) {
  const Model model = read();
  check(model);
  const testing::ShapeFacts facts = facts_of(shape());
  if (!testing::has(model.notices, NoticeKind::HealedShape)) {
    EXPECT_EQ(static_cast<int>(model.patches.size()), facts.faces);
  }
  constexpr double kBox = 0.01;  // the box of the model is one of samples
  EXPECT_NEAR((model.box.min() - facts.box.min()).norm() / model.diagonal, 0, kBox);
  EXPECT_NEAR((model.box.max() - facts.box.max()).norm() / model.diagonal, 0, kBox);
  EXPECT_FALSE(testing::has(model.notices, NoticeKind::IgnoredInput))
      << testing::all_texts(model.notices);
  EXPECT_FALSE(testing::has(model.notices, NoticeKind::LooseFit))
      << testing::all_texts(model.notices);
}

TEST_P(OwnShapes, AreAsOpenAsTheyAre) {
  for (const Model model = read(); const Contour& contour : model.contours) {
    if (contour.is_degenerate || shape().kind == ShapeKind::Sheet) continue;
    EXPECT_GE(contour.uses.size(), 2u) << contour.name;
  }
}

TEST_P(OwnShapes, AreMeshedWithinTheSag) {
  const Model model = read();
  const MeshResult result = mesh_model(model, {}, within_sag());
  const std::string texts = testing::all_texts(result.report.notices);
  EXPECT_FALSE(testing::has(result.report.notices, NoticeKind::TurnedTriangles)) << texts;
  EXPECT_FALSE(testing::has(result.report.notices, NoticeKind::BrokenPromise)) << texts;
  EXPECT_LE(testing::corner_distance(model, result.mesh), testing::allowed_distance(model));
  if (shape().kind == ShapeKind::Glued) return;
  EXPECT_EQ(testing::is_closed(result.mesh), shape().kind == ShapeKind::Solid);
  if (shape().kind == ShapeKind::Sheet) return;
  const testing::ShapeFacts facts = facts_of(shape());
  double volume = 0;
  for (const auto face : result.mesh.faces()) {
    Vec3 corners[3];
    int i = 0;
    for (const auto vertex : face.vertices()) corners[i++] = to_eigen(result.mesh.point(vertex));
    volume += corners[0].dot(corners[1].cross(corners[2])) / 6;
  }
  EXPECT_NEAR(volume, facts.volume, facts.area * kSag * model.diagonal);
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const OwnShape& shape : testing::own_shapes()) result.push_back(shape.name);
  return result;
}

INSTANTIATE_TEST_SUITE_P(All, OwnShapes, ::testing::ValuesIn(names()),
                         [](const auto& test) { return test.param; });

TEST(OwnShapesOfTests, AreAtLeastFortyWithNamesOfTheirOwn) {
  const auto all = names();
  EXPECT_GE(all.size(), 40u);
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
}

class CadThreads : public ::testing::TestWithParam<std::string> {};

TEST_P(CadThreads, MakeTheSameFileInAnyNumber) {
  const TestFolder folder;
  const auto path = write_shape(testing::own_shape(GetParam()), folder.path());
  std::string alone;
  for (const int threads : {1, 2, 4}) {
    PipelineOptions options = within_sag();
    options.threads = threads;
    const MeshResult result = mesh_model(read_cad(path), {}, options);
    write_mesh(result.mesh, folder / "mesh.om");
    const std::string bytes = read_text(folder / "mesh.om");
    if (threads == 1) alone = bytes;
    EXPECT_TRUE(bytes == alone) << threads;
  }
}

INSTANTIATE_TEST_SUITE_P(Some, CadThreads,
                         ::testing::Values("fillets", "offset_hill", "pipe", "revolved_spline",
                                           "thread", "loose_hole"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace surfmesh
