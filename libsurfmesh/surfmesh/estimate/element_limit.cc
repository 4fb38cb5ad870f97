// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/estimate/element_limit.hh"

#include <fmt/format.h>

#include <string>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Shares of the limit that leave room for the error of estimates.
constexpr double kSurelyTooMany = 1.15;
constexpr double kSurelyFewEnough = 0.85;

}  // namespace

double estimated_elements(const TriangleEstimate& estimate, const RunContext& context) {
  return elements_per_triangle(context.element_kind()) * estimate.triangles();
}

bool is_surely_above(const TriangleEstimate& estimate, const RunContext& context) {
  return estimated_elements(estimate, context) >
         kSurelyTooMany * static_cast<double>(context.max_elements());
}

void throw_too_many(const TriangleEstimate& estimate, double hmax, const RunContext& context) {
  const auto most = static_cast<double>(context.max_elements());
  const auto hmin = estimate.fitting_hmin(kSurelyFewEnough * most /
                                          elements_per_triangle(context.element_kind()));
  const std::string advice =
      !hmin ? std::string("tubes thinner than hmin need most of them, whatever hmin is")
            : fmt::format("{} = {:.3g} (in model units) would fit", *hmin > hmax ? "size" : "hmin",
                          *hmin);
  throw Error(ErrorCode::Limit,
              fmt::format("the sizes ask for about {:.2g} {}, more than max_elements = {}; {}",
                          estimated_elements(estimate, context), name(context.element_kind()),
                          context.max_elements(), advice));
}

}  // namespace surfmesh
