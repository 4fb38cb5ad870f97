// SPDX-License-Identifier: BSD-3-Clause
// What V_s, V_t, V_o and V_x give, and which triangles get which.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "support/control_nodes.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/interpolate.hh"

namespace surfmesh {
namespace {

using testing::expect_near;
using testing::place;
using testing::query;
using testing::random_points;

constexpr double kEpsilon = 0.1;

ControlMesh random_mesh(Interpolation interpolation, int count = 800) {
  return ControlMesh({}, testing::random_nodes(count),
                     {.interpolation = interpolation, .epsilon = kEpsilon});
}

/// Sizes that change gently from corner to corner, with a disturbance in the middle.
SizeTensor gentle(Uv uv) {
  const double distance = std::hypot(uv.u - 0.5, uv.v - 0.5);
  return isotropic(0.1 + (distance < 0.2 ? 0.08 * std::sin(40 * uv.u) : 0.004 * uv.u));
}

ControlMesh gentle_mesh(Interpolation interpolation) {
  return ControlMesh({}, testing::grid({}, 25, gentle),
                     {.interpolation = interpolation, .epsilon = kEpsilon});
}

/// The mean with the weights 1/d² of the vertices of all triangles whose circles hold the point.
SizeTensor searched_slowly(const PolyMesh& mesh, Uv p) {
  const auto uv = require(mesh, keys::vertex_uv);
  const auto size = require(mesh, keys::vertex_size);
  std::set<int> found;
  for (const FaceHandle fh : mesh.faces()) {
    if (!in_metric_circle(corners(mesh, fh, uv), p, {1, 0, 1})) continue;
    for (const VertexHandle vh : vertices(mesh, fh)) found.insert(vh.idx());
  }
  double total = 0;
  SizeTensor sum{0, 0, 0};
  for (const int i : found) {
    const Uv step = p - mesh.property(uv, VertexHandle(i));
    const SizeTensor& h = mesh.property(size, VertexHandle(i));
    const double weight = 1 / (step.u * step.u + step.v * step.v);
    total += weight;
    sum = {sum.h11 + weight * h.h11, sum.h12 + weight * h.h12, sum.h22 + weight * h.h22};
  }
  return scaled(sum, 1 / total);
}

TEST(CircleInterpolation, EqualsASearchOverAllTriangles) {
  const ControlMesh control = random_mesh(Interpolation::Circles);
  for (const Uv uv : random_points({}, 500, 3)) {
    const SizeTensor expected = searched_slowly(control.mesh(), uv);
    expect_near(query(control, uv), expected, 1e-12);
  }
}

TEST(CircleInterpolation, TakesDistancesThroughTheFirstForm) {
  const auto nodes =
      testing::with_corners({}, isotropic(1), {testing::node({0.5, 0.5}, isotropic(2))});
  const ControlMesh control({}, nodes, {.interpolation = Interpolation::Circles});
  // The circles of the two triangles left and right of (0.5, 0.25) do not hold it: three nodes.
  const double middle = 1 / 0.0625, below = 1 / 25.0625;
  EXPECT_NEAR(query(control, {0.5, 0.25}, {10, 0, 1}).h11,
              (2 * middle + 2 * below) / (middle + 2 * below), 1e-12);
}

TEST(SingleInterpolation, GivesTheSizeOfAVertexOfTheTriangle) {
  const ControlMesh control = random_mesh(Interpolation::Single);
  const auto size = require(control.mesh(), keys::vertex_size);
  for (const Uv uv : random_points({}, 200)) {
    const SizeTensor answer = query(control, uv);
    const bool is_node =
        std::any_of(control.mesh().vertices_begin(), control.mesh().vertices_end(),
                    [&](VertexHandle vh) { return control.mesh().property(size, vh) == answer; });
    ASSERT_TRUE(is_node) << uv.u << " " << uv.v;
  }
}

template <class Choice>
struct Named {
  const char* name;
  Choice choice;
};

template <class Choice>
void PrintTo(const Named<Choice>& named, std::ostream* out) {
  *out << named.name;
}

class Interpolations
    : public ::testing::TestWithParam<std::tuple<Named<Interpolation>, Named<Blend>>> {
 protected:
  ControlSpaceOptions options() const {
    return {.interpolation = std::get<0>(GetParam()).choice,
            .blend = std::get<1>(GetParam()).choice};
  }
};

TEST_P(Interpolations, ReproduceAConstantField) {
  const SizeTensor size = size_tensor(0.3, 0.07, 0.4);
  const ControlMesh control({}, testing::grid({}, 7, [&](Uv) { return size; }), options());
  for (const Uv uv : random_points({}, 500)) {
    const SizeTensor answer = query(control, uv, {2, 0.5, 3});
    if (options().blend == Blend::Linear) {
      ASSERT_EQ(answer, size);
    } else {
      expect_near(answer, size, 1e-14);
    }
  }
}

TEST_P(Interpolations, StayWithinTheSizesOfTheNodes) {
  const ControlMesh control({}, testing::random_nodes(500), options());
  const auto size = require(control.mesh(), keys::vertex_size);
  double least = 1, largest = 0;
  for (const VertexHandle vh : control.mesh().vertices()) {
    least = std::min(least, principal_sizes(control.mesh().property(size, vh)).l_t);
    largest = std::max(largest, principal_sizes(control.mesh().property(size, vh)).l_s);
  }
  for (const Uv uv : random_points({}, 1000)) {
    const PrincipalSizes sizes = principal_sizes(query(control, uv));
    ASSERT_GE(sizes.l_t, least * (1 - 1e-12));
    ASSERT_LE(sizes.l_s, largest * (1 + 1e-12));
  }
}

TEST_P(Interpolations, DoNotDependOnTheHint) {
  const ControlMesh control({}, testing::random_nodes(2000), options());
  QueryHint warm;
  for (const Uv uv : random_points({}, 2000, 2)) {
    ASSERT_EQ(control.size(place(uv), warm), query(control, uv));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Interpolations,
    ::testing::Combine(::testing::Values(Named{"Single", Interpolation::Single},
                                         Named{"Triangle", Interpolation::Triangle},
                                         Named{"Circles", Interpolation::Circles},
                                         Named{"Automatic", Interpolation::Automatic},
                                         Named{"Linear", Interpolation::Linear}),
                       ::testing::Values(Named{"LinearBlend", Blend::Linear},
                                         Named{"LogarithmicBlend", Blend::Logarithmic})),
    [](const auto& test) {
      return std::string(std::get<0>(test.param).name) + std::get<1>(test.param).name;
    });

TEST(LogarithmicBlend, IsTheGeometricMeanMidwayBetweenTwoNodes) {
  const auto nodes = testing::grid({}, 2, [](Uv uv) { return isotropic(uv.u == 0 ? 0.1 : 0.4); });
  const ControlMesh control({}, nodes, {.blend = Blend::Logarithmic});
  EXPECT_NEAR(query(control, {0.5, 0}).h11, std::exp(std::log(0.1 * 0.4) / 2), 0.02);
  const ControlMesh linear({}, nodes, {});
  EXPECT_GT(query(linear, {0.5, 0}).h11, query(control, {0.5, 0}).h11);
}

// --- linear ---

TEST(LinearInterpolation, ReproducesSizesLinearInTheParameters) {
  const auto linear = [](Uv uv) {
    // Small, so that no nodes become one.
    return scaled({1 + uv.u + 2 * uv.v, 0.3 * uv.u - 0.1 * uv.v, 2 - uv.u + 0.5 * uv.v}, 1e-4);
  };
  std::vector<ControlNode> nodes = testing::random_nodes(500);
  for (ControlNode& node : nodes) node.size = linear(node.uv);
  const ControlMesh control({}, nodes, {.interpolation = Interpolation::Linear});
  for (const Uv uv : random_points({}, 500, 3)) expect_near(query(control, uv), linear(uv), 1e-15);
}

TEST(LinearInterpolation, IsOfSecondOrder) {
  const auto wave = [](Uv uv) {
    return isotropic(1e-3 * (2 + std::sin(3 * uv.u) * std::cos(2 * uv.v)));
  };
  const auto error = [&](int side) {
    const ControlMesh control({}, testing::grid({}, side, wave), {});
    double greatest = 0;
    for (const Uv uv : random_points({}, 2000)) {
      greatest = std::max(greatest, std::abs(query(control, uv).h11 - wave(uv).h11));
    }
    return greatest;
  };
  EXPECT_NEAR(error(11) / error(41), 16, 4);
}

TEST(LinearInterpolation, IsContinuousAcrossEdgesOfTheControlMesh) {
  const ControlMesh control = random_mesh(Interpolation::Linear);
  const auto uv = require(control.mesh(), keys::vertex_uv);
  for (const EdgeHandle eh : control.mesh().edges()) {
    const HalfedgeHandle heh = control.mesh().halfedge_handle(eh, 0);
    const Uv a = control.mesh().property(uv, control.mesh().from_vertex_handle(heh));
    const Uv b = control.mesh().property(uv, control.mesh().to_vertex_handle(heh));
    const Uv middle = lerp(a, b, 0.3), step = 1e-12 * Uv{a.v - b.v, b.u - a.u};
    expect_near(query(control, middle + step), query(control, middle - step), 1e-6);
  }
}

// --- V_x ---

/// The centroid and the middles of the edges of a triangle.
std::array<Uv, 4> probes(const ControlMesh& control, FaceHandle fh) {
  const auto [a, b, c] = corners(control.mesh(), fh, require(control.mesh(), keys::vertex_uv));
  return {(1.0 / 3.0) * (a + b + c), lerp(a, b, 0.5), lerp(b, c, 0.5), lerp(c, a, 0.5)};
}

/// The greatest conformity between V_o and what a triangle's class gives at its probes.
double worst_conformity(const ControlMesh& all_circles, const ControlMesh& control, FaceHandle fh,
                        Interpolation interpolation) {
  const auto uv = require(control.mesh(), keys::vertex_uv);
  const auto size = require(control.mesh(), keys::vertex_size);
  double worst = 0;
  for (const Uv p : probes(control, fh)) {
    const SizeTensor h_o = query(all_circles, p);
    std::array<SizeTensor, 3> sizes;
    std::array<double, 3> distances{};
    std::size_t k = 0;
    for (const VertexHandle vh : vertices(control.mesh(), fh)) {
      sizes[k] = control.mesh().property(size, vh);
      const Uv step = p - control.mesh().property(uv, vh);
      distances[k++] = step.u * step.u + step.v * step.v;
    }
    if (interpolation == Interpolation::Triangle) {
      worst = std::max(worst, entry_conformity(h_o, interpolate(sizes, distances)));
      continue;
    }
    for (const SizeTensor& single : sizes) {
      worst = std::max(worst, entry_conformity(h_o, single));
    }
  }
  return worst;
}

TEST(AutomaticInterpolation, IsWithinEpsilonOfTheCirclesAtTheProbes) {
  const ControlMesh control = gentle_mesh(Interpolation::Automatic);
  const ControlMesh circles = gentle_mesh(Interpolation::Circles);
  const auto handle = require(control.mesh(), keys::face_class);
  std::array<int, 3> counts{};
  for (const FaceHandle fh : control.mesh().faces()) {
    const auto kind = static_cast<Interpolation>(control.mesh().property(handle, fh));
    ++counts[static_cast<std::size_t>(kind)];
    if (kind == Interpolation::Triangle) {
      EXPECT_LE(worst_conformity(circles, control, fh, kind), kEpsilon * (1 + 1e-9));
    } else if (kind == Interpolation::Single) {
      const double bound = 2 * kEpsilon + kEpsilon * kEpsilon;
      // Any of the three may be the one that is taken.
      EXPECT_LE(worst_conformity(circles, control, fh, kind), bound * (1 + kEpsilon));
    }
  }
  // The field has smooth, changing and wild parts: every class occurs.
  for (const int count : counts) EXPECT_GT(count, 0);
}

TEST(AutomaticInterpolation, TakesASingleVertexWhereAllAgree) {
  const ControlMesh control({}, testing::grid({}, 5, [](Uv) { return isotropic(0.1); }),
                            {.interpolation = Interpolation::Automatic});
  const auto handle = require(control.mesh(), keys::face_class);
  for (const FaceHandle fh : control.mesh().faces()) {
    EXPECT_EQ(control.mesh().property(handle, fh), 0);
  }
}

TEST(QueryCounts, TellHowQuestionsWereAnswered) {
  const ControlMesh control = gentle_mesh(Interpolation::Automatic);
  QueryHint hint;
  const auto handle = require(control.mesh(), keys::face_class);
  std::array<std::size_t, 3> expected{};
  for (const FaceHandle fh : control.mesh().faces()) {
    control.size(place(probes(control, fh)[0]), hint);
    ++expected[static_cast<std::size_t>(control.mesh().property(handle, fh))];
  }
  EXPECT_EQ(hint.answers.single, expected[0]);
  EXPECT_EQ(hint.answers.triangle, expected[1]);
  EXPECT_EQ(hint.answers.circles, expected[2]);
  EXPECT_EQ(hint.answers.total(), control.mesh().n_faces());
}

// --- reuse ---

TEST(Reuse, GivesTheLastSizesWithinItsMetricDistance) {
  const auto nodes = testing::grid({}, 9, [](Uv uv) { return isotropic(0.1 + 0.1 * uv.u); });
  const ControlMesh control({}, nodes, {.reuse = 0.5});
  QueryHint hint;
  hint.can_reuse = true;
  const SizeTensor first = control.size(place({0.5, 0.5}), hint);
  // Sizes are 0.15 there: half a unit is 0.075.
  EXPECT_EQ(control.size(place({0.57, 0.5}), hint), first);
  EXPECT_EQ(hint.answers.reused, 1U);
  EXPECT_NE(control.size(place({0.58, 0.5}), hint), first);
  EXPECT_EQ(hint.answers.total(), 3U);
}

TEST(Reuse, TakesTheFormOfThePointItself) {
  const auto nodes = testing::grid({}, 9, [](Uv) { return isotropic(0.1); });
  const ControlMesh control({}, nodes, {.reuse = 0.5});
  QueryHint hint;
  hint.can_reuse = true;
  control.metric(place({0.5, 0.5}), hint);
  const FirstFormFactor form{2, 0, 1};
  EXPECT_EQ(control.metric(place({0.5, 0.5}, form), hint), metric_from_size(form, isotropic(0.1)));
}

TEST(Reuse, IsOnlyForAnswersThatAreNotKept) {
  const auto nodes = testing::grid({}, 9, [](Uv uv) { return isotropic(0.1 + 0.1 * uv.u); });
  const ControlMesh control({}, nodes, {.reuse = 0.5});
  const testing::PlaneField field(control);
  QueryHint hint;
  const Metric first = field.at({0.5, 0.5}, hint);
  EXPECT_EQ(field.at_unkept({0.51, 0.5}, hint), first);
  EXPECT_NE(field.at({0.51, 0.5}, hint), first);
  EXPECT_EQ(hint.answers.reused, 1U);
}

TEST(Reuse, IsOffAtZero) {
  const ControlMesh control = gentle_mesh(Interpolation::Triangle);
  QueryHint hint;
  hint.can_reuse = true;
  control.size(place({0.5, 0.5}), hint);
  control.size(place({0.5, 0.5}), hint);
  EXPECT_EQ(hint.answers.reused, 0U);
}

}  // namespace
}  // namespace surfmesh
