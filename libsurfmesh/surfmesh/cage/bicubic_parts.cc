// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/bicubic_parts.hh"

#include <algorithm>
#include <limits>
#include <optional>

namespace surfmesh::detail {
namespace {

/// Points of a square at which a polynomial is compared with the surface, in shares of its side.
constexpr std::array<Uv, 2> kProbes = {Uv{0.381, 0.274}, Uv{0.653, 0.797}};

/// Greatest distance of the two that is rounding: of some ten operations each on coordinates as
/// large as those of the corners. Pieces that are none differ by 1e-6 of their own size and more.
constexpr double kRounding = 32 * std::numeric_limits<double>::epsilon();

/// Finds the pieces from the whole face downwards.
class PartFinder {
 public:
  PartFinder(const std::function<Jet(Uv, Order)>& surface, int finest)
      : surface_(surface),
        finest_(finest),
        jets_(static_cast<std::size_t>((finest + 1) * (finest + 1))) {}

  /// Call `found(i, j, width, polynomial)` for all pieces in a square, which is counted in the
  /// smallest ones.
  template <class Found>
  void find(int i, int j, int width, const Found& found) {
    const std::array<Jet, 4> corners = {jet(i, j), jet(i + width, j), jet(i + width, j + width),
                                        jet(i, j + width)};
    if (const auto polynomial = polynomial_in(i, j, width, corners)) {
      found(i, j, width, *polynomial);
    } else if (width > 1) {
      const int half = width / 2;
      for (const int dj : {0, half}) {
        for (const int di : {0, half}) find(i + di, j + dj, half, found);
      }
    }
  }

 private:
  /// The surface at a corner of smallest squares.
  const Jet& jet(int i, int j) {
    std::optional<Jet>& known = jets_[static_cast<std::size_t>(j * (finest_ + 1) + i)];
    if (!known) known = surface_({double(i) / finest_, double(j) / finest_}, Order::Second);
    return *known;
  }

  std::optional<BicubicPolynomial> polynomial_in(int i, int j, int width,
                                                 std::array<Jet, 4> corners) const {
    const double side = double(width) / finest_;
    double greatest = 0;
    for (Jet& jet : corners) {
      if (!BicubicPolynomial::can_have(jet)) return {};
      jet.du *= side;
      jet.dv *= side;
      jet.duv *= side * side;
      greatest = std::max(greatest, jet.point.cwiseAbs().maxCoeff());
    }
    const BicubicPolynomial polynomial(corners);
    for (const Uv probe : kProbes) {
      const Uv uv{double(i) / finest_ + side * probe.u, double(j) / finest_ + side * probe.v};
      const Vec3 difference =
          polynomial.evaluate(probe, Order::Position).point - surface_(uv, Order::Position).point;
      if (!(difference.cwiseAbs().maxCoeff() <= kRounding * greatest)) return {};
    }
    return polynomial;
  }

  const std::function<Jet(Uv, Order)>& surface_;
  int finest_;
  std::vector<std::optional<Jet>> jets_;
};

}  // namespace

Jet BicubicParts::Part::evaluate(Uv uv, Order order) const {
  const double n = squares_per_side_;
  Jet jet = polynomial_.evaluate({n * (uv.u - corner_.u), n * (uv.v - corner_.v)}, order);
  if (order >= Order::First) {
    jet.du *= n;
    jet.dv *= n;
  }
  if (order >= Order::Second) {
    jet.duu *= n * n;
    jet.duv *= n * n;
    jet.dvv *= n * n;
  }
  return jet;
}

BicubicParts::BicubicParts(const std::function<Jet(Uv, Order)>& surface) {
  part_of_.fill(-1);
  PartFinder(surface, kFinest)
      .find(0, 0, kFinest, [this](int i, int j, int width, const BicubicPolynomial& polynomial) {
        for (int row = j; row < j + width; ++row) {
          std::fill_n(part_of_.begin() + row * kFinest + i, width,
                      static_cast<std::int16_t>(parts_.size()));
        }
        parts_.emplace_back(Uv{double(i) / kFinest, double(j) / kFinest}, double(kFinest) / width,
                            polynomial);
      });
  parts_.shrink_to_fit();
}

const BicubicParts::Part* BicubicParts::find(Uv uv) const {
  const int i = std::clamp(static_cast<int>(kFinest * uv.u), 0, kFinest - 1);
  const int j = std::clamp(static_cast<int>(kFinest * uv.v), 0, kFinest - 1);
  const int part = part_of_[static_cast<std::size_t>(j * kFinest + i)];
  return part < 0 ? nullptr : &parts_[static_cast<std::size_t>(part)];
}

}  // namespace surfmesh::detail
