// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/metric_beyond.hh"

#include <array>
#include <span>
#include <vector>

#include "surfmesh/across/face_parameters.hh"
#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/quality/corners_beyond.hh"
#include "surfmesh/quality/project_mesh.hh"

namespace surfmesh {
namespace {

class MetricBeyond {
 public:
  MetricBeyond(PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
               const std::function<Metric(const SurfacePlace&)>& metric_at)
      : mesh_(mesh),
        search_(search),
        metric_at_(metric_at),
        beyond_(mesh),
        patch_of_(require(mesh, keys::face_patch)),
        uv_of_(require(mesh, keys::corner_uv)),
        metric_of_(require(mesh, keys::corner_metric)),
        on_surface_(surface_tolerance(mesh, model)),
        orientation_(orient_patches(model)),
        walk_(model, std::vector<char>(model.contours.size(), 0)),
        maker_(model, no_fields_, walk_, orientation_.is_turned) {}

  void run() {
    for (const FaceHandle fh : mesh_.faces()) {
      if (beyond_.any_of(fh)) set(fh);
    }
  }

 private:
  SurfacePlace place_of(HalfedgeHandle corner) const {
    const VertexHandle vh = mesh_.to_vertex_handle(corner);
    const HalfedgeHandle found = beyond_(corner) ? beyond_.corner_on_patch(vh) : corner;
    if (found.is_valid()) {
      return {mesh_.property(patch_of_, mesh_.face_handle(found)), mesh_.property(uv_of_, found)};
    }
    const NearPoint near =
        search_.nearest_around(to_eigen(mesh_.point(vh)), beyond_.patches_around(vh), on_surface_);
    return {near.patch, near.uv};
  }

  void set(FaceHandle fh) {
    std::array<VertexChart, 4> charts;
    std::array<FaceCornerSites, 4> corners;
    std::array<HalfedgeHandle, 4> handles;
    FaceInPatch face;
    face.patch = mesh_.property(patch_of_, fh);
    std::size_t count = 0;
    bool is_whole = true;
    for_each_corner(mesh_, fh, [&](HalfedgeHandle corner) {
      const SurfacePlace place = place_of(corner);
      const auto made = maker_.make(place, metric_at_(place));
      is_whole = is_whole && made;
      if (made) charts[count] = *made;
      corners[count].chart = &charts[count];
      face.uvs[count] = mesh_.property(uv_of_, corner);
      face.metrics[count] = made ? made->metric : metric_at_(place);
      handles[count++] = corner;
    });
    if (is_whole) FaceParameters(maker_).set_metrics(std::span(corners).first(count), face);
    for (std::size_t k = 0; k < count; ++k) {
      mesh_.property(metric_of_, handles[k]) = face.metrics[k];
    }
  }

  PolyMesh& mesh_;
  const SurfaceSearch& search_;
  const std::function<Metric(const SurfacePlace&)>& metric_at_;
  detail::CornersBeyond beyond_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  decltype(keys::corner_metric)::Handle metric_of_;
  double on_surface_;  ///< distances below are rounding
  PatchOrientation orientation_;
  SurfaceWalk walk_;
  std::vector<const MetricField*> no_fields_;  ///< metrics are known
  ChartMaker maker_;
};

}  // namespace

void set_metrics_beyond(PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
                        const std::function<Metric(const SurfacePlace&)>& metric_at) {
  if (!find(mesh, keys::corner_beyond).is_valid()) return;
  MetricBeyond(mesh, model, search, metric_at).run();
}

}  // namespace surfmesh
