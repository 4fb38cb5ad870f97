// SPDX-License-Identifier: BSD-3-Clause
#include "paper/figures.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "pictures/long_lines.hh"
#include "pictures/mesh_picture.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh::paper {
namespace {

constexpr double kMargin = 12, kCaption = 22, kTextHeight = 14;

/// A picture of panels side by side, each with a caption below.
class Panels {
 public:
  Panels(int count, double width, double height)
      : width_(width),
        height_(height),
        svg_(count * (width + kMargin) + kMargin, height + kCaption + 2 * kMargin) {}

  Svg& svg() { return svg_; }

  /// The frame of the next panel.
  PictureFrame next(const std::string& caption) {
    const double left = kMargin + count_++ * (width_ + kMargin);
    svg_.add_text({left + 0.5 * width_, height_ + kMargin + kCaption}, caption, kTextHeight,
                  TextAnchor::Middle);
    return {{left, kMargin}, width_, height_};
  }

 private:
  double width_, height_;
  Svg svg_;
  int count_ = 0;
};

Eigen::AlignedBox2d box_of(const PolyMesh& mesh) {
  Eigen::AlignedBox2d box;
  for (const VertexHandle vh : mesh.vertices()) {
    box.extend(Eigen::Vector2d(mesh.point(vh)[0], mesh.point(vh)[1]));
  }
  return box;
}

/// Maps vertices of a mesh in the plane.
std::function<PicturePoint(VertexHandle)> in_plane(const PolyMesh& mesh, const PlaneView& view) {
  return [&mesh, &view](VertexHandle vh) { return view(mesh.point(vh)[0], mesh.point(vh)[1]); };
}

void draw_plane(Svg& svg, const PolyMesh& mesh, const PictureFrame& frame, double line_width) {
  const PlaneView view(box_of(mesh), frame);
  svg.add_lines(edge_lines(mesh, in_plane(mesh, view)), {"none", "#000000", line_width});
}

/// Fill colours of the classes V_s, V_t, V_o.
constexpr std::array<const char*, 3> kClassColours = {"#ffffff", "#cfd8e6", "#7f97bd"};

std::size_t class_index(int face_class) {
  switch (static_cast<Interpolation>(face_class)) {
    case Interpolation::Single:
      return 0;
    case Interpolation::Triangle:
      return 1;
    default:
      return 2;
  }
}

/// The triangles of a control mesh, coloured by class.
void draw_control(Svg& svg, const PolyMesh& mesh, const PictureFrame& frame) {
  const PlaneView view(box_of(mesh), frame);
  const auto at = in_plane(mesh, view);
  const auto class_of = require(mesh, keys::face_class);
  std::array<std::vector<std::vector<PicturePoint>>, 3> polygons;
  for (const FaceHandle fh : mesh.faces()) {
    auto& polygon = polygons[class_index(mesh.property(class_of, fh))].emplace_back();
    for (const VertexHandle vh : mesh.fv_range(fh)) polygon.push_back(at(vh));
  }
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (polygons[i].empty()) continue;
    svg.add_polygons(polygons[i], {kClassColours[i], "#000000", 0.4});
  }
}

/// The legend of draw_control, below the left of the frame.
void draw_class_legend(Svg& svg, const PictureFrame& frame) {
  constexpr std::array names = {"V_s", "V_t", "V_o"};
  constexpr double side = 12, width = 46, gap = 8;
  const double y = frame.corner.y + frame.height + gap;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double x = frame.corner.x + width * static_cast<double>(i);
    svg.add_rectangle({x, y}, side, side, {kClassColours[i], "#000000", 0.4});
    svg.add_text({x + side + 3, y + side - 1}, names[i], 11);
  }
}

// --- the figures ---

Figure bars_of_questions(Laboratory& laboratory) {
  const Outcome outcome = laboratory.third().run({kX, true, true, 40'000}, Way::Paper, true);
  constexpr double width = 620, left = 240, bar = 22, step = 34;
  const std::vector<StageShare> stages = shares_by_stage(outcome);
  Svg svg(width, kMargin + step * static_cast<double>(stages.size()) + kMargin);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const double y = kMargin + step * static_cast<double>(i);
    const double length = (width - left - 70) * stages[i].share / 100;
    svg.add_text({left - 8, y + 16}, stages[i].name, kTextHeight, TextAnchor::End);
    svg.add_rectangle({left, y}, std::max(length, 1.0), bar, {"#7f97bd", "#000000", 0.5});
    svg.add_text({left + length + 6, y + 16}, fmt::format("{:.1f} %", stages[i].share),
                 kTextHeight);
  }
  return {"figure1.svg", svg.text()};
}

Figure meshes_of_first(Laboratory& laboratory, bool has_quads) {
  Panels panels(2, 460, 460);
  for (const Interpolation interpolation : {kT, kO}) {
    const Outcome outcome = laboratory.first().run({interpolation}, Way::Paper, has_quads);
    const std::string caption =
        fmt::format("{}) {}, {} {}", interpolation == kT ? "a" : "b", label({interpolation}),
                    outcome.elements(), has_quads ? "quadrilaterals" : "triangles");
    draw_plane(panels.svg(), outcome.result->mesh, panels.next(caption), 0.35);
  }
  return {has_quads ? "figure5.svg" : "figure4.svg", panels.svg().text()};
}

/// The given nodes: larger dots for larger sizes.
Figure control_of_first(Laboratory& laboratory) {
  Panels panels(2, 340, 340);
  const PolyMesh& mesh = laboratory.first().control({kX}).mesh();
  const auto size_of = require(mesh, keys::vertex_size);
  const PictureFrame nodes = panels.next("a) control nodes; M1 filled, M2 open");
  const PlaneView view(box_of(mesh), nodes);
  const Eigen::AlignedBox2d box = box_of(mesh);
  panels.svg().add_rectangle(view(box.min().x(), box.max().y()), view.scale() * box.sizes().x(),
                             view.scale() * box.sizes().y(), {"none", "#000000", 0.8});
  for (const VertexHandle vh : mesh.vertices()) {
    const Eigen::Vector2d at(mesh.point(vh)[0], mesh.point(vh)[1]);
    const bool is_corner = at.x() == box.min().x() || at.x() == box.max().x();
    if (is_corner) continue;          // it has the size of the node nearest to it
    constexpr double between = 0.03;  // of the small and the large sizes
    const bool is_small = mesh.property(size_of, vh).h11 < between;
    panels.svg().add_circle(view(at.x(), at.y()), 5,
                            {is_small ? "#000000" : "#ffffff", "#000000", 1.2});
  }
  draw_plane(panels.svg(), mesh, panels.next("b) their triangulation"), 0.6);
  return {"figure6.svg", panels.svg().text()};
}

/// Mesh and control mesh of example 2, without or with inner nodes.
Figure meshes_of_second(Laboratory& laboratory, bool has_inner_nodes) {
  const Variant variant{kX, has_inner_nodes};
  Panels panels(2, 660, 396);
  const Outcome outcome = laboratory.second().run(variant, Way::Paper);
  draw_plane(panels.svg(), outcome.result->mesh,
             panels.next(fmt::format("a) {}, {} triangles", label(variant), outcome.elements())),
             0.25);
  const PictureFrame frame =
      panels.next(fmt::format("b) control mesh, {} triangles", outcome.report.control.faces));
  draw_control(panels.svg(), laboratory.second().control(variant).mesh(), frame);
  draw_class_legend(panels.svg(), frame);
  return {has_inner_nodes ? "figure8.svg" : "figure7.svg", panels.svg().text()};
}

/// The mesh of example 3, and a part of it.
std::vector<Figure> surface_of_third(Laboratory& laboratory) {
  const Outcome outcome = laboratory.third().run({kX, true, true, 40'000}, Way::Paper);
  constexpr double width = 900, height = 580;
  const auto draw = [&outcome](double half_side, double line_width) {
    const Vec3 corner(half_side, half_side, 3);  // the surface is 1.5 high
    const PolyMesh& mesh = outcome.result->mesh;
    const MeshPaint paint{std::vector<Rgb>(mesh.n_faces(), {0.94, 0.94, 0.94})};
    const PictureFrame frame{{0, 0}, width, height};
    SpaceView view;
    view.part = {-corner, corner};
    Svg svg(width, height);
    draw_scene(svg, scene_in_space(mesh, paint, view, frame), frame,
               {.contours = false, .edge_width = line_width});
    return svg.text();
  };
  return {{"figure9.svg", draw(6, 0.1)}, {"figure10.svg", draw(1.5, 0.4)}};
}

}  // namespace

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const int number : {1, 4, 5, 6, 7, 8, 9, 10}) {
    names.push_back(fmt::format("figure{}.svg", number));
  }
  return names;
}

std::vector<Figure> draw_figures(Laboratory& laboratory) {
  std::vector<Figure> figures = {
      bars_of_questions(laboratory),       meshes_of_first(laboratory, false),
      meshes_of_first(laboratory, true),   control_of_first(laboratory),
      meshes_of_second(laboratory, false), meshes_of_second(laboratory, true)};
  for (Figure& figure : surface_of_third(laboratory)) figures.push_back(std::move(figure));
  return figures;
}

}  // namespace surfmesh::paper
