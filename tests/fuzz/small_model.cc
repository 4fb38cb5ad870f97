// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/small_model.hh"

#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <nlohmann/json.hpp>

namespace surfmesh::fuzz {
namespace {

using Json = nlohmann::ordered_json;

/// Three digits: texts stay short.
std::string text_of(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

double rounded(double x) { return std::stod(text_of(x)); }

/// Puts values in place of each $ of a text.
std::string filled(std::string_view text, std::initializer_list<std::string> values) {
  std::string result;
  auto value = values.begin();
  for (const char c : text) {
    if (c == '$') {
      result += *value++;
    } else {
      result += c;
    }
  }
  return result;
}

/// How far a second part of a model is from the first, which it must not lie on.
constexpr double kFar = 10;

class Maker {
 public:
  explicit Maker(ByteReader& bytes) : bytes_(bytes) {}

  SmallModel make() {
    using Kind = void (Maker::*)();
    constexpr std::array<Kind, 13> kKinds = {
        &Maker::add_sheet, &Maker::add_trimmed, &Maker::add_tube, &Maker::add_sphere,
        &Maker::add_torus, &Maker::add_moebius, &Maker::add_grid, &Maker::add_box,
        &Maker::add_cone,  &Maker::add_cage,    &Maker::add_net,  &Maker::add_tee,
        &Maker::add_loose};
    (this->*bytes_.one_of(kKinds))();
    shift_ = kFar;
    if (bytes_.happens(20)) (this->*bytes_.one_of(kKinds))();
    add_sources();
    add_sizing();
    add_options();
    return {text(), std::move(cages_)};
  }

 private:
  std::string text() const {
    Json root = Json::object();
    if (!patch_list_.empty()) root["patches"] = patch_list_;
    if (!contours_.empty()) root["contours"] = contours_;
    if (!cage_list_.empty()) root["cages"] = cage_list_;
    if (!sources_.empty()) root["sources"] = sources_;
    root["sizing"] = sizing_;
    root["options"] = options_;
    return root.dump(1);
  }

  std::string number(double from, double to) { return text_of(bytes_.real(from, to)); }

  /// A smooth function of u and v; 0 most often.
  std::string wave() {
    constexpr std::array<std::string_view, 8> kTerms = {
        "0",       "$*sin($*u+$*v)",        "$*cos($*u)*sin($*v)",  "$*exp(-((u-$)^2+(v-$)^2)*9)",
        "$*u^2*v", "$*tanh($*(u-$*v))*0.5", "$*abs(u-$*v)*(0.1+$)", "$*if(u<$,u,v*$)"};
    const std::string_view term = bytes_.one_of(kTerms);
    return filled(term, {number(-0.5, 0.5), number(-6, 6), number(-6, 6)});
  }

  Json& add_patch(Json surface, const Json& u, const Json& v) {
    if (shift_ > 0) {
      const std::string x = surface["x"];
      surface["x"] = filled("$+($)", {text_of(shift_), x});
    }
    const std::string name = std::string("p").append(std::to_string(patches_++));
    return patch_list_.emplace_back(
        Json{{"name", name}, {"surface", surface}, {"domain", {{"u", u}, {"v", v}}}});
  }

  void add_sheet() {
    const double width = rounded(bytes_.real(1, 5)), height = rounded(bytes_.real(1, 0.02));
    add_patch({{"x", filled("u+$*v", {number(0, 2)})}, {"y", "v"}, {"z", wave()}}, {0, width},
              {0, height});
  }

  void add_trimmed() {
    Json& patch = add_patch({{"x", "u"}, {"y", "v"}, {"z", wave()}}, {0, 2}, {0, 1});
    const std::string p = patch["name"];
    Json loops = Json::array();
    loops.push_back(
        Json::array({p + ":v0", p + ":u1", filled("-$:v1", {p}), filled("-$:u0", {p})}));
    const std::size_t holes = 1 + bytes_.below(3);
    for (std::size_t i = 0; i < holes; ++i) {
      const std::string hole = p + "h" + std::to_string(i);
      const std::string x = text_of(
          2 * (static_cast<double>(i) + 0.5) / static_cast<double>(holes) + bytes_.real(0, 0.3));
      const std::string a = number(0.02, 0.4), b = number(0.02, 0.45);
      const std::string n = std::to_string(bytes_.below(4));
      const std::string wobble = filled("(1+0.3*sin($*t))", {n});
      Json on = {{"patch", p},
                 {"u", filled("$+$*cos(t)*$", {x, a, wobble})},
                 {"v", filled("0.5+$*sin(t)*$", {b, wobble})}};
      contours_.push_back({{"name", hole}, {"range", {0, "2*pi"}}, {"on", Json::array({on})}});
      loops.push_back(Json::array({bytes_.happens(40) ? hole : filled("-$", {hole})}));
    }
    patch["loops"] = loops;
  }

  /// Patches around an axis, of a surface whose parameter u is the angle.
  void add_around(const Json& surface, const Json& v) {
    const std::size_t count = 1 + bytes_.below(4);
    const double whole = bytes_.happens(60) ? bytes_.real(0.3, 6) : 2 * M_PI;
    const double from = bytes_.happens(60) ? bytes_.real(-4, 4) : 0;
    const auto at = [&](std::size_t i) {
      return from + whole * static_cast<double>(i) / static_cast<double>(count);
    };
    for (std::size_t i = 0; i < count; ++i) add_patch(surface, {at(i), at(i + 1)}, v);
  }

  void add_tube() {
    const std::string r = filled("(1+$*sin($*v))", {number(0, 0.9), number(1, 5)});
    add_around({{"x", r + "*cos(u)"}, {"y", r + "*sin(u)"}, {"z", number(0.1, 5) + "*v"}}, {0, 1});
  }

  void add_sphere() {
    const std::string bump = filled("(1+$*cos(v)^4*cos(2*u))", {number(0, 0.4)});
    const std::string a = number(0.2, 2), b = number(0.2, 2);
    const Json from = bytes_.happens(80) ? Json(rounded(bytes_.real(-1.5, 1.2))) : Json("-pi/2");
    add_around(
        {{"x", a + "*cos(u)*cos(v)*" + bump}, {"y", "sin(u)*cos(v)*" + bump}, {"z", b + "*sin(v)"}},
        {from, "pi/2"});
  }

  void add_torus() {
    const std::string r = number(0.1, 1), turn = std::to_string(bytes_.below(3));
    const std::string ring = filled("(1.5+$*cos(v+$*u))", {r, turn});
    add_around({{"x", ring + "*cos(u)"},
                {"y", ring + "*sin(u)"},
                {"z", filled("$*sin(v+$*u)", {r, turn})}},
               {0, "2*pi"});
  }

  void add_moebius() {
    const std::string n = std::to_string(1 + bytes_.below(3));
    const double width = rounded(bytes_.real(0.05, 0.8));
    const std::string ring = filled("(1+v*cos($*u/2))", {n});
    add_around(
        {{"x", ring + "*cos(u)"}, {"y", ring + "*sin(u)"}, {"z", filled("v*sin($*u/2)", {n})}},
        {-width, width});
  }

  /// A graph cut into patches with parameters of their own.
  void add_grid() {
    const std::size_t m = 1 + bytes_.below(3), n = 1 + bytes_.below(3);
    const std::string z = wave();
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const bool is_turned = bytes_.happens(80);
        Json surface = {{"where", {{"a", is_turned ? "v" : "u"}, {"b", is_turned ? "u" : "v"}}},
                        {"x", std::to_string(i) + "+a"},
                        {"y", std::to_string(j) + "+b"},
                        {"z", filled("$*sin($+a)*cos($+b)",
                                     {number(0, 1), std::to_string(i), std::to_string(j)})}};
        if (z == "0" || z == "0*") surface["z"] = "0";
        add_patch(surface, {0, 1}, {0, 1});
      }
    }
  }

  void add_box() {
    const std::string a = number(0.1, 3), b = number(0.1, 3), h = number(0.02, 3);
    const std::array<std::array<std::string, 5>, 6> faces = {{{"u", "v", "0", a, b},
                                                              {"u", "v", h, a, b},
                                                              {"u", "0", "v", a, h},
                                                              {"u", b, "v", a, h},
                                                              {"0", "u", "v", b, h},
                                                              {a, "u", "v", b, h}}};
    const std::size_t missing = bytes_.below(12);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (i + 1 == missing) continue;
      const auto& face = faces[i];
      add_patch({{"x", face[0]}, {"y", face[1]}, {"z", face[2]}}, {0, face[3]}, {0, face[4]});
    }
  }

  void add_cone() {
    const std::string tip = number(0, 0.2);
    add_around({{"x", filled("(v+$)*cos(u)", {tip})},
                {"y", filled("(v+$)*sin(u)*$", {tip, number(0.3, 1)})},
                {"z", number(0, 4) + "*v"}},
               {bytes_.happens(60) ? -1 : 0, 1});
  }

  /// Four points of quads or triangles, cubes, and rows of faces, with points moved.
  void add_cage() {
    constexpr std::array<std::string_view, 5> kCages = {
        "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n",
        "f 1 2 4 3\nf 3 4 6 5\nf 5 6 8 7\n", "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n",
        "f 1 2 4 3\nf 1 5 6 2\nf 1 3 7 5\n", "g a\nf 1 2 4\nf 1 4 3\ng b\nf 3 4 6 5\nf 7 8 6 5\n"};
    const std::string_view faces = bytes_.one_of(kCages);
    std::string text;
    for (std::size_t i = 0; i < 8; ++i) {
      text += "v";
      for (const std::size_t bit : {1u, 2u, 4u}) {
        const double corner = ((i & bit) != 0 ? 1 : 0) + (bit == 1 ? shift_ : 0);
        text += ' ';
        text += text_of(corner + (bytes_.happens(60) ? bytes_.real(-0.6, 0.6) : 0));
      }
      text += "\n";
    }
    text += faces;
    if (bytes_.happens(60)) text += filled("t crease 2/1/0 0 1 $\n", {number(0, 11)});
    if (bytes_.happens(40)) text += filled("t corner 1/1/0 2 $\n", {number(0, 11)});
    if (bytes_.happens(30)) text += "t hole 1/0/0 0\n";
    const std::string name = std::string("c").append(std::to_string(cages_.size()));
    cages_.push_back({name + ".obj", text});
    Json cage = {{"name", name}, {"file", name + ".obj"}};
    add_choice(cage, "scheme", {"catmark", "loop", "bilinear"}, 90);
    add_choice(cage, "patches", {"faces", "blocks", "regions"}, 90);
    cage_list_.push_back(cage);
  }

  void add_net() {
    const std::size_t m = 3 + bytes_.below(3), n = 3 + bytes_.below(2);
    Json rows = Json::array();
    for (std::size_t j = 0; j < n; ++j) {
      Json row = Json::array();
      for (std::size_t i = 0; i < m; ++i) {
        row.push_back({rounded(shift_ + static_cast<double>(i) + bytes_.real(0, 0.6)),
                       rounded(static_cast<double>(j) + bytes_.real(0, 0.6)),
                       rounded(bytes_.real(0, 1))});
      }
      rows.push_back(row);
    }
    const std::size_t degree = 1 + bytes_.below(2);
    const auto knots = [&](std::size_t points) {
      Json list = Json::array();
      for (std::size_t k = 0; k < points + degree + 1; ++k) {
        const std::size_t inner = k < degree ? degree : k > points ? points : k;
        list.push_back(inner - degree);
      }
      return list;
    };
    const Json net = {
        {"degree", {degree, degree}}, {"knots", {knots(m), knots(n)}}, {"points", rows}};
    const std::string name = std::string("p").append(std::to_string(patches_++));
    patch_list_.push_back({{"name", name}, {"surface", {{"nurbs", net}}}});
  }

  /// A patch whose side is that of two others.
  void add_tee() {
    const std::string at = number(0.05, 0.95), z = number(0, 0.7);
    add_patch({{"x", "u"}, {"y", "v"}, {"z", filled("$*sin(3*u)", {z})}}, {0, 1}, {0, 1});
    add_patch({{"x", "u"}, {"y", "-v"}, {"z", filled("$*sin(3*u)", {z})}}, {0, at}, {0, 1});
    add_patch({{"x", "u"}, {"y", "-v"}, {"z", filled("$*sin(3*u)+$*v", {z, number(0, 1)})}},
              {at, 1}, {0, 1});
    if (bytes_.happens(60)) {
      add_patch({{"x", "u"}, {"y", "0"}, {"z", filled("$*sin(3*u)+v", {z})}}, {0, 1},
                {0, number(0.01, 1)});
    }
  }

  /// Sides that nearly meet.
  void add_loose() {
    const double gap = std::pow(10.0, bytes_.real(-10, -1));
    add_patch({{"x", "u"}, {"y", "v"}, {"z", "0"}}, {0, 1}, {0, 1});
    add_patch({{"x", filled("1+$+u", {text_of(gap)})},
               {"y", filled("v*(1+$)", {text_of(gap)})},
               {"z", wave()}},
              {0, 1}, {0, 1});
  }

  void add_sources() {
    if (patches_ == 0) return;
    const std::size_t count = bytes_.below(3);
    for (std::size_t i = 0; i < count; ++i) add_source();
  }

  void add_source() {
    Json& patch = patch_list_[bytes_.below(patch_list_.size())];
    const Json size = size_of();
    const std::string name = patch["name"];
    switch (bytes_.below(7)) {
      case 0:
        patch["sources"].push_back({{"everywhere", true}, {"size", size}});
        break;
      case 1:
        patch["sources"].push_back(
            {{"at", {bytes_.real(0, 1), bytes_.real(0, 1)}}, {"size", size}, {"radius", radius()}});
        break;
      case 2:
        patch["sources"].push_back({{"along", name + ":u0"}, {"size", size}});
        break;
      case 3:
        patch["sources"].push_back(
            {{"inside", {{0, 0}, {bytes_.real(0.1, 1), 0}, {0.5, bytes_.real(0.1, 1)}}},
             {"size", size}});
        break;
      case 4:
        patch["sources"].push_back(
            {{"field",
              {{"size",
                filled("$+$*abs(u-$)", {number(0.05, 0.5), number(0, 2), number(0, 1)})}}}});
        break;
      case 5:
        patch["sources"].push_back({{"field",
                                     {{"m11", filled("$+$*u^2", {number(1, 100), number(0, 300)})},
                                      {"m12", number(-4, 4)},
                                      {"m22", number(5, 400)}}}});
        break;
      default:
        sources_.push_back({{"near", {bytes_.real(-1, 2), bytes_.real(-1, 2), bytes_.real(-1, 1)}},
                            {"size", size},
                            {"radius", radius()}});
    }
  }

  Json size_of() {
    const auto length = [&] { return text_of(100 * std::pow(10.0, bytes_.real(-0.6, -2))) + "%"; };
    if (bytes_.happens(160)) return length();
    return Json::array({length(), length()});
  }

  Json radius() { return text_of(bytes_.real(0.5, 40)) + "%"; }

  /// A share of the diagonal, from large to small.
  Json share(double from, double to) {
    return text_of(100 * std::pow(10.0, bytes_.real(from, to))) + "%";
  }

  void add_sizing() {
    Json& sizing = sizing_;
    sizing["hmax"] = share(-0.2, -1.2);
    sizing["hmin"] = share(-1.7, -4);
    add_choice(sizing, "curvature", {0, 0.1, 0.5, 2}, 100);
    add_choice(sizing, "segments_per_circle", {3, 8, 20}, 30);
    add_choice(sizing, "stretch", {1, 3, 10, 1000}, 60);
    add_choice(sizing, "grade", {0, 1.05, 1.2, 3}, 80);
    add_choice(sizing, "proximity", {0, 0.5, 3}, 60);
    add_choice(sizing, "features", {false}, 40);
    add_choice(sizing, "contour_curvature", {false}, 40);
    add_choice(sizing, "isotropic", {true}, 30);
    add_choice(sizing, "curvature_from", {"differences"}, 20);
    add_choice(sizing, "shares_of", {"part"}, 20);
    if (bytes_.happens(30)) sizing["sag"] = share(-1, -2.3);
    if (bytes_.happens(10)) sizing["size"] = share(-0.4, -1.2);
  }

  void add_options() {
    Json& options = options_;
    add_choice(options, "quads", {true}, 80);
    add_choice(options, "quad_method", {"best", "frontal"}, 80);
    add_choice(options, "quad_front", {"lee-lo", "q-morph", "mixed"}, 80);
    add_choice(options, "across", {false}, 60);
    add_choice(options, "tile", {100, 150, 300}, 60);
    add_choice(options, "placement", {"circumcentre"}, 40);
    add_choice(options, "kernel", {"swap"}, 40);
    add_choice(options, "smoothing", {0, "laplace", "element", 3}, 40);
    add_choice(options, "repairs", {0, 1, 10}, 40);
    add_choice(options, "control", {"mesh", "grid", "cells"}, 80);
    add_choice(options, "nodes", {4, 50, 400}, 30);
    add_choice(options, "interpolation", {"s", "t", "o", "auto"}, 60);
    add_choice(options, "blend", {"log"}, 40);
    add_choice(options, "lookup", {"vertices"}, 20);
    add_choice(options, "inner_nodes", {true}, 20);
    add_choice(options, "reuse", {0.1, 1}, 20);
    add_choice(options, "conformity", {0.1, 2}, 20);
    add_choice(options, "normals", {true}, 30);
    if (!cages_.empty()) {
      add_choice(options, "surface", {"limit", "interpolate"}, 80);
      add_choice(options, "weld", {"1%", "20%"}, 30);
      add_choice(options, "orient", {true}, 30);
      add_choice(options, "crease_angle", {20, 50, 90}, 40);
      add_choice(options, "fit", {"1%"}, 20);
      add_choice(options, "texture", {true}, 20);
    }
    if (patches_ > 0) add_choice(options, "joining", {"0.5%", "0.001%"}, 30);
  }

  void add_choice(Json& object, const char* name, std::initializer_list<Json> values, int chances) {
    if (bytes_.happens(chances)) object[name] = *(values.begin() + bytes_.below(values.size()));
  }

  ByteReader& bytes_;
  double shift_ = 0;  ///< along x, of what is added
  Json patch_list_ = Json::array();
  Json contours_ = Json::array();
  Json cage_list_ = Json::array();
  Json sources_ = Json::array();
  Json sizing_ = Json::object();
  Json options_ = Json::object();
  std::vector<Seed> cages_;
  std::size_t patches_ = 0;
};

}  // namespace

SmallModel make_small_model(ByteReader& bytes) { return Maker(bytes).make(); }

}  // namespace surfmesh::fuzz
