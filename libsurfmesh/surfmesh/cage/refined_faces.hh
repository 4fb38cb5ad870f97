// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Shows OpenSubdiv's types; for sources of this folder only.

#include <fmt/format.h>
#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh::detail {

namespace Far = OpenSubdiv::Far;

/// The patches of some faces by OpenSubdiv's Far, with values at their points. A value is what
/// OpenSubdiv's interpolation combines, with Clear and AddWithWeight.
template <class Value>
class RefinedFaces {
 public:
  /// `values` are those of the vertices of the cage; features are isolated to the level.
  RefinedFaces(const Far::TopologyRefiner& base, std::vector<Value> values,
               const std::vector<int>& faces, int level)
      : values_(std::move(values)) {
    const Far::ConstIndexArray selected(faces.data(), static_cast<int>(faces.size()));
    const Far::PatchTableFactory::Options options = options_at(level);
    const std::unique_ptr<Far::TopologyRefiner> refiner(
        Far::TopologyRefinerFactory<Far::TopologyDescriptor>::Create(base));
    refiner->RefineAdaptive(options.GetRefineAdaptiveOptions(), selected);
    table_.reset(Far::PatchTableFactory::Create(*refiner, options, selected));
    map_ = std::make_unique<Far::PatchMap>(*table_);
    refine(*refiner);
  }

  /// True if there is a surface at a point of a face: not in holes, nor in faces at the border
  /// under BoundaryRule::None. Faces are numbered as Ptex does: as those of the cage where all have
  /// the scheme's size.
  bool has(int face, Uv uv) const { return map_->FindPatch(face, uv.u, uv.v) != nullptr; }

  /// The value at a point of a face and, up to the order, its derivatives by u, v, uu, uv and vv.
  ///
  /// Throws   Geometry where there is no surface
  std::array<Value, 6> evaluate(int face, Uv uv, Order order) const {
    const Far::PatchTable::PatchHandle* found = map_->FindPatch(face, uv.u, uv.v);
    if (found == nullptr) {
      throw Error(ErrorCode::Geometry, fmt::format("face {} has no limit surface", face));
    }
    const Far::PatchTable::PatchHandle& patch = *found;
    std::array<Weights, 6> w;
    const bool has_first = order >= Order::First, has_second = order >= Order::Second;
    table_->EvaluateBasis(patch, uv.u, uv.v, w[0].data(), has_first ? w[1].data() : nullptr,
                          has_first ? w[2].data() : nullptr, has_second ? w[3].data() : nullptr,
                          has_second ? w[4].data() : nullptr, has_second ? w[5].data() : nullptr);
    const Far::ConstIndexArray vertices = table_->GetPatchVertices(patch);
    const std::size_t count = has_second ? 6 : has_first ? 3 : 1;
    std::array<Value, 6> result;
    for (std::size_t i = 0; i < count; ++i) result[i] = sum(vertices, w[i]);
    return result;
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

  /// The values of all levels, and then those of the patches at extraordinary vertices.
  void refine(const Far::TopologyRefiner& refiner) {
    const int count = refiner.GetNumVerticesTotal();
    values_.resize(static_cast<std::size_t>(count + table_->GetNumLocalPoints()));
    const Far::PrimvarRefinerReal<double> primvar_refiner(refiner);
    Value* from = values_.data();
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
      Value* to = from + refiner.GetLevel(level - 1).GetNumVertices();
      primvar_refiner.Interpolate(level, from, to);
      from = to;
    }
    if (table_->GetNumLocalPoints() == 0) return;
    table_->template GetLocalPointStencilTable<double>()->UpdateValues(values_.data(),
                                                                       values_.data() + count);
  }

  Value sum(const Far::ConstIndexArray& vertices, const Weights& weights) const {
    Value result;
    for (int i = 0; i < vertices.size(); ++i) {
      result.AddWithWeight(values_[static_cast<std::size_t>(vertices[i])],
                           weights[static_cast<std::size_t>(i)]);
    }
    return result;
  }

  std::unique_ptr<const Far::PatchTable> table_;
  std::unique_ptr<const Far::PatchMap> map_;
  std::vector<Value> values_;
};

}  // namespace surfmesh::detail
