// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/mesh_picture.hh"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

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

  Eigen::AlignedBox2d box() const {
    Eigen::AlignedBox2d box;
    for (const SeenFace& face : faces_) {
      for (const Eigen::Vector2d& corner : face.corners) box.extend(corner);
    }
    return box;
  }

 private:
  void add(const PolyMesh& mesh, FaceHandle fh, const Eigen::AlignedBox3d& part) {
    std::vector<Eigen::Vector3d> corners;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const VertexHandle vh : mesh.fv_range(fh)) {
      const auto& p = mesh.point(vh);
      corners.emplace_back(p[0], p[1], p[2]);
      if (!part.contains(corners.back())) return;
      centre += corners.back();
    }
    centre /= static_cast<double>(corners.size());
    const Eigen::Vector3d normal =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    if (!(normal.dot(axes_.towards) > 0)) return;
    SeenFace& face = faces_.emplace_back();
    for (const Eigen::Vector3d& corner : corners) {
      face.corners.emplace_back(corner.dot(axes_.right), corner.dot(axes_.up));
    }
    face.depth = centre.dot(axes_.towards);
    const double light = std::clamp(normal.dot(light_), 0.0, 1.0);
    face.shade = static_cast<int>(std::lround(light * (kShades - 1)));
  }

  CameraAxes axes_;
  Eigen::Vector3d light_;
  std::vector<SeenFace> faces_;
};

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
  if (seen.faces().empty()) return;
  const PlaneView plane(seen.box(), frame);
  for (std::size_t first = 0; first < seen.faces().size(); first += kFacesAtOnce) {
    const std::size_t end = std::min(first + kFacesAtOnce, seen.faces().size());
    std::map<int, std::vector<std::vector<PicturePoint>>> by_shade;
    for (std::size_t i = first; i < end; ++i) {
      std::vector<PicturePoint>& polygon = by_shade[seen.faces()[i].shade].emplace_back();
      for (const Eigen::Vector2d& c : seen.faces()[i].corners) {
        polygon.push_back(plane(c.x(), c.y()));
      }
    }
    for (auto& [shade, polygons] : by_shade) {
      // From left to right: short steps from one to the next take less space.
      std::sort(polygons.begin(), polygons.end(),
                [](const auto& a, const auto& b) { return a[0].x < b[0].x; });
      const double brightness = kDarkest + (1 - kDarkest) * shade / (kShades - 1);
      svg.add_polygons(polygons, {grey(brightness), "#202020", view.line_width});
    }
  }
}

}  // namespace surfmesh
