// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/scene.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pictures/triangulate_polygon.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

/// Faces that meet at more than this angle have an edge between them, in meshes without patches.
constexpr double kSharpDegrees = 40;

/// Brightness in the shade and in full light, and the number of steps between them.
constexpr double kDarkest = 0.62, kBrightest = 1.06, kShades = 64;

/// Distance of the eye in perspective, in radii of the ball around the mesh.
constexpr double kEyeDistance = 4;

/// Points that are looked at are at most this share of the way to the eye: beyond it they are a
/// thousand times as large as at the mesh, and at the eye itself infinite.
constexpr double kNearestShare = 0.999;

/// One axis of parameters may be shorter than the other by so much.
constexpr double kGreatestSlimness = 5;

double cross(const ScenePoint& a, const ScenePoint& b, const ScenePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Makes the faces and edges of a scene.
class SceneFaces {
 public:
  SceneFaces(const PolyMesh& mesh, Scene& scene, const MeshPaint& paint)
      : mesh_(mesh), scene_(scene), paint_(paint), corner_(mesh.n_halfedges(), -1) {}

  /// The point of the scene at the tip of a halfedge.
  int& corner(HalfedgeHandle heh) { return corner_[index(heh)]; }

  /// Add a face whose corners have their points. `shade` is its brightness.
  void add(FaceHandle fh, double shade) {
    std::vector<int> points;
    std::vector<std::size_t> vertices;
    for (const HalfedgeHandle heh : mesh_.fh_range(fh)) {
      points.push_back(corner(heh));
      vertices.push_back(index(mesh_.to_vertex_handle(heh)));
    }
    if (paint_.is_of_vertices) {
      add_sectors(points, vertices, shade);
    } else {
      add_triangles(fh, points, shade);
    }
  }

  /// Add the edges of the faces that were added.
  void add_edges() {
    const std::vector<char> is_contour = contour_edges(mesh_);
    for (const EdgeHandle eh : mesh_.edges()) {
      const HalfedgeHandle one = mesh_.halfedge_handle(eh, 0), other = mesh_.halfedge_handle(eh, 1);
      const bool has_one = is_drawn(one), has_other = is_drawn(other),
                 has_both = has_one && has_other;
      const bool is_same = has_both && start(one) == corner(other) && corner(one) == start(other);
      const bool is_line = is_contour[index(eh)] != 0 || !is_same;
      const float room = std::max(has_one ? room_of(one) : 0, has_other ? room_of(other) : 0);
      if (has_one) add_edge(one, is_line, room);
      if (has_other && !is_same) add_edge(other, is_line, room);
    }
  }

 private:
  bool is_drawn(HalfedgeHandle heh) const {
    return !mesh_.is_boundary(heh) && corner_[index(heh)] >= 0;
  }

  int start(HalfedgeHandle heh) { return corner(mesh_.prev_halfedge_handle(heh)); }

  const ScenePoint& point(int i) const { return scene_.points[static_cast<std::size_t>(i)]; }

  void add_edge(HalfedgeHandle heh, bool is_contour, float room) {
    scene_.edges.push_back({start(heh), corner(heh), is_contour, room});
  }

  /// Least height of the face at a halfedge over its longest side: for a polygon, its area through
  /// half of its longest side.
  float room_of(HalfedgeHandle heh) {
    double area = 0, longest = 0;
    const ScenePoint& first = point(start(heh));
    int count = 0;
    for (HalfedgeHandle at = heh; at != heh || count == 0; at = mesh_.next_halfedge_handle(at)) {
      const ScenePoint &a = point(start(at)), &b = point(corner(at));
      area += cross(first, a, b);
      longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
      ++count;
    }
    const double sides = count == 3 ? 1 : 2;  // a square is as high as wide
    return longest > 0 ? static_cast<float>(std::abs(area) / (sides * longest)) : 0;
  }

  void add_triangle(int a, int b, int c, PackedRgb colour) {
    scene_.triangles.push_back({{a, b, c}, colour});
  }

  PackedRgb colour(std::size_t i, double shade) const {
    const Rgb& base = paint_.colours[i];
    return packed({shade * base.red, shade * base.green, shade * base.blue});
  }

  void add_triangles(FaceHandle fh, const std::vector<int>& points, double shade) {
    const PackedRgb packed_colour = colour(index(fh), shade);
    if (points.size() == 3) return add_triangle(points[0], points[1], points[2], packed_colour);
    std::vector<Vec3> corners;
    for (const VertexHandle vh : mesh_.fv_range(fh)) corners.push_back(to_eigen(mesh_.point(vh)));
    for (const auto& [a, b, c] : triangulate_polygon(corners)) {
      const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
      add_triangle(at(a), at(b), at(c), packed_colour);
    }
  }

  int add_point(const ScenePoint& point) {
    scene_.points.push_back(point);
    return static_cast<int>(scene_.points.size()) - 1;
  }

  /// Divide a face by lines from its centre to the middles of its sides.
  void add_sectors(const std::vector<int>& points, const std::vector<std::size_t>& vertices,
                   double shade) {
    const std::size_t n = points.size();
    ScenePoint centre;
    std::vector<int> middles;  // behind each corner
    for (std::size_t i = 0; i < n; ++i) {
      const ScenePoint a = point(points[i]), b = point(points[(i + 1) % n]);
      middles.push_back(
          add_point({0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.depth + b.depth)}));
      const double share = 1 / static_cast<double>(n);
      centre = {centre.x + share * a.x, centre.y + share * a.y, centre.depth + share * a.depth};
    }
    const int middle = add_point(centre);
    for (std::size_t i = 0; i < n; ++i) {
      const int before = middles[(i + n - 1) % n], after = middles[i];
      const PackedRgb packed_colour = colour(vertices[i], shade);
      add_triangle(before, points[i], after, packed_colour);
      add_triangle(before, after, middle, packed_colour);
    }
  }

  const PolyMesh& mesh_;
  Scene& scene_;
  const MeshPaint& paint_;
  std::vector<int> corner_;
};

/// The normal of a face, which need not be flat; zero where it has no area. Its corners are scaled
/// first, so that no product overflows.
Vec3 normal_of(const PolyMesh& mesh, FaceHandle fh, double scale) {
  const HalfedgeHandle first = mesh.halfedge_handle(fh);
  const Vec3 origin = to_eigen(mesh.point(mesh.to_vertex_handle(first)));
  const auto step = [&](HalfedgeHandle heh) -> Vec3 {
    return scale * (to_eigen(mesh.point(mesh.to_vertex_handle(heh))) - origin);
  };
  Vec3 sum = Vec3::Zero();
  HalfedgeHandle heh = mesh.next_halfedge_handle(first);
  for (HalfedgeHandle next = mesh.next_halfedge_handle(heh); next != first;
       next = mesh.next_halfedge_handle(heh)) {
    sum += step(heh).cross(step(next));
    heh = next;
  }
  return sum.stableNormalized();
}

Eigen::AlignedBox3d box_of(const PolyMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const VertexHandle vh : mesh.vertices()) box.extend(to_eigen(mesh.point(vh)));
  return box;
}

/// Maps points of space into the picture.
class Projection {
 public:
  Projection(const PolyMesh& mesh, const SpaceView& view, const PictureFrame& frame)
      : axes_(view.camera), lens_(view.camera.lens) {
    const Eigen::AlignedBox3d box = box_of(mesh);
    if (!box.isEmpty()) {
      // Not sizes(), nor the sum of both ends, which may overflow.
      centre_ = 0.5 * box.min() + 0.5 * box.max();
      const double radius = (0.5 * box.max() - 0.5 * box.min()).stableNorm();
      if (radius > 0) unit_ = radius;
    }
    fit(seen_box(mesh, view), view, frame);
  }

  /// Units of space in the ball around the mesh have this scale.
  double scale() const { return 1 / unit_; }
  const CameraAxes& axes() const { return axes_; }

  ScenePoint operator()(const Vec3& point) const {
    const Vec3 p = seen(point);
    return {middle_.x + pixels_ * (p.x() - look_at_.x()),
            middle_.y - pixels_ * (p.y() - look_at_.y()), pixels_ * p.z()};
  }

  /// The direction to the eye from a point.
  Vec3 towards_eye(const Vec3& point) const {
    if (lens_ == Lens::Parallel) return axes_.towards;
    return kEyeDistance * axes_.towards - local(point);
  }

 private:
  Vec3 local(const Vec3& point) const { return (point - centre_) / unit_; }

  /// To the right, upwards and towards the eye. In perspective the third is such that planes stay
  /// planes.
  Vec3 seen(const Vec3& point) const {
    const Vec3 p = local(point);
    const Vec3 q(p.dot(axes_.right), p.dot(axes_.up), p.dot(axes_.towards));
    if (lens_ == Lens::Parallel) return q;
    return kEyeDistance / (kEyeDistance - q.z()) * q;
  }

  Eigen::AlignedBox2d seen_box(const PolyMesh& mesh, const SpaceView& view) const {
    Eigen::AlignedBox2d box;
    for (const FaceHandle fh : mesh.faces()) {
      if (!fills_frame(mesh, fh, view)) continue;
      for (const VertexHandle vh : mesh.fv_range(fh)) {
        box.extend(Eigen::Vector2d(seen(to_eigen(mesh.point(vh))).head<2>()));
      }
    }
    return box;
  }

  static bool fills_frame(const PolyMesh& mesh, FaceHandle fh, const SpaceView& view) {
    if (!view.shown.empty()) return view.shown[index(fh)] != 0;
    if (view.part.isEmpty()) return true;
    const auto corners = mesh.fv_range(fh);
    return std::all_of(corners.begin(), corners.end(), [&](VertexHandle vh) {
      return view.part.contains(to_eigen(mesh.point(vh)));
    });
  }

  void fit(const Eigen::AlignedBox2d& box, const SpaceView& view, const PictureFrame& frame) {
    middle_ = {frame.corner.x + 0.5 * frame.width, frame.corner.y + 0.5 * frame.height};
    if (box.isEmpty()) return;
    pixels_ = view.zoom * PlaneView(box, frame).scale();
    look_at_ = view.look_at.allFinite() ? seen_by_eye(view.look_at) : Eigen::Vector2d(box.center());
  }

  /// Throws   InvalidOption for a point that is beside the eye or behind it
  Eigen::Vector2d seen_by_eye(const Vec3& point) const {
    const bool is_in_front =
        lens_ == Lens::Parallel || local(point).dot(axes_.towards) < kNearestShare * kEyeDistance;
    if (is_in_front) return seen(point).head<2>();
    const Vec3 eye = centre_ + kEyeDistance * unit_ * axes_.towards;
    throw Error(ErrorCode::InvalidOption,
                fmt::format("the point to look at ({:.4g}, {:.4g}, {:.4g}) is not in front of the "
                            "eye, which in perspective is at ({:.4g}, {:.4g}, {:.4g})",
                            point.x(), point.y(), point.z(), eye.x(), eye.y(), eye.z()));
  }

  CameraAxes axes_;
  Lens lens_;
  Vec3 centre_ = Vec3::Zero();
  double unit_ = 1;
  Eigen::Vector2d look_at_ = Eigen::Vector2d::Zero();
  PicturePoint middle_;
  double pixels_ = 1;
};

/// How bright a face is: soft, as by a large lamp to the upper left of the eye.
double shade(const Vec3& normal, const Vec3& towards_eye, const Vec3& light) {
  const double turned = normal.dot(towards_eye) < 0 ? -1 : 1;
  const double share = 0.5 + 0.5 * turned * normal.dot(light);
  const double step = std::round(kShades * share * share) / kShades;
  return kDarkest + (kBrightest - kDarkest) * step;
}

/// The parameters of the plane in the picture.
std::function<PicturePoint(Uv)> place_in(const Eigen::AlignedBox2d& box,
                                         const PictureFrame& frame) {
  Eigen::Vector2d sizes = box.sizes();
  for (int i : {0, 1}) {
    if (!(sizes[i] > 0)) sizes[i] = sizes[1 - i] > 0 ? sizes[1 - i] : 1;
  }
  Eigen::Vector2d scale(frame.width / sizes.x(), frame.height / sizes.y());
  if (sizes.maxCoeff() <= kGreatestSlimness * sizes.minCoeff()) {
    scale.setConstant(scale.minCoeff());
  }
  const Eigen::Vector2d centre = 0.5 * box.min() + 0.5 * box.max();
  const PicturePoint middle{frame.corner.x + 0.5 * frame.width,
                            frame.corner.y + 0.5 * frame.height};
  return [=](Uv uv) -> PicturePoint {
    return {middle.x + scale.x() * (uv.u - centre.x()), middle.y - scale.y() * (uv.v - centre.y())};
  };
}

/// The points of corners in a patch: one for all that have the same vertex and parameters.
class CornerPoints {
 public:
  explicit CornerPoints(const PolyMesh& mesh) : points_(mesh.n_vertices()) {}

  template <class Add>
  int find_or_add(VertexHandle vh, Uv uv, Add add) {
    auto& known = points_[index(vh)];
    for (const auto& [other, point] : known) {
      if (other == uv) return point;
    }
    known.emplace_back(uv, add());
    return known.back().second;
  }

 private:
  std::vector<std::vector<std::pair<Uv, int>>> points_;
};

}  // namespace

PackedRgb packed(const Rgb& colour) {
  const auto byte = [](double part) {
    return static_cast<PackedRgb>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
  };
  return byte(colour.red) << 16U | byte(colour.green) << 8U | byte(colour.blue);
}

Rgb unpacked(PackedRgb colour) {
  const auto part = [&](unsigned shift) { return (colour >> shift & 255U) / 255.0; };
  return {part(16), part(8), part(0)};
}

std::vector<char> contour_edges(const PolyMesh& mesh) {
  const auto contour_of = find(mesh, keys::edge_contour);
  const auto patch_of = find(mesh, keys::face_patch);
  const double least_cosine = std::cos(kSharpDegrees * std::numbers::pi / 180);
  const Eigen::AlignedBox3d box = box_of(mesh);
  const double radius = box.isEmpty() ? 0 : (0.5 * box.max() - 0.5 * box.min()).stableNorm();
  const double scale = radius > 0 ? 1 / radius : 1;
  std::vector<char> is_contour(mesh.n_edges(), 0);
  for (const EdgeHandle eh : mesh.edges()) {
    char& answer = is_contour[index(eh)];
    if (mesh.is_boundary(eh)) {
      answer = 1;
      continue;
    }
    const FaceHandle a = mesh.face_handle(mesh.halfedge_handle(eh, 0)),
                     b = mesh.face_handle(mesh.halfedge_handle(eh, 1));
    if (contour_of.is_valid()) {
      answer = mesh.property(contour_of, eh) >= 0;
    } else if (patch_of.is_valid()) {
      answer = mesh.property(patch_of, a) != mesh.property(patch_of, b);
    } else {
      answer = normal_of(mesh, a, scale).dot(normal_of(mesh, b, scale)) < least_cosine;
    }
  }
  return is_contour;
}

Scene scene_in_space(const PolyMesh& mesh, const MeshPaint& paint, const SpaceView& view,
                     const PictureFrame& frame) {
  const Projection projection(mesh, view, frame);
  const CameraAxes& axes = projection.axes();
  const Vec3 light = (axes.towards + 0.9 * axes.up - 0.75 * axes.right).normalized();
  Scene scene;
  scene.points.reserve(mesh.n_vertices());
  for (const VertexHandle vh : mesh.vertices()) {
    scene.points.push_back(projection(to_eigen(mesh.point(vh))));
  }
  scene.triangles.reserve(mesh.n_faces());
  scene.edges.reserve(mesh.n_edges());
  SceneFaces faces(mesh, scene, paint);
  for (const FaceHandle fh : mesh.faces()) {
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      faces.corner(heh) = mesh.to_vertex_handle(heh).idx();
    }
    const Vec3 corner = to_eigen(mesh.point(mesh.to_vertex_handle(mesh.halfedge_handle(fh))));
    faces.add(
        fh, shade(normal_of(mesh, fh, projection.scale()), projection.towards_eye(corner), light));
  }
  faces.add_edges();
  return scene;
}

PlaneScene scene_in_plane(const PolyMesh& mesh, int patch, const MeshPaint& paint,
                          const PictureFrame& frame) {
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto patch_of = find(mesh, keys::face_patch);
  const auto is_meant = [&](FaceHandle fh) {
    return !patch_of.is_valid() || mesh.property(patch_of, fh) == patch;
  };
  PlaneScene result;
  for (const FaceHandle fh : mesh.faces()) {
    if (!is_meant(fh)) continue;
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      const Uv uv = mesh.property(uv_of, heh);
      result.box.extend(Eigen::Vector2d(uv.u, uv.v));
    }
  }
  if (result.box.isEmpty()) {
    throw Error(ErrorCode::InvalidInput, fmt::format("no face lies on the patch {}", patch));
  }
  result.place = place_in(result.box, frame);
  CornerPoints points(mesh);
  SceneFaces faces(mesh, result.scene, paint);
  for (const FaceHandle fh : mesh.faces()) {
    if (!is_meant(fh)) continue;
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      const Uv uv = mesh.property(uv_of, heh);
      faces.corner(heh) = points.find_or_add(mesh.to_vertex_handle(heh), uv, [&] {
        const PicturePoint at = result.place(uv);
        result.scene.points.push_back({at.x, at.y, 0});
        return static_cast<int>(result.scene.points.size()) - 1;
      });
    }
    faces.add(fh, 1);
  }
  faces.add_edges();
  return result;
}

}  // namespace surfmesh
