// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/mesh_picture.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "pictures/depth_buffer.hh"
#include "pictures/image.hh"
#include "pictures/metric_ellipses.hh"
#include "pictures/paint_order.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

constexpr Rgb kPlainInSpace = {0.70, 0.78, 0.89}, kPlainInPlane = {0.95, 0.96, 0.98};

/// Height of text and the margin around the picture, by the lesser side.
constexpr double kTextShare = 0.024, kLeastText = 9, kMarginShare = 0.02;

/// Least sides of the frame that the plane of a patch is drawn in, pixels.
constexpr double kLeastPlaneSide = 16;

/// Height of text in a picture.
double text_height_of(std::size_t width, std::size_t height) {
  return std::max(kLeastText, kTextShare * static_cast<double>(std::min(width, height)));
}

double margin_of(std::size_t width, std::size_t height) {
  return kMarginShare * static_cast<double>(std::min(width, height));
}

/// What is left of the width beside a key. It takes no more than half of the picture, however small
/// that is.
std::size_t width_beside(double key, std::size_t width) {
  return width -
         static_cast<std::size_t>(std::min(std::ceil(key), 0.5 * static_cast<double>(width)));
}

/// Where the plane of a patch is drawn: to the left of the key, beside and above the numbers.
PictureFrame plane_frame(const PictureKey& key, std::size_t width, std::size_t height) {
  const double text = text_height_of(width, height), margin = margin_of(width, height);
  const double left = 3 * text, below = 1.8 * text;
  const auto beside = static_cast<double>(width_beside(key_width(key, text), width));
  return {{margin + left, margin},
          beside - left - 2 * margin,
          static_cast<double>(height) - below - 2 * margin};
}

/// Throws   InvalidOption where the plane would have no room, with a size that is enough
void check_plane_room(const PictureKey& key, std::size_t width, std::size_t height) {
  std::size_t wide = width, high = height;
  for (bool has_room = false; !has_room;) {
    const PictureFrame frame = plane_frame(key, wide, high);
    if (frame.width < kLeastPlaneSide) ++wide;
    if (frame.height < kLeastPlaneSide) ++high;
    has_room = frame.width >= kLeastPlaneSide && frame.height >= kLeastPlaneSide;
  }
  if (wide == width && high == height) return;
  throw Error(ErrorCode::InvalidOption,
              fmt::format("a picture of {}x{} pixels has no room for the plane of a patch beside "
                          "the numbers and the key: it takes at least {}x{}",
                          width, height, wide, high));
}

/// Samples along each side of a pixel: four, or fewer on large pictures, for the memory.
int samples_for(std::size_t width, std::size_t height) {
  constexpr std::size_t kOfFour = 2'000'000, kOfThree = 8'000'000;
  const std::size_t area = width * height;
  return area <= kOfFour ? 4 : area <= kOfThree ? 3 : 2;
}

void check(const PictureOptions& options) {
  const auto [least, greatest] = std::minmax(options.width, options.height);
  if (least >= kLeastPictureSide && greatest <= kGreatestPictureSide &&
      options.width * options.height <= kGreatestPictureArea) {
    return;
  }
  throw Error(ErrorCode::InvalidOption,
              fmt::format("a picture of {}x{} pixels: sides are from {} to {}, and it has at most "
                          "{} million pixels",
                          options.width, options.height, kLeastPictureSide, kGreatestPictureSide,
                          kGreatestPictureArea / 1'000'000));
}

/// The scene with a mean of its samples in each pixel.
void fill(Image& image, const Scene& scene, const DepthBuffer& buffer) {
  const auto samples = static_cast<std::size_t>(buffer.samples());
  const float share = 1 / (255.0F * static_cast<float>(samples * samples));
  share_indices(buffer.rows() / samples, [&](std::size_t row) {
    for (std::size_t column = 0; column < buffer.columns() / samples; ++column) {
      std::array<unsigned, 4> sums = {};
      for (std::size_t i = 0; i < samples * samples; ++i) {
        const int t = buffer.front(column * samples + i % samples, row * samples + i / samples);
        if (t < 0) continue;
        const PackedRgb colour = scene.triangles[static_cast<std::size_t>(t)].colour;
        sums[0] += colour >> 16U & 255U;
        sums[1] += colour >> 8U & 255U;
        sums[2] += colour & 255U;
        sums[3] += 255U;
      }
      for (std::size_t i = 0; i < 4; ++i) {
        image.at(column, row)[i] = share * static_cast<float>(sums[i]);
      }
    }
  });
}

void add_faces(Svg& svg, const Scene& scene, const DepthBuffer& buffer) {
  svg.begin_faces();
  for (const std::vector<PaintPiece>& layer : paint_order(scene, buffer)) {
    std::vector<PicturePoints> polygons;
    for (std::size_t i = 0; i < layer.size(); ++i) {
      PicturePoints& polygon = polygons.emplace_back();
      for (const ScenePoint& corner : layer[i].corners) polygon.push_back({corner.x, corner.y});
      if (i + 1 < layer.size() && layer[i + 1].colour == layer[i].colour) continue;
      svg.add_faces(polygons, hex(unpacked(layer[i].colour)));
      polygons.clear();
    }
  }
  svg.end_faces();
}

void add_lines(Canvas& canvas, const std::vector<StyledLines>& all) {
  for (const auto& [style, lines] : all) canvas.add_lines(lines, style);
}

/// Draws one picture.
class Drawing {
 public:
  Drawing(const PolyMesh& mesh, const MeshNames& names, const PictureOptions& options)
      : mesh_(mesh), options_(options) {
    text_height_ = text_height_of(options.width, options.height);
    margin_ = margin_of(options.width, options.height);
    painted_ = paint_mesh(mesh, names, options.colour, shown_faces(),
                          options.plane ? kPlainInPlane : kPlainInSpace);
    if (!options.has_key) painted_.key = {};
    if (options.plane) check_plane_room(painted_.key, options.width, options.height);
    scene_width_ = width_beside(key_width(painted_.key, text_height_), options.width);
    make_scene();
    buffer_ = std::make_unique<DepthBuffer>(scene_, scene_width_, options.height,
                                            samples_for(options.width, options.height));
  }

  std::string svg() const {
    Svg svg(double(options_.width), double(options_.height),
            options_.is_transparent ? "none" : "#ffffff");
    svg.begin_frame({{0, 0}, double(scene_width_), double(options_.height)});
    add_faces(svg, scene_, *buffer_);
    add_lines(svg, lines());
    svg.end_frame();
    add_notes(svg);
    return svg.text();
  }

  std::string png() const {
    Image image(options_.width, options_.height);
    fill(image, scene_, *buffer_);
    if (!options_.is_transparent) image.put_behind({1, 1, 1});
    add_lines(image, lines());
    add_notes(image);
    return image.png();
  }

 private:
  /// Faces that the key and its scale are of.
  std::vector<char> shown_faces() const {
    const auto patch_of = find(mesh_, keys::face_patch);
    std::vector<char> shown(mesh_.n_faces(), 1);
    if (!options_.plane || !patch_of.is_valid()) return shown;
    for (const FaceHandle fh : mesh_.faces()) {
      shown[index(fh)] = mesh_.property(patch_of, fh) == *options_.plane ? 1 : 0;
    }
    return shown;
  }

  void make_scene() {
    if (!options_.plane) {
      scene_ = scene_in_space(mesh_, painted_.paint, options_.view,
                              {{margin_, margin_},
                               double(scene_width_) - 2 * margin_,
                               double(options_.height) - 2 * margin_});
      return;
    }
    PlaneScene plane = scene_in_plane(mesh_, *options_.plane, painted_.paint,
                                      plane_frame(painted_.key, options_.width, options_.height));
    scene_ = std::move(plane.scene);
    plane_box_ = plane.box;
    place_ = std::move(plane.place);
  }

  std::vector<StyledLines> lines() const { return visible_lines(scene_, *buffer_, options_.lines); }

  void add_notes(Canvas& canvas) const {
    if (place_) add_axes(canvas);
    if (place_ && options_.has_ellipses) add_ellipses(canvas);
    draw_key(canvas, painted_.key,
             {{double(scene_width_) + 0.4 * text_height_, margin_},
              double(options_.width - scene_width_),
              double(options_.height) - 2 * margin_},
             text_height_);
  }

  void add_ellipses(Canvas& canvas) const {
    const PicturePoint a = place_({plane_box_.min().x(), plane_box_.max().y()}),
                       b = place_({plane_box_.max().x(), plane_box_.min().y()});
    const PictureFrame plane{a, b.x - a.x, b.y - a.y};
    const MetricEllipses ellipses = metric_ellipses(mesh_, *options_.plane, place_, plane);
    canvas.add_polygons(ellipses.outlines, {"none", "#b2182b", 2 * options_.lines.edge_width});
    if (!(ellipses.factor > 1)) return;
    canvas.add_text({a.x + 0.75 * plane.width, b.y + 1.4 * text_height_},
                    fmt::format("ellipses {:.2g} times as wide", ellipses.factor), text_height_,
                    TextAnchor::Middle);
  }

  /// The names of the parameters and their range.
  void add_axes(Canvas& canvas) const {
    const auto number = [](double value) { return fmt::format("{:.4g}", value); };
    const auto [low, high] = std::pair(plane_box_.min(), plane_box_.max());
    const PicturePoint a = place_({low.x(), low.y()}), b = place_({high.x(), high.y()});
    const double h = text_height_, y = a.y + 1.4 * h, x = a.x - 0.6 * h;
    canvas.add_text({a.x, y}, number(low.x()), h, TextAnchor::Start);
    canvas.add_text({0.5 * (a.x + b.x), y}, "u", h, TextAnchor::Middle);
    canvas.add_text({b.x, y}, number(high.x()), h, TextAnchor::End);
    canvas.add_text({x, a.y}, number(low.y()), h, TextAnchor::End);
    canvas.add_text({x, 0.5 * (a.y + b.y) + 0.35 * h}, "v", h, TextAnchor::End);
    canvas.add_text({x, b.y + 0.72 * h}, number(high.y()), h, TextAnchor::End);
  }

  const PolyMesh& mesh_;
  const PictureOptions& options_;
  double text_height_ = 0;
  double margin_ = 0;
  std::size_t scene_width_ = 0;  ///< left of the key
  PaintedMesh painted_;
  Scene scene_;
  Eigen::AlignedBox2d plane_box_;
  std::function<PicturePoint(Uv)> place_;  ///< in the plane of a patch
  std::unique_ptr<DepthBuffer> buffer_;
};

}  // namespace

std::string draw_mesh(const PolyMesh& mesh, const MeshNames& names, const PictureOptions& options,
                      PictureFormat format) {
  check(options);
  const Drawing drawing(mesh, names, options);
  return format == PictureFormat::Svg ? drawing.svg() : drawing.png();
}

void draw_scene(Svg& svg, const Scene& scene, const PictureFrame& frame, const LineOptions& lines) {
  const auto width = static_cast<std::size_t>(frame.corner.x + frame.width),
             height = static_cast<std::size_t>(frame.corner.y + frame.height);
  const DepthBuffer buffer(scene, width, height, samples_for(width, height));
  svg.begin_frame(frame);
  add_faces(svg, scene, buffer);
  add_lines(svg, visible_lines(scene, buffer, lines));
  svg.end_frame();
}

}  // namespace surfmesh
