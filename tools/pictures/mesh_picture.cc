// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/mesh_picture.hh"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>

namespace surfmesh {
namespace {

/// Faces at about one depth, which are drawn shade by shade: fewer, and paths take more space;
/// more, and faces would cover others that lie before them.
constexpr std::size_t kFacesAtOnce = 400;

/// Shades of grey, from dark to bright.
constexpr int kShades = 12;
constexpr double kDarkest = 0.45;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Runs through the edges of a mesh, each once.
class EdgeLines {
 public:
  EdgeLines(const PolyMesh& mesh, const std::function<PicturePoint(VertexHandle)>& at)
      : mesh_(mesh), is_drawn_(mesh.n_edges(), 0) {
    points_.reserve(mesh.n_vertices());
    for (const VertexHandle vh : mesh.vertices()) points_.push_back(at(vh));
  }

  std::vector<std::vector<PicturePoint>> run() {
    std::vector<std::vector<PicturePoint>> lines;
    for (const EdgeHandle eh : mesh_.edges()) {
      if (is_drawn(eh)) continue;
      HalfedgeHandle heh = mesh_.halfedge_handle(eh, 0);
      std::vector<PicturePoint>& line = lines.emplace_back();
      line.push_back(point(mesh_.from_vertex_handle(heh)));
      while (heh.is_valid()) {
        is_drawn(mesh_.edge_handle(heh)) = 1;
        line.push_back(point(mesh_.to_vertex_handle(heh)));
        heh = straightest_after(heh);
      }
    }
    return lines;
  }

 private:
  char& is_drawn(EdgeHandle eh) { return is_drawn_[static_cast<std::size_t>(eh.idx())]; }

  const PicturePoint& point(VertexHandle vh) const {
    return points_[static_cast<std::size_t>(vh.idx())];
  }

  /// The edge not drawn yet that turns least from another one; invalid if there is none.
  HalfedgeHandle straightest_after(HalfedgeHandle heh) {
    const VertexHandle tip = mesh_.to_vertex_handle(heh);
    const PicturePoint from = point(mesh_.from_vertex_handle(heh)), at = point(tip);
    HalfedgeHandle best;
    double best_cosine = -2;
    for (const HalfedgeHandle next : mesh_.voh_range(tip)) {
      if (is_drawn(mesh_.edge_handle(next))) continue;
      const PicturePoint to = point(mesh_.to_vertex_handle(next));
      const double dot = (at.x - from.x) * (to.x - at.x) + (at.y - from.y) * (to.y - at.y);
      const double length =
          std::hypot(to.x - at.x, to.y - at.y) * std::hypot(at.x - from.x, at.y - from.y);
      const double cosine = length > 0 ? dot / length : 0;
      if (cosine > best_cosine) {
        best_cosine = cosine;
        best = next;
      }
    }
    return best;
  }

  const PolyMesh& mesh_;
  std::vector<char> is_drawn_;
  std::vector<PicturePoint> points_;
};

/// The axes of a camera: to the right, upwards, and towards the camera.
struct CameraAxes {
  Eigen::Vector3d right, up, towards;

  explicit CameraAxes(const Camera& camera) {
    const double a = radians(camera.azimuth), e = radians(camera.elevation);
    towards = {std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e)};
    right = {-std::sin(a), std::cos(a), 0};
    up = towards.cross(right);
  }
};

struct SeenFace {
  std::vector<Eigen::Vector2d> corners;
  double depth = 0;  ///< along the axis towards the camera
  int shade = 0;
};

/// The faces of a mesh that a camera sees, from back to front.
class SeenFaces {
 public:
  SeenFaces(const PolyMesh& mesh, const SurfaceView& view) : axes_(view.camera) {
    light_ = (axes_.towards + 0.6 * axes_.up - 0.5 * axes_.right).normalized();
    for (const FaceHandle fh : mesh.faces()) add(mesh, fh, view.part);
    std::sort(faces_.begin(), faces_.end(),
              [](const SeenFace& a, const SeenFace& b) { return a.depth < b.depth; });
  }

  const std::vector<SeenFace>& faces() const { return faces_; }

  /// Around the faces of the part that fills the frame; empty if there are none.
  const Eigen::AlignedBox2d& box() const { return box_; }

 private:
  void add(const PolyMesh& mesh, FaceHandle fh, const Eigen::AlignedBox3d& part) {
    std::vector<Eigen::Vector3d> corners;
    for (const VertexHandle vh : mesh.fv_range(fh)) {
      const auto& p = mesh.point(vh);
      corners.emplace_back(p[0], p[1], p[2]);
    }
    const Eigen::Vector3d normal =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    if (!(normal.dot(axes_.towards) > 0)) return;
    SeenFace& face = faces_.emplace_back();
    bool is_in_part = true;
    for (const Eigen::Vector3d& corner : corners) {
      face.corners.emplace_back(corner.dot(axes_.right), corner.dot(axes_.up));
      face.depth += corner.dot(axes_.towards) / static_cast<double>(corners.size());
      is_in_part = is_in_part && part.contains(corner);
    }
    const double light = std::clamp(normal.dot(light_), 0.0, 1.0);
    face.shade = static_cast<int>(std::lround(light * (kShades - 1)));
    if (!is_in_part) return;
    for (const Eigen::Vector2d& corner : face.corners) box_.extend(corner);
  }

  CameraAxes axes_;
  Eigen::Vector3d light_;
  Eigen::AlignedBox2d box_;
  std::vector<SeenFace> faces_;
};

/// The polygons of a number of faces by shade, without those beyond the frame.
std::map<int, std::vector<std::vector<PicturePoint>>> polygons_by_shade(
    std::span<const SeenFace> faces, const PlaneView& plane, const PictureFrame& frame) {
  const Eigen::AlignedBox2d inside(
      Eigen::Vector2d(frame.corner.x, frame.corner.y),
      Eigen::Vector2d(frame.corner.x + frame.width, frame.corner.y + frame.height));
  std::map<int, std::vector<std::vector<PicturePoint>>> polygons;
  for (const SeenFace& face : faces) {
    std::vector<PicturePoint> polygon;
    Eigen::AlignedBox2d around;
    for (const Eigen::Vector2d& corner : face.corners) {
      polygon.push_back(plane(corner.x(), corner.y()));
      around.extend(Eigen::Vector2d(polygon.back().x, polygon.back().y));
    }
    if (inside.intersects(around)) polygons[face.shade].push_back(std::move(polygon));
  }
  return polygons;
}

}  // namespace

PlaneView::PlaneView(const Eigen::AlignedBox2d& box, const PictureFrame& frame)
    : centre_(box.center()),
      middle_{frame.corner.x + 0.5 * frame.width, frame.corner.y + 0.5 * frame.height},
      scale_(std::min(frame.width / box.sizes().x(), frame.height / box.sizes().y())) {}

PicturePoint PlaneView::operator()(double x, double y) const {
  return {middle_.x + scale_ * (x - centre_.x()), middle_.y - scale_ * (y - centre_.y())};
}

std::vector<std::vector<PicturePoint>> edge_lines(
    const PolyMesh& mesh, const std::function<PicturePoint(VertexHandle)>& at) {
  return EdgeLines(mesh, at).run();
}

void draw_surface(Svg& svg, const PolyMesh& mesh, const SurfaceView& view,
                  const PictureFrame& frame) {
  const SeenFaces seen(mesh, view);
  if (seen.box().isEmpty()) return;
  const PlaneView plane(seen.box(), frame);
  const std::span<const SeenFace> faces = seen.faces();
  for (std::size_t first = 0; first < faces.size(); first += kFacesAtOnce) {
    const std::size_t count = std::min(kFacesAtOnce, faces.size() - first);
    for (auto& [shade, polygons] : polygons_by_shade(faces.subspan(first, count), plane, frame)) {
      // From left to right: short steps from one to the next take less space.
      std::sort(polygons.begin(), polygons.end(),
                [](const auto& a, const auto& b) { return a[0].x < b[0].x; });
      const double brightness = kDarkest + (1 - kDarkest) * shade / (kShades - 1);
      svg.add_polygons(polygons, {grey(brightness), "#202020", view.line_width});
    }
  }
}

}  // namespace surfmesh
