// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/mesh_pieces.hh"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/analytic.hh"
#include "support/models.hh"
#include "support/thread_exchange.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/shared_vertices.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/exchange/serial_exchange.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {
namespace {

using Face = std::vector<std::int64_t>;

/// The pieces of all ranks.
struct Collected {
  std::mutex mutex;
  std::map<int, MeshPiece> pieces;
  int begun = 0, finished = 0;
};

/// Keeps the pieces of a rank in memory.
class CollectingSink final : public PieceSink {
 public:
  explicit CollectingSink(Collected& all) : all_(all) {}

  void begin(const PieceIndex&) override {
    const std::lock_guard lock(all_.mutex);
    ++all_.begun;
  }

  void write(int piece, const MeshPiece& mesh) override {
    const std::lock_guard lock(all_.mutex);
    EXPECT_TRUE(all_.pieces.emplace(piece, mesh).second) << "piece " << piece << " twice";
  }

  void finish() override {
    const std::lock_guard lock(all_.mutex);
    ++all_.finished;
  }

 private:
  Collected& all_;
};

/// A mesh as its vertices and faces, whatever it was made of.
struct PlainMesh {
  std::vector<Vec3> points;
  std::vector<Face> faces;
  std::vector<int> patches;

  friend bool operator==(const PlainMesh&, const PlainMesh&) = default;
};

PlainMesh plain(const PolyMesh& mesh) {
  PlainMesh result;
  const SharedVertices vertices(mesh);
  for (const VertexHandle vh : mesh.vertices()) {
    if (vertices.is_first(vh)) result.points.push_back(to_eigen(mesh.point(vh)));
  }
  const auto patch_of = require(mesh, keys::face_patch);
  for (const FaceHandle fh : mesh.faces()) {
    Face& face = result.faces.emplace_back();
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      face.push_back(vertices.number(mesh.to_vertex_handle(heh).idx()));
    }
    result.patches.push_back(mesh.property(patch_of, fh));
  }
  return result;
}

/// The union of pieces whose tiles follow each other.
PlainMesh joined(const std::map<int, MeshPiece>& pieces) {
  PlainMesh result;
  std::map<std::int64_t, Vec3> points;
  for (const auto& [number, piece] : pieces) {
    for (std::size_t v = 0; v < piece.ids.size(); ++v) {
      const auto [found, is_new] = points.emplace(piece.ids[v], piece.points[v]);
      EXPECT_EQ(found->second, piece.points[v]) << "vertex " << piece.ids[v] << " moves";
    }
    for (std::size_t f = 0; f < piece.faces.size(); ++f) {
      Face& face = result.faces.emplace_back();
      for (const int v : piece.faces[f]) face.push_back(piece.ids[static_cast<std::size_t>(v)]);
    }
    result.patches.insert(result.patches.end(), piece.patches.begin(), piece.patches.end());
  }
  std::int64_t next = 0;
  for (const auto& [id, point] : points) {
    EXPECT_EQ(id, next++);
    result.points.push_back(point);
  }
  return result;
}

/// The positions of the corners of all faces.
std::vector<std::vector<Vec3>> corners_of(const PlainMesh& mesh) {
  std::vector<std::vector<Vec3>> corners;
  for (const Face& face : mesh.faces) {
    std::vector<Vec3>& points = corners.emplace_back();
    for (const std::int64_t v : face) points.push_back(mesh.points[static_cast<std::size_t>(v)]);
  }
  return corners;
}

struct PiecesCase {
  std::string file;
  bool has_quads = false;
  bool is_oriented = true;  ///< else a half-edge mesh is cut, and has vertices twice there

  friend void PrintTo(const PiecesCase& c, std::ostream* out) {
    *out << c.file << (c.has_quads ? " quads" : "");
  }
};

/// A model, and the options of all runs on it.
struct Given {
  explicit Given(const PiecesCase& of) {
    ModelInput loaded = load_model(std::string(SURFMESH_SOURCE_DIR "/models/") + of.file, {});
    model = std::move(loaded.model);
    sources = std::move(loaded.sources);
    options = loaded.options;
    options.sizing.hmax = Length::share(0.02);
    options.quads.is_on = of.has_quads;
    options.tile = 200;
    options.threads = 2;
    options.across.is_on = false;
  }

  Model model;
  Sources sources;
  PipelineOptions options;
};

Report mesh_on(int ranks, const Given& given, const PiecesOptions& pieces, Collected& all) {
  std::vector<Report> reports(static_cast<std::size_t>(ranks));
  testing::run_ranks(ranks, [&](Exchange& exchange) {
    CollectingSink sink(all);
    reports[static_cast<std::size_t>(exchange.rank())] =
        mesh_pieces(given.model, given.sources, given.options, pieces, exchange, sink);
  });
  for (const Report& report : reports) {
    EXPECT_EQ(report.mesh.triangles, reports[0].mesh.triangles);
    EXPECT_EQ(report.edges, reports[0].edges);
    EXPECT_EQ(report.pieces->bytes_sent, reports[0].pieces->bytes_sent);
  }
  EXPECT_EQ(all.begun, ranks);
  EXPECT_EQ(all.finished, ranks);
  return reports[0];
}

class Pieces : public ::testing::TestWithParam<PiecesCase> {};

TEST_P(Pieces, AreTheMeshOfOneProcess) {
  const Given given(GetParam());
  const MeshResult whole = mesh_model(given.model, given.sources, given.options);
  const PlainMesh expected = plain(whole.mesh);
  for (const int ranks : {1, 2, 3}) {
    for (const int count : {0, 5}) {
      Collected all;
      const Report report = mesh_on(ranks, given, {.pieces = count}, all);
      const PlainMesh mesh = joined(all.pieces);
      EXPECT_TRUE(corners_of(mesh) == corners_of(expected)) << ranks << " ranks, " << count;
      EXPECT_EQ(report.mesh.vertices, mesh.points.size());
      if (GetParam().is_oriented) {
        EXPECT_TRUE(mesh == expected) << ranks << " ranks, " << count;
      }
      EXPECT_EQ(report.mesh.triangles, whole.report.mesh.triangles);
      EXPECT_EQ(report.mesh.quads, whole.report.mesh.quads);
      EXPECT_EQ(report.pieces->count, all.pieces.size());
    }
  }
}

TEST_P(Pieces, ReportWhatTheMeshIs) {
  const Given given(GetParam());
  const Report whole = mesh_model(given.model, given.sources, given.options).report;
  Collected all;
  const Report report = mesh_on(2, given, {.pieces = 4}, all);
  // Edges at the borders of tiles count twice.
  EXPECT_NEAR(report.edges.mean, whole.edges.mean, 0.01);
  EXPECT_NEAR(report.edges.stddev, whole.edges.stddev, 0.01);
  EXPECT_NEAR(report.edges.unit_fraction, whole.edges.unit_fraction, 0.01);
  EXPECT_NEAR(report.quality.min, whole.quality.min, 1e-9);
  EXPECT_NEAR(report.quality.mean, whole.quality.mean, 0.01);
  EXPECT_EQ(report.quads.inverted, whole.quads.inverted);
  ASSERT_EQ(report.patches.size(), whole.patches.size());
  for (std::size_t p = 0; p < report.patches.size(); ++p) {
    EXPECT_EQ(report.patches[p].triangles, whole.patches[p].triangles);
    EXPECT_EQ(report.patches[p].quads, whole.patches[p].quads);
  }
}

/// How many sides each edge of a mesh has.
std::map<std::pair<std::int64_t, std::int64_t>, int> sides_of_edges(const PlainMesh& mesh) {
  std::map<std::pair<std::int64_t, std::int64_t>, int> sides;
  for (const Face& face : mesh.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::int64_t next = face[i + 1 == face.size() ? 0 : i + 1];
      ++sides[{std::min(face[i], next), std::max(face[i], next)}];
    }
  }
  return sides;
}

TEST_P(Pieces, KnowWhetherTheMeshIsClosed) {
  const Given given(GetParam());
  Collected all;
  const Report report = mesh_on(2, given, {.pieces = 4}, all);
  const PlainMesh mesh = joined(all.pieces);
  const auto sides = sides_of_edges(mesh);
  EXPECT_EQ(report.mesh.euler,
            std::ssize(mesh.points) - std::ssize(sides) + std::ssize(mesh.faces));
  EXPECT_EQ(report.mesh.is_closed, std::none_of(sides.begin(), sides.end(),
                                                [](const auto& edge) { return edge.second == 1; }));
  if (!GetParam().is_oriented) return;
  const Report whole = mesh_model(given.model, given.sources, given.options).report;
  EXPECT_EQ(report.mesh.euler, whole.mesh.euler);
  EXPECT_EQ(report.mesh.is_closed, whole.mesh.is_closed);
}

TEST_P(Pieces, AreForetold) {
  const Given given(GetParam());
  Collected all;
  const Report made = mesh_on(3, given, {.pieces = 4}, all);
  const Report foretold =
      estimate_pieces(given.model, given.sources, given.options, {.pieces = 4}, 3);
  EXPECT_EQ(foretold.tiles.count, made.tiles.count);
  EXPECT_EQ(foretold.pieces->count, made.pieces->count);
  EXPECT_EQ(foretold.pieces->of_several_pieces, made.pieces->of_several_pieces);
  EXPECT_EQ(foretold.pieces->of_several_ranks, made.pieces->of_several_ranks);
  const auto sent = static_cast<double>(made.pieces->bytes_sent);
  // Chords, which nobody knows before there are triangles, are most with sizes that change fast.
  EXPECT_LE(static_cast<double>(foretold.pieces->bytes_sent), sent);
  EXPECT_NEAR(static_cast<double>(foretold.pieces->bytes_sent), sent, 0.2 * sent);
  ASSERT_EQ(foretold.pieces->faces_of_ranks.size(), 3U);
  EXPECT_TRUE(foretold.pieces->seconds_of_ranks.empty());
  const double mean = static_cast<double>(made.mesh.triangles + made.mesh.quads) / 3;
  for (std::size_t rank = 0; rank < 3; ++rank) {
    EXPECT_NEAR(static_cast<double>(foretold.pieces->faces_of_ranks[rank]),
                static_cast<double>(made.pieces->faces_of_ranks[rank]), 0.2 * mean);
  }
}

/// The ids that two pieces have in common, ascending.
std::vector<std::int64_t> common_ids(const MeshPiece& a, const MeshPiece& b) {
  const std::set<std::int64_t> of_a(a.ids.begin(), a.ids.end()), of_b(b.ids.begin(), b.ids.end());
  std::vector<std::int64_t> both;
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                        std::back_inserter(both));
  return both;
}

/// The ids that a piece lists for another one.
std::vector<std::int64_t> listed_ids(const MeshPiece& piece, int other) {
  std::vector<std::int64_t> ids;
  for (const SharedWithPiece& neighbour : piece.neighbours) {
    if (neighbour.piece != other) continue;
    for (const int v : neighbour.vertices) ids.push_back(piece.ids[static_cast<std::size_t>(v)]);
  }
  return ids;
}

TEST_P(Pieces, KnowTheirNeighbours) {
  const Given given(GetParam());
  Collected all;
  mesh_on(2, given, {.pieces = 4}, all);
  for (const auto& [number, piece] : all.pieces) {
    for (const auto& [other_number, other] : all.pieces) {
      if (number == other_number) continue;
      EXPECT_EQ(listed_ids(piece, other_number), common_ids(piece, other))
          << number << ", " << other_number;
    }
  }
}

TEST_P(Pieces, DoNotDependOnThreads) {
  Given given(GetParam());
  given.options.threads = 1;
  Collected by_one;
  mesh_on(2, given, {.pieces = 4}, by_one);
  for (const int threads : {2, 4}) {
    given.options.threads = threads;
    Collected all;
    mesh_on(2, given, {.pieces = 4}, all);
    EXPECT_TRUE(joined(all.pieces) == joined(by_one.pieces)) << threads;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Pieces,
                         ::testing::Values(PiecesCase{"cube.obj"}, PiecesCase{"sphere.json"},
                                           PiecesCase{"klein.json", false, false},
                                           PiecesCase{"moebius.json", false, false},
                                           PiecesCase{"perforated.json"},
                                           PiecesCase{"bracket.json"}, PiecesCase{"sizes.json"},
                                           PiecesCase{"knob_on_plate.json"},
                                           PiecesCase{"torus.json", true},
                                           PiecesCase{"sphere.json", true}));

/// Coarse enough for chords of two patches to join the same nodes.
TEST(PiecesOf, TilesWhoseChordsJoinTheSameNodesAreTheMeshOfOneProcess) {
  for (const double size : {0.6, 0.9, 1.3}) {
    Given given({"cube.obj"});
    given.model = testing::torus_of(3);
    given.sources = {};
    given.options = {};
    given.options.sizing.size = Length::units(size);
    given.options.across.is_on = false;
    const PlainMesh expected = plain(mesh_model(given.model, {}, given.options).mesh);
    Collected all;
    mesh_on(2, given, {.pieces = 3}, all);
    EXPECT_TRUE(joined(all.pieces) == expected) << size;
  }
}

/// A dome, or a bowl, over the unit square.
class Dome final : public test::AnalyticSurface {
 public:
  explicit Dome(double height) : AnalyticSurface({0, 1, 0, 1}), height_(height) {}

 protected:
  Jet all(Uv at) const override {
    const double u = at.u * (1 - at.u), v = at.v * (1 - at.v);
    const double du = 1 - 2 * at.u, dv = 1 - 2 * at.v;
    return {Vec3(at.u, at.v, height_ * u * v), Vec3(1, 0, height_ * du * v),
            Vec3(0, 1, height_ * u * dv),      Vec3(0, 0, -2 * height_ * v),
            Vec3(0, 0, height_ * du * dv),     Vec3(0, 0, -2 * height_ * u)};
  }

 private:
  double height_;
};

/// Over the same square, and coarse enough for chords of both patches to join the same nodes.
TEST(PiecesOf, ADomeAndABowlAreMendedTogether) {
  const Model model =
      testing::model_of({std::make_shared<Dome>(0.5), std::make_shared<Dome>(-0.5)});
  for (const double size : {0.35, 0.5, 0.6}) {
    PipelineOptions options;
    options.sizing.size = Length::units(size);
    options.across.is_on = false;
    const PlainMesh expected = plain(mesh_model(model, {}, options).mesh);
    // Tiles that are made again do not count again.
    options.max_elements = expected.faces.size();
    for (const int ranks : {1, 2}) {
      Collected all;
      testing::run_ranks(ranks, [&](Exchange& exchange) {
        CollectingSink sink(all);
        mesh_pieces(model, {}, options, {.pieces = 2}, exchange, sink);
      });
      EXPECT_TRUE(joined(all.pieces) == expected) << size << ", " << ranks;
    }
  }
}

TEST(PiecesOf, AModelWithASagAreTheSameOnAnyRanks) {
  Given given({"sphere.json"});
  given.options.sizing.sag = Length::share(0.0005);
  Collected by_one;
  const Report expected = mesh_on(1, given, {.pieces = 4}, by_one);
  ASSERT_GT(expected.mesh.triangles, 0u);
  for (const int ranks : {2, 3}) {
    Collected all;
    mesh_on(ranks, given, {.pieces = 4}, all);
    EXPECT_TRUE(joined(all.pieces) == joined(by_one.pieces)) << ranks;
  }
}

// --- errors ---

using CodeAndText = std::pair<ErrorCode, std::string>;

/// The error that all ranks throw together; Io without text if they do not.
CodeAndText agreed_error(int ranks, const std::function<void(Exchange&)>& body) {
  std::set<CodeAndText> found;
  for (const std::exception_ptr& error : testing::errors_of_ranks(ranks, body)) {
    EXPECT_TRUE(error) << "a rank without an error";
    if (!error) continue;
    try {
      std::rethrow_exception(error);
    } catch (const AgreedError& thrown) {
      found.emplace(thrown.code(), thrown.what());
    }
  }
  EXPECT_EQ(found.size(), 1u) << "ranks do not agree";
  return found.size() == 1 ? *found.begin() : CodeAndText{ErrorCode::Io, {}};
}

TEST(PiecesOf, AnErrorOnOneRankIsThatOfAllRanks) {
  Given given({"cube.obj"});
  given.options.max_elements = 100;
  Collected all;
  const CodeAndText error = agreed_error(3, [&](Exchange& exchange) {
    CollectingSink sink(all);
    mesh_pieces(given.model, given.sources, given.options, {}, exchange, sink);
  });
  EXPECT_EQ(error.first, ErrorCode::Limit);
  EXPECT_TRUE(all.pieces.empty());
}

/// Each rank makes a part of what is allowed.
TEST(PiecesOf, RanksTogetherMakeNoMoreThanIsAllowed) {
  Given given({"sphere.json"});
  Collected made;
  const std::size_t count = mesh_on(2, given, {}, made).mesh.triangles;
  given.options.max_elements = count - count / 32;
  for (const int ranks : {2, 3}) {
    Collected all;
    const CodeAndText error = agreed_error(ranks, [&](Exchange& exchange) {
      CollectingSink sink(all);
      mesh_pieces(given.model, given.sources, given.options, {}, exchange, sink);
    });
    EXPECT_EQ(error.first, ErrorCode::Limit);
    EXPECT_EQ(error.second,
              fmt::format("more than max_elements = {} triangles", given.options.max_elements));
    EXPECT_TRUE(all.pieces.empty());
  }
}

/// Knows when a rank has come to its tiles.
class AtTiles final : public Observer {
 public:
  explicit AtTiles(bool cancels = false) : cancels_(cancels) {}

  void progress(std::string_view stage, std::size_t, std::size_t) override {
    if (stage == "mesh") has_begun_ = true;
  }
  bool is_cancelled() override { return cancels_ && has_begun_; }
  bool has_begun() const { return has_begun_; }

 private:
  bool cancels_;
  std::atomic<bool> has_begun_ = false;
};

/// Part of the plane that cannot be evaluated when tiles are meshed.
class FaultyPlane final : public test::PlanePatch {
 public:
  FaultyPlane(Domain domain, const AtTiles& at, std::function<void()> fault)
      : PlanePatch(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), domain),
        at_(at),
        fault_(std::move(fault)) {}

 protected:
  Jet all(Uv uv) const override {
    if (at_.has_begun()) fault_();
    return PlanePatch::all(uv);
  }

 private:
  const AtTiles& at_;
  std::function<void()> fault_;
};

/// Five patches in a row, each one tile, of which p1 and p3, which is larger, have a fault.
Model row_with_faults(const AtTiles& at, const std::function<void()>& fault) {
  const std::vector<double> ends = {0, 1, 2, 3, 6, 8};
  std::vector<testing::Shape> shapes;
  for (std::size_t p = 0; p + 1 < ends.size(); ++p) {
    const Domain domain{ends[p], ends[p + 1], 0, 1};
    if (p == 1 || p == 3) {
      shapes.push_back(std::make_shared<FaultyPlane>(domain, at, fault));
    } else {
      shapes.push_back(testing::rectangle(domain.u0, 0, domain.u1, 1));
    }
  }
  return testing::model_of(shapes);
}

/// Mesh the row with as many pieces as ranks, of which one may be cancelled.
CodeAndText error_of_row(int ranks, int threads, const std::function<void()>& fault,
                         int cancelled_rank = -1) {
  PipelineOptions options;
  options.sizing.size = Length::units(0.2);
  options.threads = threads;
  Collected all;
  return agreed_error(ranks, [&](Exchange& exchange) {
    AtTiles at(exchange.rank() == cancelled_rank);
    const Model model = row_with_faults(at, fault);
    CollectingSink sink(all);
    mesh_pieces(model, {}, options, {}, exchange, sink, &at);
  });
}

TEST(PiecesOf, AModelWithFaultsHaveTheErrorOfTheFirstTile) {
  const auto fault = [] { throw Error(ErrorCode::Geometry, "a fault"); };
  for (const int ranks : {1, 2, 3, 4}) {
    for (const int threads : {1, 2, 4}) {
      const CodeAndText error = error_of_row(ranks, threads, fault);
      EXPECT_EQ(error.first, ErrorCode::Geometry);
      EXPECT_EQ(error.second, "patch p1: a fault") << ranks << " ranks, " << threads;
    }
  }
}

TEST(PiecesOf, ATileWithoutMemoryTellHowFarTheyCame) {
  const CodeAndText error = error_of_row(2, 1, [] { throw std::bad_alloc(); });
  EXPECT_EQ(error.first, ErrorCode::Limit);
  EXPECT_TRUE(error.second.starts_with("out of memory at ")) << error.second;
  EXPECT_TRUE(error.second.ends_with(" triangles in finished tiles")) << error.second;
}

TEST(PiecesOf, AForeignSurfaceTellItsException) {
  const CodeAndText error = error_of_row(3, 2, [] { throw std::out_of_range("no such point"); });
  EXPECT_EQ(error.first, ErrorCode::InvalidInput);
  EXPECT_EQ(error.second, "no such point");
}

TEST(PiecesOf, ACancelledRunTellNoOtherError) {
  const auto fault = [] { throw Error(ErrorCode::Geometry, "a fault"); };
  for (const int cancelled_rank : {0, 1}) {
    const CodeAndText error = error_of_row(2, 2, fault, cancelled_rank);
    EXPECT_EQ(error.first, ErrorCode::Cancelled);
  }
}

// --- reports ---

/// The kinds and places of what is told of faces.
std::vector<std::pair<NoticeKind, Vec3>> told_of_faces(const Report& report) {
  std::vector<std::pair<NoticeKind, Vec3>> told;
  for (const Notice& notice : report.notices) {
    const bool is_of_faces =
        notice.kind == NoticeKind::FlatTriangles || notice.kind == NoticeKind::FlatQuads ||
        notice.kind == NoticeKind::InvertedQuads || notice.kind == NoticeKind::LeftTriangles;
    if (is_of_faces) told.emplace_back(notice.kind, notice.point.value_or(Vec3::Zero()));
  }
  return told;
}

/// A strip that is too narrow for its triangles.
TEST(PiecesOf, BadFacesTellOfThemAsTheWholeMesh) {
  PipelineOptions options;
  options.across.is_on = false;
  options.sizing.size = Length::units(0.3);
  const Model strip = testing::model_of({testing::rectangle(0, 0, 2, 0.01)});
  const Report whole = mesh_model(strip, {}, options).report;
  ASSERT_FALSE(told_of_faces(whole).empty());
  SerialExchange exchange;
  Collected all;
  CollectingSink sink(all);
  const Report report = mesh_pieces(strip, {}, options, {}, exchange, sink);
  EXPECT_EQ(told_of_faces(report), told_of_faces(whole));
}

TEST(PiecesOf, ATightSagTellThatItIsRaised) {
  Given given({"sphere.json"});
  for (Contour& contour : given.model.contours) contour.tolerance = 0.01;
  given.options.sizing.sag = Length::units(0.5 * least_sag(given.model));
  const Report report = estimate_pieces(given.model, given.sources, given.options, {}, 2);
  EXPECT_TRUE(std::any_of(report.notices.begin(), report.notices.end(), [](const Notice& notice) {
    return notice.kind == NoticeKind::LooseFit && notice.severity == Severity::Shortfall;
  }));
}

TEST(PiecesOf, FewerPiecesThanRanksAreTold) {
  Given given({"sphere.json"});
  given.options.tile = 0;
  Collected all;
  const Report report = mesh_on(3, given, {}, all);
  const auto told = std::find_if(
      report.notices.begin(), report.notices.end(),
      [](const Notice& notice) { return notice.text.find("ranks") != std::string::npos; });
  ASSERT_NE(told, report.notices.end());
  EXPECT_EQ(told->text,
            "there is only 1 piece, as many as tiles, and 2 of 3 ranks have nothing to do; a tile "
            "above 0 makes more");
}

TEST(PiecesOf, ADealTellsHowEvenlyTrianglesAreDealt) {
  const Given given({"sphere.json"});
  const Report report = estimate_pieces(given.model, given.sources, given.options, {}, 4);
  const Report::Pieces& pieces = *report.pieces;
  EXPECT_EQ(pieces.count, 4U);
  ASSERT_EQ(pieces.faces_of_ranks.size(), 4U);
  for (const std::size_t triangles : pieces.faces_of_ranks) {
    EXPECT_NEAR(static_cast<double>(triangles), report.estimated_elements / 4,
                0.3 * report.estimated_elements / 4);
  }
  EXPECT_NEAR(pieces.largest_share(), 1.15, 0.15);
  EXPECT_GT(pieces.of_several_ranks, 0U);
}

TEST(PiecesOf, OneRankSendsNothing) {
  const Given given({"sphere.json"});
  Collected all;
  const Report made = mesh_on(1, given, {.pieces = 3}, all);
  EXPECT_EQ(made.pieces->bytes_sent, 0U);
  EXPECT_EQ(made.pieces->of_several_ranks, 0U);
  EXPECT_GT(made.pieces->of_several_pieces, 0U);
  EXPECT_EQ(made.pieces->faces_of_ranks, std::vector<std::size_t>{made.mesh.triangles});
  const Report foretold =
      estimate_pieces(given.model, given.sources, given.options, {.pieces = 3}, 1);
  EXPECT_EQ(foretold.pieces->bytes_sent, 0U);
}

}  // namespace
}  // namespace surfmesh
