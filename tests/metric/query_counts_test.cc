// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {
namespace {

TEST(QueryCounts, AddEachKind) {
  QueryCounts counts = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  counts += {10, 20, 30, 40, 50, 60, 70, 80, 90};
  EXPECT_EQ(counts, (QueryCounts{11, 22, 33, 44, 55, 66, 77, 88, 99}));
}

TEST(QueryCounts, TotalIsThatOfAnswers) {
  const QueryCounts counts = {1, 2, 4, 8, 16, 32, 64, 128, 256};
  EXPECT_EQ(counts.total(), 127u);
}

}  // namespace
}  // namespace surfmesh
