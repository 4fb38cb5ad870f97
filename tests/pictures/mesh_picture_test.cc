// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/mesh_picture.hh"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>
#include <string_view>
#include <tuple>
#include <utility>

#include "pictures/scenes.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/png_pixels.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

using testing::cube;
using testing::PngPixel;
using testing::PngPixels;

/// A picture of 120 pixels each way, without lines or key.
PictureOptions plain_options(double azimuth, double elevation) {
  PictureOptions options;
  options.width = options.height = 120;
  options.lines = {.edges = false, .contours = false};
  options.view = testing::seen_from(azimuth, elevation);
  options.has_key = false;
  return options;
}

std::string png(const PolyMesh& mesh, const PictureOptions& options) {
  return draw_mesh(mesh, {}, options, PictureFormat::Png);
}

void add_patches(PolyMesh& mesh, const std::vector<int>& patches) {
  const auto patch_of = attach(mesh, keys::face_patch);
  mesh.property(patch_of).data_vector() = patches;
}

TEST(DrawMesh, HasExactColours) {
  // A face towards the camera: the light comes from (-0.75, 0.9, 1), so that its cosine is 0.6491.
  // (½ + ½ 0.6491)² is 44 of 64 steps, and 0.62 + 0.44 · 44/64 = 0.9225 of (0.7, 0.78, 0.89).
  const PngPixels pixels(png(cube(), plain_options(0, 0)));
  EXPECT_EQ(pixels.at(60, 60), (PngPixel{165, 183, 209, 255}));
  EXPECT_EQ(pixels.at(1, 60), (PngPixel{255, 255, 255, 255}));
  EXPECT_EQ(pixels.at(5, 5), (PngPixel{165, 183, 209, 255}));
}

TEST(DrawMesh, ShowsThreeSidesOfACube) {
  PolyMesh mesh = cube();
  add_patches(mesh, {0, 1, 2, 3, 4, 5});
  PictureOptions options = plain_options(-45, 30);
  options.colour = MeshField::Patch;
  const PngPixels pixels(png(mesh, options));
  const auto hue_is = [&](std::size_t x, std::size_t y, std::size_t patch) {
    // There is white in it; brightness scales all parts alike.
    const Rgb colour = category_colour(patch);
    const auto part = [](double value) { return 0.58 * value + 0.42; };
    const PngPixel pixel = pixels.at(x, y);
    return std::abs(pixel[0] / part(colour.red) - pixel[1] / part(colour.green)) < 6 &&
           std::abs(pixel[1] / part(colour.green) - pixel[2] / part(colour.blue)) < 6;
  };
  EXPECT_TRUE(hue_is(80, 75, 1)) << "x, to the right";
  EXPECT_TRUE(hue_is(40, 75, 2)) << "-y, to the left";
  EXPECT_TRUE(hue_is(60, 25, 5)) << "z, above";
}

TEST(DrawMesh, HidesWhatIsInside) {
  PolyMesh box = cube(2), both = cube(2);
  const PolyMesh ball = testing::octahedron();
  std::vector<VertexHandle> vertices;
  for (const VertexHandle vh : ball.vertices()) vertices.push_back(both.add_vertex(ball.point(vh)));
  for (const FaceHandle fh : ball.faces()) {
    std::vector<VertexHandle> corners;
    for (const VertexHandle vh : ball.fv_range(fh)) corners.push_back(vertices[index(vh)]);
    both.add_face(corners);
  }
  PictureOptions options = plain_options(-60, 30);
  options.lines = {};
  for (const PictureFormat format : {PictureFormat::Png, PictureFormat::Svg}) {
    EXPECT_EQ(draw_mesh(box, {}, options, format), draw_mesh(both, {}, options, format));
  }
}

TEST(DrawMesh, ShowsTheNearerOfCrossingSquares) {
  PolyMesh mesh = testing::crossing_squares();
  add_patches(mesh, {0, 1});
  PictureOptions options = plain_options(-90, 0);
  options.colour = MeshField::Patch;
  const PngPixels pixels(png(mesh, options));
  const PngPixel left = pixels.at(20, 60), right = pixels.at(100, 60);
  EXPECT_NE(left, right);
  for (std::size_t y = 10; y < 110; y += 9) {
    EXPECT_EQ(pixels.at(50, y), left) << y;
    EXPECT_EQ(pixels.at(70, y), right) << y;
  }
}

TEST(DrawMesh, LetsThroughWithoutABackground) {
  PictureOptions options = plain_options(0, 0);
  options.is_transparent = true;
  const PngPixels pixels(png(cube(), options));
  EXPECT_EQ(pixels.at(0, 0), (PngPixel{0, 0, 0, 0}));
  EXPECT_EQ(pixels.at(60, 60)[3], 255);
  const std::string svg = draw_mesh(cube(), {}, options, PictureFormat::Svg);
  EXPECT_EQ(svg.find("#ffffff"), svg.npos);
}

/// A torus of n × n/2 quads, coloured by valence: every vertex counts.
PolyMesh torus(int n) {
  const int m = n / 2;
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m;
      const double r = 3 + std::cos(b);
      points.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
      const int k = (i + 1) % n, l = (j + 1) % m;
      faces.push_back({i * m + j, k * m + j, k * m + l, i * m + l});
    }
  }
  return testing::mesh_of(points, faces);
}

TEST(DrawMesh, IsTheSameOnAnyNumberOfThreads) {
  const PolyMesh mesh = torus(60);
  PictureOptions options;
  options.colour = MeshField::Shape;
  for (const PictureFormat format : {PictureFormat::Png, PictureFormat::Svg}) {
    std::vector<std::string> files;
    for (const int threads : {1, 2, 4}) {
      with_threads(threads, [&] { files.push_back(draw_mesh(mesh, {}, options, format)); });
    }
    EXPECT_EQ(files[0], files[1]);
    EXPECT_EQ(files[0], files[2]);
  }
}

bool has_rsvg() { return std::system("rsvg-convert --version >/dev/null 2>&1") == 0; }

/// The vector picture, drawn by librsvg.
PngPixels drawn_by_rsvg(const std::string& svg) {
  const TestFolder folder;
  write_text(folder / "a.svg", svg);
  const std::string path = (folder / "a").string();
  EXPECT_EQ(std::system(("rsvg-convert '" + path + ".svg' -o '" + path + ".png'").c_str()), 0);
  return PngPixels(read_text(folder / "a.png"));
}

/// Mean differences, of 255: fonts differ, lines of half a pixel too, and the rims of faces by the
/// lines around them.
void expect_alike(const PolyMesh& mesh, const PictureOptions& options, double difference) {
  if (!has_rsvg()) GTEST_SKIP() << "rsvg-convert is not installed";
  const PngPixels vector = drawn_by_rsvg(draw_mesh(mesh, {}, options, PictureFormat::Svg));
  EXPECT_LT(PngPixels(png(mesh, options)).mean_difference(vector), difference);
}

TEST(VectorPictures, LookLikePixels) {
  PictureOptions options;
  options.width = options.height = 300;
  options.has_key = false;
  expect_alike(torus(80), options, 1.5);
  options.lines = {.edges = false, .contours = false};
  expect_alike(torus(80), options, 1);
  options.view.camera.lens = Lens::Perspective;
  expect_alike(torus(40), options, 1);
}

TEST(VectorPictures, LookLikePixelsWhereSurfacesCross) {
  PolyMesh mesh = testing::crossing_squares();
  add_patches(mesh, {0, 1});
  PictureOptions options = plain_options(-75, 20);
  options.colour = MeshField::Patch;
  expect_alike(mesh, options, 0.5);
}

TEST(VectorPictures, HaveTheirKey) {
  PictureOptions options;
  options.colour = MeshField::Shape;
  const std::string svg = draw_mesh(torus(20), {}, options, PictureFormat::Svg);
  for (const char* text : {">0.2<", ">0.8<", ">quality in<", ">space, 1 is best<"}) {
    EXPECT_NE(svg.find(text), svg.npos) << text;
  }
  options.has_key = false;
  EXPECT_EQ(draw_mesh(torus(20), {}, options, PictureFormat::Svg).find("<text"), svg.npos);
}

TEST(VectorPictures, AreSmall) {
  PictureOptions options;
  options.view.camera.elevation = 80;
  const PolyMesh mesh = torus(400);  // about 80,000 triangles are seen from above
  EXPECT_LT(draw_mesh(mesh, {}, options, PictureFormat::Svg).size(), 4'000'000U);
}

TEST(DrawMesh, ShowsThePlaneOfAPatch) {
  const PolyMesh mesh = testing::plane_grid(4, 4);
  PictureOptions options;
  options.plane = 0;
  options.has_ellipses = true;
  const std::string svg = draw_mesh(mesh, {}, options, PictureFormat::Svg);
  for (const char* text : {">u<", ">v<", ">0<", ">4<", "#b2182b"}) {
    EXPECT_NE(svg.find(text), svg.npos) << text;
  }
  EXPECT_EQ(svg.find("times as wide"), svg.npos);
  EXPECT_EQ(PngPixels(png(mesh, options)).width(), 900U);
}

TEST(DrawMesh, TellsTheLeastSizeOfAPlane) {
  const PolyMesh mesh = testing::plane_grid(4, 4);
  PictureOptions options;
  options.plane = 0;
  options.has_ellipses = true;
  std::tie(options.width, options.height) = std::pair(24, 24);
  // 27 pixels at the left and 16.2 below are for numbers, and 2 % on each side is free.
  EXPECT_EQ(error_of([&] { png(mesh, options); }),
            "invalid option: a picture of 24x24 pixels has no room for the plane of a patch beside "
            "the numbers and the key: it takes at least 45x34");
  std::tie(options.width, options.height) = std::pair(45, 34);
  EXPECT_EQ(PngPixels(png(mesh, options)).width(), 45U);
  options.colour = MeshField::Shape;  // has a key
  EXPECT_TRUE(error_of([&] { png(mesh, options); }).ends_with("at least 89x34"));
  std::tie(options.width, options.height) = std::pair(89, 34);
  EXPECT_EQ(PngPixels(png(mesh, options)).width(), 89U);
  options.width = 88;
  EXPECT_TRUE(error_of([&] { png(mesh, options); }).ends_with("at least 89x34"));
}

TEST(DrawMesh, TellsThatEllipsesAreLargerThanTheMetricAsks) {
  PictureOptions options;
  options.plane = 0;
  options.has_ellipses = true;
  const PolyMesh mesh = testing::plane_grid(4, 4, {1e6, 0, 1e6});
  EXPECT_NE(draw_mesh(mesh, {}, options, PictureFormat::Svg).find("times as wide<"),
            std::string::npos);
}

TEST(DrawMesh, ColoursByValuesOfVertices) {
  PictureOptions options = plain_options(0, 90);
  options.colour = MeshField::Valence;
  // All have four edges: the middle of the scale, a grey; the light comes from the upper left.
  const PngPixel pixel = PngPixels(png(torus(200), options)).at(60, 18);
  EXPECT_NEAR(pixel[0], pixel[1], 1);
  EXPECT_NEAR(pixel[1], pixel[2], 1);
}

TEST(DrawMesh, DrawsOddMeshes) {
  const std::vector<PolyMesh> meshes = {
      PolyMesh(),
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}),
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}),
      testing::mesh_of({{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}, {{0, 1, 2}}),
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 3, 0}, {0, 1, 0}}, {{0, 1, 2, 3, 4}}),
      testing::mesh_of({{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 1e300}}, {{0, 1, 2}})};
  for (const PolyMesh& mesh : meshes) {
    for (const double elevation : {0.0, 30.0, 90.0}) {
      PictureOptions options = plain_options(0, elevation);
      options.lines = {};
      EXPECT_EQ(PngPixels(png(mesh, options)).width(), 120U);
      EXPECT_TRUE(draw_mesh(mesh, {}, options, PictureFormat::Svg).ends_with("</svg>\n"));
    }
  }
}

TEST(DrawMesh, TellsSizesThatCannotBe) {
  for (const auto& [width, height] : {std::pair(0UL, 10UL),
                                      {10UL, 600UL},
                                      {100000UL, 100000UL},
                                      {16000UL, 16000UL},
                                      {600UL, 20000UL}}) {
    PictureOptions options;
    options.width = width;
    options.height = height;
    EXPECT_THROW(png(cube(), options), Error) << width << 'x' << height;
  }
}

std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(DrawScene, DrawsWhatIsSeenInItsFrame) {
  const PolyMesh flat = testing::plane_grid(10, 10);
  const PictureFrame frame{{0, 0}, 200, 100};
  const auto faces_in = [&](const Vec3& upper) {
    SpaceView view = testing::seen_from(-90, 90);
    view.part = {-upper, upper};
    Svg svg(200, 100);
    const MeshPaint paint{std::vector<Rgb>(flat.n_faces())};
    draw_scene(svg, scene_in_space(flat, paint, view, frame), frame,
               {.edges = false, .contours = false});
    return count_of(svg.text(), "z");
  };
  EXPECT_EQ(faces_in(Vec3(10, 10, 9)), 200U);
  // The frame reaches columns to 6 and rows to 4.
  EXPECT_EQ(faces_in(Vec3(4, 4, 9)), 2U * 6 * 4);
}

}  // namespace
}  // namespace surfmesh
