// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/front.hh"

#include <gtest/gtest.h>

#include "support/domain_meshes.hh"

namespace surfmesh {
namespace {

using testing::empty_square;
using testing::faces_of;
using testing::isotropic_field;

std::size_t count_entries(Front& front) {
  std::size_t count = 0;
  FrontQueue::Entry entry;
  while (front.pop(entry)) ++count;
  return count;
}

bool is_at_boundary(const PolyMesh& mesh, FaceHandle fh) {
  for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
    if (mesh.is_boundary(mesh.opposite_halfedge_handle(heh))) return true;
  }
  return false;
}

TEST(Front, IsAtTheBoundaryAtFirst) {
  const auto delaunay = empty_square(isotropic_field(0.1));
  FaceStates states(*delaunay, testing::kAcceptedSize);
  for (const FaceHandle fh : faces_of(*delaunay)) states[fh].is_accepted = false;
  Front front(*delaunay, states, Placement::Frontal);
  FrontQueue::Entry entry;
  ASSERT_TRUE(front.pop(entry));
  do {
    EXPECT_TRUE(is_at_boundary(delaunay->mesh(), entry.face));
    EXPECT_TRUE(front.base_of(entry.face).is_valid());
  } while (front.pop(entry));
}

TEST(Front, IsAllThatIsNotAcceptedWithCircumcentres) {
  const auto delaunay = empty_square(isotropic_field(0.1));
  FaceStates states(*delaunay, testing::kAcceptedSize);
  std::size_t large = 0;
  for (const FaceHandle fh : faces_of(*delaunay)) large += states[fh].is_accepted ? 0 : 1;
  ASSERT_GT(large, 0u);
  Front front(*delaunay, states, Placement::Circumcentre);
  EXPECT_EQ(count_entries(front), large);
}

TEST(Front, MovesOnBehindWhatIsAccepted) {
  const auto delaunay = empty_square(isotropic_field(0.1));
  FaceStates states(*delaunay, testing::kAcceptedSize);
  Front front(*delaunay, states, Placement::Frontal);
  FrontQueue::Entry entry;
  std::size_t accepted = 0;
  while (front.pop(entry)) {
    if (!front.is_current(entry)) continue;
    front.accept(entry.face);
    EXPECT_FALSE(front.is_current(entry));
    ++accepted;
  }
  ASSERT_GT(accepted, 0u);
  for (const FaceHandle fh : faces_of(*delaunay)) EXPECT_TRUE(states[fh].is_accepted);
}

TEST(Front, HasItsBaseAtTheShortestSideOrTheLongest) {
  const auto field = isotropic_field(0.4);
  const auto delaunay = empty_square(field);
  FaceStates states(*delaunay, testing::kAcceptedSize);
  const Front frontal(*delaunay, states, Placement::Frontal);
  const Front circumcentre(*delaunay, states, Placement::Circumcentre);
  const auto length = [&](HalfedgeHandle heh) {
    const Uv step = delaunay->uv(delaunay->mesh().to_vertex_handle(heh)) -
                    delaunay->uv(delaunay->mesh().from_vertex_handle(heh));
    return step.u * step.u + step.v * step.v;
  };
  for (const FaceHandle fh : faces_of(*delaunay)) {
    const double longest = length(circumcentre.base_of(fh));
    for (const HalfedgeHandle heh : delaunay->mesh().fh_range(fh)) {
      EXPECT_LE(length(heh), longest * (1 + 1e-12));
    }
    const HalfedgeHandle base = frontal.base_of(fh);
    EXPECT_TRUE(!base.is_valid() || length(base) <= longest);
  }
}

}  // namespace
}  // namespace surfmesh
