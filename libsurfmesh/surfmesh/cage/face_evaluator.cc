// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/face_evaluator.hh"

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <array>

#include "surfmesh/cage/primvar.hh"

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
class RefinedFaces {
 public:
  RefinedFaces(const Far::TopologyRefiner& base, const std::vector<Vec3>& cage_points,
               const std::vector<int>& faces, int level) {
    const Far::ConstIndexArray selected(faces.data(), static_cast<int>(faces.size()));
    const Far::PatchTableFactory::Options options = options_at(level);
    const std::unique_ptr<Far::TopologyRefiner> refiner(
        Far::TopologyRefinerFactory<Far::TopologyDescriptor>::Create(base));
    refiner->RefineAdaptive(options.GetRefineAdaptiveOptions(), selected);
    table_.reset(Far::PatchTableFactory::Create(*refiner, options, selected));
    map_ = std::make_unique<Far::PatchMap>(*table_);
    refine_points(*refiner, cage_points);
  }

  Jet evaluate(int face, Uv uv, Order order) const {
    const Far::PatchTable::PatchHandle& patch = *map_->FindPatch(face, uv.u, uv.v);
    std::array<Weights, 6> w;
    const bool has_first = order >= Order::First, has_second = order >= Order::Second;
    table_->EvaluateBasis(patch, uv.u, uv.v, w[0].data(), has_first ? w[1].data() : nullptr,
                          has_first ? w[2].data() : nullptr, has_second ? w[3].data() : nullptr,
                          has_second ? w[4].data() : nullptr, has_second ? w[5].data() : nullptr);
    const Far::ConstIndexArray vertices = table_->GetPatchVertices(patch);
    Jet jet;
    jet.point = sum(vertices, w[0]);
    if (has_first) {
      jet.du = sum(vertices, w[1]);
      jet.dv = sum(vertices, w[2]);
    }
    if (has_second) {
      jet.duu = sum(vertices, w[3]);
      jet.duv = sum(vertices, w[4]);
      jet.dvv = sum(vertices, w[5]);
    }
    return jet;
  }

 private:
  /// Of the points of a patch, of which the largest, Gregory's, have 20.
  using Weights = std::array<double, 20>;

  static Far::PatchTableFactory::Options options_at(int level) {
    Far::PatchTableFactory::Options options(static_cast<unsigned>(level));
    options.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    options.SetPatchPrecision<double>();
    options.useInfSharpPatch = true;
    options.generateLegacySharpCornerPatches = false;
    options.generateVaryingTables = false;
    return options;
  }

  /// The points of all levels, and then those of the patches at extraordinary vertices.
  void refine_points(const Far::TopologyRefiner& refiner, const std::vector<Vec3>& cage_points) {
    const int count = refiner.GetNumVerticesTotal();
    points_.resize(static_cast<std::size_t>(count + table_->GetNumLocalPoints()));
    for (std::size_t i = 0; i < cage_points.size(); ++i) points_[i].point = cage_points[i];
    const Far::PrimvarRefinerReal<double> primvar_refiner(refiner);
    Primvar* from = points_.data();
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
      Primvar* to = from + refiner.GetLevel(level - 1).GetNumVertices();
      primvar_refiner.Interpolate(level, from, to);
      from = to;
    }
    if (table_->GetNumLocalPoints() == 0) return;
    table_->GetLocalPointStencilTable<double>()->UpdateValues(points_.data(),
                                                              points_.data() + count);
  }

  Vec3 sum(const Far::ConstIndexArray& vertices, const Weights& weights) const {
    Vec3 result = Vec3::Zero();
    for (int i = 0; i < vertices.size(); ++i) {
      result += weights[static_cast<std::size_t>(i)] *
                points_[static_cast<std::size_t>(vertices[i])].point;
    }
    return result;
  }

  std::unique_ptr<const Far::PatchTable> table_;
  std::unique_ptr<const Far::PatchMap> map_;
  std::vector<Primvar> points_;
};

class SharedEvaluator : public FaceEvaluator {
 public:
  SharedEvaluator(std::shared_ptr<const RefinedFaces> faces, int face)
      : faces_(std::move(faces)), face_(face) {}

  Jet evaluate(Uv uv, Order order) const override { return faces_->evaluate(face_, uv, order); }

 private:
  std::shared_ptr<const RefinedFaces> faces_;
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
  const auto refined =
      std::make_shared<const RefinedFaces>(refiner, cage_points, faces, approximation_level);
  for (const int face : faces) result.push_back(std::make_unique<SharedEvaluator>(refined, face));
  return result;
}

}  // namespace surfmesh
