// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/touching_loops.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/hand_made.hh"
#include "surfmesh/model/finish_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using testing::HandMade;
using testing::rectangle;

/// A square of side 10 with a corner in the middle of its lower side, and holes.
struct Square : HandMade {
  Square() {
    patch = add_patch(rectangle(0, 0, 10, 10));
    outer = corners_at({{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}});
    add_loop(patch, outer);
  }

  /// A hole from a corner on, clockwise.
  void add_hole(const std::pair<int, Uv>& corner, const std::vector<Uv>& others) {
    auto corners = corners_at(others);
    corners.insert(corners.begin(), corner);
    add_loop(patch, corners);
  }

  int patch = -1;
  std::vector<std::pair<int, Uv>> outer;
};

std::vector<std::size_t> sizes_of_loops(const Model& model) {
  std::vector<std::size_t> sizes;
  for (const PatchLoop& loop : model.patches.front().loops) sizes.push_back(loop.size());
  return sizes;
}

/// Every loop goes on where the contour before it ends.
bool are_closed(const Model& model) {
  const auto at = [&](const LoopEntry& entry, bool is_end) {
    const ContourUse& use = model.use(entry);
    return use.curve->evaluate(is_end == use.is_forward ? 1 : 0);
  };
  for (const PatchLoop& loop : model.patches.front().loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (!(at(loop[i], true) == at(loop[(i + 1) % loop.size()], false))) return false;
    }
  }
  return true;
}

TEST(TouchingLoops, StayWhereNothingTouches) {
  Square square;
  square.add_hole({square.add_vertex({5, 2, 0}), {5, 2}}, {{4, 4}, {6, 4}});
  Model model = square.model;
  separate_touching_loops(model);
  EXPECT_EQ(sizes_of_loops(model), (std::vector<std::size_t>{5, 3}));
}

TEST(TouchingLoops, MakeAHoleOnTheRimAPartOfIt) {
  Square square;
  square.add_hole(square.outer[1], {{4, 4}, {6, 4}});
  Model model = square.model;
  separate_touching_loops(model);
  EXPECT_EQ(sizes_of_loops(model), (std::vector<std::size_t>{8}));
  EXPECT_TRUE(are_closed(model));
}

TEST(TouchingLoops, MakeTwoHolesWithACommonCornerOne) {
  Square square;
  const std::pair<int, Uv> corner{square.add_vertex({5, 5, 0}), {5, 5}};
  square.add_hole(corner, {{4, 7}, {6, 7}});
  square.add_hole(corner, {{6, 3}, {4, 3}});
  Model model = square.model;
  separate_touching_loops(model);
  EXPECT_EQ(sizes_of_loops(model), (std::vector<std::size_t>{5, 6}));
  EXPECT_TRUE(are_closed(model));
}

TEST(TouchingLoops, GiveEachPieceAnOuterLoopOfItsOwn) {
  HandMade made;
  const int patch = made.add_patch(rectangle(-2, -1, 2, 1));
  auto corners = made.corners_at({{-2, -1}, {0, 0}, {2, -1}, {2, 1}, {-2, 1}});
  corners.insert(corners.begin() + 4, corners[1]);
  made.add_loop(patch, corners);
  separate_touching_loops(made.model);
  EXPECT_EQ(sizes_of_loops(made.model), (std::vector<std::size_t>{3, 3}));
  EXPECT_EQ(outer_less_inner_loops(made.model, made.model.patches.front()), 2);
}

TEST(TouchingLoops, OrderCurvesThatLeaveACornerInOneDirection) {
  Square square;
  // A round hole that touches the lower side in its corner.
  const auto circle = std::make_shared<CallableCurve>([](double t) {
    const double angle = -2 * std::numbers::pi * t - std::numbers::pi / 2;
    return t == 0 || t == 1 ? Uv{5, 0} : Uv{5 + 2 * std::cos(angle), 2 + 2 * std::sin(angle)};
  });
  const int contour = square.add_contour(square.outer[1].first, square.outer[1].first);
  square.model.contour(contour).uses.push_back({square.patch, circle, true});
  square.model.patch(square.patch).loops.push_back({{contour, 0}});
  Model model = square.model;
  separate_touching_loops(model);
  EXPECT_EQ(sizes_of_loops(model), (std::vector<std::size_t>{6}));
  EXPECT_TRUE(are_closed(model));
}

TEST(TouchingLoops, AreMeshedAsOneDisc) {
  Square square;
  square.add_hole(square.outer[1], {{4, 4}, {6, 4}});
  Model model = square.model;
  finish(model);
  const MeshResult result = mesh_model(model);
  EXPECT_EQ(result.report.mesh.euler, 1);
  EXPECT_GT(result.report.quality.min, 0.5);
  // The hole has no triangles: area of the square less that of the triangle.
  double area = 0;
  for (const FaceHandle fh : result.mesh.faces())
    area += result.mesh.calc_sector_area(result.mesh.halfedge_handle(fh));
  EXPECT_NEAR(area, 96, 1e-10);
}

TEST(TouchingLoops, AreMeshedInTwoPieces) {
  HandMade made;
  const int patch = made.add_patch(rectangle(-2, -1, 2, 1));
  auto corners = made.corners_at({{-2, -1}, {0, 0}, {2, -1}, {2, 1}, {-2, 1}});
  corners.insert(corners.begin() + 4, corners[1]);
  made.add_loop(patch, corners);
  finish(made.model);
  EXPECT_EQ(mesh_model(made.model).report.mesh.euler, 2);
}

}  // namespace
}  // namespace surfmesh
