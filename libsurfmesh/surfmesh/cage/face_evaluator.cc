// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/face_evaluator.hh"

#include <array>
#include <utility>

#include "surfmesh/cage/primvar.hh"
#include "surfmesh/cage/refined_faces.hh"

namespace surfmesh {
namespace {

namespace Bfr = OpenSubdiv::Bfr;
namespace Far = OpenSubdiv::Far;

using BfrSurface = Bfr::Surface<double>;

/// Three coordinates, one after the other.
const BfrSurface::PointDescriptor kXyz(3);

/// A Vec3 array is handed to OpenSubdiv as doubles.
static_assert(sizeof(Vec3) == 3 * sizeof(double));

class BfrEvaluator : public FaceEvaluator {
 public:
  BfrEvaluator(const BfrSurface& surface, const std::vector<Vec3>& cage_points)
      : surface_(surface), points_(static_cast<std::size_t>(surface.GetNumPatchPoints())) {
    surface_.PreparePatchPoints(cage_points[0].data(), kXyz, points_[0].data(), kXyz);
  }

  Jet evaluate(Uv uv, Order order) const override {
    const std::array<double, 2> at = {uv.u, uv.v};
    const double* points = points_[0].data();
    Jet jet;
    switch (order) {
      case Order::Position:
        surface_.Evaluate(at.data(), points, kXyz, jet.point.data());
        break;
      case Order::First:
        surface_.Evaluate(at.data(), points, kXyz, jet.point.data(), jet.du.data(), jet.dv.data());
        break;
      case Order::Second:
        surface_.Evaluate(at.data(), points, kXyz, jet.point.data(), jet.du.data(), jet.dv.data(),
                          jet.duu.data(), jet.duv.data(), jet.dvv.data());
        break;
    }
    return jet;
  }

 private:
  BfrSurface surface_;
  std::vector<Vec3> points_;
};

/// The patches of some faces, with their points.
using RefinedPoints = detail::RefinedFaces<Primvar>;

class SharedEvaluator : public FaceEvaluator {
 public:
  SharedEvaluator(std::shared_ptr<const RefinedPoints> faces, int face)
      : faces_(std::move(faces)), face_(face) {}

  Jet evaluate(Uv uv, Order order) const override {
    const auto values = faces_->evaluate(face_, uv, order);
    Jet jet;
    jet.point = values[0].point;
    if (order >= Order::First) {
      jet.du = values[1].point;
      jet.dv = values[2].point;
    }
    if (order >= Order::Second) {
      jet.duu = values[3].point;
      jet.duv = values[4].point;
      jet.dvv = values[5].point;
    }
    return jet;
  }

 private:
  std::shared_ptr<const RefinedPoints> faces_;
  int face_;
};

}  // namespace

std::unique_ptr<const FaceEvaluator> make_bfr_evaluator(const BfrSurface& surface,
                                                        const std::vector<Vec3>& cage_points) {
  return std::make_unique<BfrEvaluator>(surface, cage_points);
}

std::vector<std::unique_ptr<const FaceEvaluator>> make_shared_evaluators(
    const Far::TopologyRefiner& refiner, const std::vector<Vec3>& cage_points,
    const std::vector<int>& faces, int approximation_level) {
  std::vector<std::unique_ptr<const FaceEvaluator>> result;
  if (faces.empty()) return result;
  std::vector<Primvar> points;
  for (const Vec3& point : cage_points) points.push_back({point});
  const auto refined =
      std::make_shared<const RefinedPoints>(refiner, std::move(points), faces, approximation_level);
  for (const int face : faces) result.push_back(std::make_unique<SharedEvaluator>(refined, face));
  return result;
}

}  // namespace surfmesh
