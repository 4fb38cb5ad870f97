// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/region_parameters.hh"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>

#include "surfmesh/across/face_parameters.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// Triangles below this quality spoil what is around, unless there were such before.
constexpr double kFlatTriangle = 0.4;

class RegionParameters {
 public:
  RegionParameters(const RegionInput& input, const RegionWork& work, const ChartMaker& maker)
      : work_(work),
        mesh_(*work.region.mesh),
        result_(input.result),
        sheets_(input.sheets),
        parameters_(maker),
        patch_of_(require(result_, keys::face_patch)),
        uv_of_(require(result_, keys::corner_uv)),
        metric_of_(require(result_, keys::corner_metric)),
        beyond_(find(result_, keys::corner_beyond)) {}

  /// A face as the result has it.
  FaceInPatch of_result(FaceHandle old) const {
    FaceInPatch face;
    face.patch = result_.property(patch_of_, old);
    std::size_t k = 0;
    for_each_corner(result_, old, [&](HalfedgeHandle heh) {
      const HalfedgeHandle corner = result_.prev_halfedge_handle(heh);
      face.uvs[k] = result_.property(uv_of_, corner);
      face.is_beyond[k] = is_beyond(corner);
      face.metrics[k++] = result_.property(metric_of_, corner);
    });
    return face;
  }

  std::vector<FaceInPatch> find_all() const {
    std::vector<FaceInPatch> faces(work_.editor->face_bound());
    std::vector<FaceCornerSites> corners(4);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const FaceHandle fh(static_cast<int>(f));
      if (!work_.editor->is_used(fh)) continue;
      faces[f] = is_as_before(fh) ? of_result(work_.region.faces[f]) : found(fh, corners);
    }
    return faces;
  }

 private:
  /// True if a face is the one that was taken, with its vertices where they were.
  bool is_as_before(FaceHandle fh) const {
    if (index(fh) >= work_.region.faces.size()) return false;
    const HalfedgeHandle start = result_.halfedge_handle(work_.region.faces[index(fh)]);
    HalfedgeHandle old = start;
    bool is_same = true;
    for_each_corner(mesh_, fh, [&](HalfedgeHandle heh) {
      const VertexHandle vh = mesh_.from_vertex_handle(heh);
      is_same = is_same && !work_.is_moved(vh) &&
                work_.origin(vh) == result_.from_vertex_handle(old).idx();
      old = result_.next_halfedge_handle(old);
    });
    return is_same && old == start;
  }

  /// The face where the charts of its vertices are, if these are on one patch that does not meet
  /// itself: that of nearly all faces.
  std::optional<FaceInPatch> on_one_patch(FaceHandle fh) const {
    FaceInPatch face;
    std::size_t k = 0;
    bool is_one = true;
    for_each_corner(mesh_, fh, [&](HalfedgeHandle heh) {
      const VertexHandle vh = mesh_.from_vertex_handle(heh);
      const VertexChart& chart = work_.charts[index(vh)];
      if (k == 0) face.patch = chart.place.patch;
      is_one = is_one && chart.place.patch == face.patch && !chart.meets_itself &&
               (work_.is_moved(vh) || work_.is_singular[index(vh)] == 0);
      face.uvs[k] = chart.place.uv;
      face.metrics[k++] = chart.metric;
    });
    if (!is_one) return {};
    return face;
  }

  FaceInPatch found(FaceHandle fh, std::vector<FaceCornerSites>& sites) const {
    if (const auto face = on_one_patch(fh)) return *face;
    std::size_t count = 0;
    for_each_corner(mesh_, fh, [&](HalfedgeHandle heh) {
      collect_sites(mesh_.from_vertex_handle(heh), sites[count++]);
    });
    return parameters_.find(std::span(sites).first(count));
  }

  /// The patches on which a vertex lies: one on a contour that has not moved lies on several. Those
  /// beyond a contour that stays, at the border of a group for instance, are none of the region's.
  void collect_sites(VertexHandle vh, FaceCornerSites& corner) const {
    const VertexChart& chart = work_.charts[index(vh)];
    corner.chart = &chart;
    corner.sites.clear();
    corner.is_singular = false;
    const int old = work_.origin(vh);
    if (work_.is_moved(vh) || old < 0) {
      corner.sites.push_back({chart.place.patch, chart.place.uv, chart.metric});
      return;
    }
    corner.is_singular = work_.is_singular[index(vh)] != 0;
    for (const HalfedgeHandle heh : result_.vih_range(VertexHandle(old))) {
      if (result_.is_boundary(heh) || is_beyond(heh)) continue;
      const InPatch site{result_.property(patch_of_, result_.face_handle(heh)),
                         result_.property(uv_of_, heh), result_.property(metric_of_, heh)};
      if (sheet(site.patch) != sheet(chart.place.patch)) continue;
      const bool is_known = std::ranges::any_of(corner.sites, [&](const InPatch& known) {
        return known.patch == site.patch && known.uv == site.uv;
      });
      if (!is_known) corner.sites.push_back(site);
    }
    // All faces around it may be of other patches than its own.
    if (corner.sites.empty()) {
      corner.sites.push_back({chart.place.patch, chart.place.uv, chart.metric});
    }
  }

  std::size_t sheet(int patch) const { return sheets_[static_cast<std::size_t>(patch)]; }

  bool is_beyond(HalfedgeHandle corner) const {
    return beyond_.is_valid() && result_.property(beyond_, corner) != 0;
  }

  const RegionWork& work_;
  const PolyMesh& mesh_;
  const PolyMesh& result_;
  const std::vector<std::size_t>& sheets_;
  FaceParameters parameters_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  decltype(keys::corner_metric)::Handle metric_of_;
  decltype(keys::corner_beyond)::Handle beyond_;
};

/// The quality of a triangle, or the least scaled Jacobian of a quad, in (u,v) as the mesh goes
/// around its patch.
double quality_of(const FaceInPatch& face, std::size_t corners, double sign) {
  const auto& m = face.metrics;
  if (corners == 3) {
    return sign * triangle_quality(face.uvs[0], face.uvs[1], face.uvs[2], mean(m[0], m[1], m[2]));
  }
  double least = 1;
  for (std::size_t k = 0; k < corners; ++k) {
    const Uv next = face.uvs[(k + 1) % corners] - face.uvs[k];
    const Uv previous = face.uvs[(k + corners - 1) % corners] - face.uvs[k];
    const double product = squared_length(m[k], next) * squared_length(m[k], previous);
    const double area = sign * density(m[k]) * cross(next, previous);
    least = std::min(least, product > 0 ? area / std::sqrt(product) : 0);
  }
  return least;
}

/// Adds faces to the quality of a region.
class QualitySum {
 public:
  explicit QualitySum(const ChartMaker& maker) : maker_(maker) {}

  double quality(const FaceInPatch& face, std::size_t corners) const {
    return quality_of(face, corners, maker_.is_turned(face.patch) ? -1 : 1);
  }

  void add(const FaceInPatch& face, std::size_t corners) {
    const double own = quality(face, corners);
    if (own < 0) ++sum_.inverted;
    if (corners == 3) sum_.least = std::min(sum_.least, own);
    sum_.mean += own;
    ++count_;
  }

  RegionQuality result() const {
    RegionQuality result = sum_;
    if (count_ > 0) result.mean /= static_cast<double>(count_);
    return result;
  }

 private:
  const ChartMaker& maker_;
  RegionQuality sum_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<FaceInPatch> faces_in_patches(const RegionInput& input, const RegionWork& work,
                                          const ChartMaker& maker) {
  return RegionParameters(input, work, maker).find_all();
}

RegionQuality quality_before(const RegionInput& input, const RegionWork& work,
                             const ChartMaker& maker) {
  const RegionParameters parameters(input, work, maker);
  QualitySum sum(maker);
  for (const FaceHandle fh : work.region.faces) {
    sum.add(parameters.of_result(fh), input.result.valence(fh));
  }
  return sum.result();
}

RegionQuality quality_now(const RegionWork& work, const ChartMaker& maker) {
  QualitySum sum(maker);
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    if (work.editor->is_used(fh)) sum.add(work.faces[f], work.region.mesh->valence(fh));
  }
  return sum.result();
}

FacePiece without_spoilt(const RegionInput& input, const RegionWork& work,
                         const ChartMaker& maker) {
  const double flat = std::min(kFlatTriangle, quality_before(input, work, maker).least);
  const QualitySum measure(maker);
  std::vector<FaceHandle> around;
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    if (!work.editor->is_used(fh)) continue;
    const std::size_t corners = work.region.mesh->valence(fh);
    if (measure.quality(work.faces[f], corners) >= (corners == 3 ? flat : 0)) continue;
    for (const VertexHandle vh : work.region.mesh->fv_range(fh)) {
      const int origin = work.origin(vh);
      if (origin < 0) continue;
      for (const FaceHandle near : input.result.vf_range(VertexHandle(origin))) {
        around.push_back(near);
      }
    }
  }
  std::sort(around.begin(), around.end());
  FacePiece rest;
  std::ranges::copy_if(work.region.faces, std::back_inserter(rest), [&](FaceHandle fh) {
    return !std::binary_search(around.begin(), around.end(), fh);
  });
  return rest;
}

}  // namespace surfmesh
