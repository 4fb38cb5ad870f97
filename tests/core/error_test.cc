// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/error.hh"

#include <gtest/gtest.h>

namespace surfmesh {
namespace {

TEST(Error, CarriesCodeAndText) {
  try {
    throw Error(ErrorCode::Io, "cannot open a.obj");
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot open a.obj");
    EXPECT_EQ(dynamic_cast<const Error&>(error).code(), ErrorCode::Io);
  }
}

TEST(Error, NamesEveryCodeDifferently) {
  EXPECT_STREQ(name(ErrorCode::InvalidInput), "invalid input");
  EXPECT_STREQ(name(ErrorCode::InvalidOption), "invalid option");
  EXPECT_STREQ(name(ErrorCode::MissingProperty), "missing property");
  EXPECT_STREQ(name(ErrorCode::Io), "io");
  EXPECT_STREQ(name(ErrorCode::Geometry), "geometry");
  EXPECT_STREQ(name(ErrorCode::Limit), "limit");
  EXPECT_STREQ(name(ErrorCode::Cancelled), "cancelled");
}

}  // namespace
}  // namespace surfmesh
