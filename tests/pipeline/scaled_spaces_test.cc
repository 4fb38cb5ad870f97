// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/scaled_spaces.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/models.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/pipeline/counted_surfaces.hh"

namespace surfmesh::detail {
namespace {

ResolvedSizing sizing_for(const Model& model) {
  Sizing sizing;
  sizing.sag = Length::units(0.01);
  return resolve(sizing, model.diagonal);
}

std::vector<SizeTensor> sizes_of(const ControlSpaces& spaces, std::size_t patch) {
  const PolyMesh& mesh = spaces.spaces[patch]->mesh();
  const auto size_of = require(mesh, keys::vertex_size);
  std::vector<SizeTensor> sizes;
  for (const VertexHandle vh : mesh.vertices()) sizes.push_back(mesh.property(size_of, vh));
  return sizes;
}

class Scaled : public ::testing::Test {
 protected:
  CountedModel counted_{testing::torus_of(2)};
  ResolvedSizing sizing_ = sizing_for(counted_.model());
  Sources sources_;
  RunContext context_;
  ScaledSpaces spaces_{counted_.model(), sources_, sizing_, {}, context_};
};

TEST_F(Scaled, SpacesAreThoseOfTheSizesAtFirst) {
  const ControlSpaces plain =
      make_control_spaces(counted_.model(), sources_, sizing_, {}, context_);
  const ControlSpaces made = spaces_.make();
  for (const std::size_t p : {0u, 1u}) EXPECT_EQ(sizes_of(made, p), sizes_of(plain, p));
}

TEST_F(Scaled, SpacesAreTheSameAgain) {
  spaces_.factors(0).multiply({{{1, 1}, std::log(0.8)}});
  spaces_.factors(1).multiply({{{4, 1}, std::log(0.7)}});
  const ControlSpaces first = spaces_.make(), second = spaces_.make();
  for (const std::size_t p : {0u, 1u}) EXPECT_EQ(sizes_of(first, p), sizes_of(second, p));
}

TEST_F(Scaled, SpacesFollowTheirFactors) {
  for (const double factor : {0.8, 0.5}) {
    const ControlSpaces before = spaces_.make();
    for (const std::size_t p : {0u, 1u}) {
      spaces_.factors(p).multiply({{{p == 0 ? 1.0 : 4.0, 1}, std::log(factor)}});
    }
    const ControlSpaces after = spaces_.make();
    for (const std::size_t p : {0u, 1u}) {
      EXPECT_NEAR(sizes_of(after, p)[0].h11, factor * sizes_of(before, p)[0].h11, 1e-9);
    }
  }
}

}  // namespace
}  // namespace surfmesh::detail
