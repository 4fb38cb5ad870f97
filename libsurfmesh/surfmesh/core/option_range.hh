// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "surfmesh/core/parallel.hh"

// What the user may set, where it is a number, a switch or a choice: name and range of each option,
// once for the stage that checks it and for the table of options of the pipeline.
namespace surfmesh {

/// Letters of a user's text that a message repeats.
inline constexpr std::size_t kLongestQuote = 40;

/// Where a word is used.
enum class WordUse {
  Shown,  ///< stands in help, report and messages
  Alias   ///< read only
};

/// A word that stands for a value: "off" for 0, "circumcentre" for the second placement.
struct OptionWord {
  std::string_view word;
  double value = 0;
  WordUse use = WordUse::Shown;
};

/// The legal values of an option: some words, and the numbers from `least` to `most`.
///
/// Choices have words only, each for the value of its enum, and so have switches. Where 0 is off,
/// 0 is read as well as "off".
struct OptionRange {
  std::string_view name;
  std::span<const OptionWord> words = {};
  double least = 1;
  double most = 0;       ///< below `least`: no numbers
  bool is_open = false;  ///< `least` itself is no legal value
  bool is_whole = false;

  bool has_numbers() const { return least <= most; }
  /// True for on and off.
  bool is_switch() const;
  bool contains(double value) const;
  /// The word by which a value is shown, if it has one.
  std::optional<std::string_view> word_for(double value) const;
  /// The value of a text, if it is legal.
  std::optional<double> read(std::string_view text) const;
};

/// "off, or a number from 1 to 1000000".
std::string to_text(const OptionRange& range);

/// A value as it is shown: its word if it has one.
std::string to_text(const OptionRange& range, double value);

/// Throw InvalidOption: "grade = 0.5 is outside its range: off, or a number from 1 to 1000000".
[[noreturn]] void fail_option(std::string_view name, std::string_view value,
                              std::string_view range);

/// Throws   InvalidOption as fail_option if the value is not in the range
void check_option(const OptionRange& range, double value);

/// Of a choice, by its enum.
template <class Value>
requires std::is_enum_v<Value>
void check_option(const OptionRange& range, Value value) {
  check_option(range, static_cast<double>(static_cast<std::underlying_type_t<Value>>(value)));
}

/// The words of options.
namespace words {

inline constexpr std::array kOff = {OptionWord{"off", 0}};
inline constexpr std::array kAuto = {OptionWord{"auto", 0}};
inline constexpr std::array kAll = {OptionWord{"all", 0}};
inline constexpr std::array kSmoothing = {OptionWord{"off", 0}, OptionWord{"best", -1},
                                          OptionWord{"laplace", -2}, OptionWord{"element", -3}};
inline constexpr std::array kConformity = {OptionWord{"circle", 0}};
inline constexpr std::array kSwitch = {OptionWord{"on", 1}, OptionWord{"off", 0},
                                       OptionWord{"true", 1, WordUse::Alias},
                                       OptionWord{"false", 0, WordUse::Alias}};
inline constexpr std::array kCurvatureFrom = {OptionWord{"exact", 0}, OptionWord{"differences", 1}};
inline constexpr std::array kSharesOf = {OptionWord{"model", 0}, OptionWord{"part", 1}};
inline constexpr std::array kControl = {OptionWord{"mesh", 0}, OptionWord{"grid", 1},
                                        OptionWord{"cells", 2}, OptionWord{"auto", 3}};
inline constexpr std::array kInterpolation = {OptionWord{"s", 0}, OptionWord{"t", 1},
                                              OptionWord{"o", 2}, OptionWord{"auto", 3},
                                              OptionWord{"linear", 4}};
inline constexpr std::array kBlend = {OptionWord{"linear", 0}, OptionWord{"log", 1}};
inline constexpr std::array kLookup = {OptionWord{"disc", 0}, OptionWord{"vertices", 1}};
inline constexpr std::array kPlacement = {OptionWord{"frontal", 0}, OptionWord{"circumcentre", 1}};
inline constexpr std::array kKernel = {OptionWord{"cavity", 0}, OptionWord{"swap", 1}};
inline constexpr std::array kQuadMethod = {OptionWord{"best", 0}, OptionWord{"frontal", 1}};
inline constexpr std::array kQuadFront = {OptionWord{"lee-lo", 0}, OptionWord{"q-morph", 1},
                                          OptionWord{"mixed", 2}};
inline constexpr std::array kMsh = {OptionWord{"4.1", 0}, OptionWord{"4.1-text", 1},
                                    OptionWord{"2.2", 2}, OptionWord{"2.2-text", 3}};
inline constexpr std::array kPatches = {OptionWord{"auto", 0}, OptionWord{"faces", 1},
                                        OptionWord{"blocks", 2}, OptionWord{"regions", 3}};
inline constexpr std::array kSurface = {OptionWord{"auto", 0}, OptionWord{"limit", 1},
                                        OptionWord{"interpolate", 2}};

}  // namespace words

/// The range of each option, by the name of the option; those of lengths are in sizes/sizing.hh.
namespace ranges {

/// No factor or ratio makes sense anywhere near it.
inline constexpr double kMostFactor = 1e6;
/// Segments of a circle: far more than any mesh needs.
inline constexpr double kMostSegments = 1e5;
/// Sweeps and passes: far more than any mesh needs.
inline constexpr double kMostPasses = 1000;
/// Regular control nodes: far more than sizes that elements can follow ever need in one patch.
inline constexpr double kMostNodes = 4e6;
/// Triangles of a tile: fewer would have more vertices on cuts than inside.
inline constexpr double kLeastTile = 100;
/// Triangles: OpenMesh counts in int.
inline constexpr double kMostElements = 2147483647;

inline constexpr OptionRange kCurvature = {"curvature", words::kOff, 0, kMostFactor, true};
inline constexpr OptionRange kSegmentsPerCircle = {"segments_per_circle", words::kOff, 3,
                                                   kMostSegments};
inline constexpr OptionRange kSharesOf = {"shares_of", words::kSharesOf};
inline constexpr OptionRange kStretch = {"stretch", {}, 1, kMostFactor};
inline constexpr OptionRange kIsotropic = {"isotropic", words::kSwitch};
inline constexpr OptionRange kGrade = {"grade", words::kOff, 1, kMostFactor};
inline constexpr OptionRange kContourCurvature = {"contour_curvature", words::kSwitch};
inline constexpr OptionRange kProximity = {"proximity", words::kOff, 0, kMostFactor, true};
inline constexpr OptionRange kFeatures = {"features", words::kSwitch};
inline constexpr OptionRange kCurvatureFrom = {"curvature_from", words::kCurvatureFrom};
inline constexpr OptionRange kNodes = {"nodes", words::kAuto, 4, kMostNodes, false, true};
inline constexpr OptionRange kPrecision = {"precision", {}, 0, kMostFactor, true};
inline constexpr OptionRange kControl = {"control", words::kControl};
inline constexpr OptionRange kInterpolation = {"interpolation", words::kInterpolation};
inline constexpr OptionRange kEpsilon = {"epsilon", {}, 0, kMostFactor, true};
inline constexpr OptionRange kBlend = {"blend", words::kBlend};
inline constexpr OptionRange kLookup = {"lookup", words::kLookup};
inline constexpr OptionRange kInnerNodes = {"inner_nodes", words::kSwitch};
inline constexpr OptionRange kReuse = {"reuse", words::kOff, 0, kMostFactor, true};
inline constexpr OptionRange kPlacement = {"placement", words::kPlacement};
inline constexpr OptionRange kKernel = {"kernel", words::kKernel};
inline constexpr OptionRange kConformity = {"conformity", words::kConformity, 0, kMostFactor, true};
inline constexpr OptionRange kSmoothing = {"smoothing", words::kSmoothing, 1, kMostPasses, false,
                                           true};
inline constexpr OptionRange kSweeps = {"sweeps", {}, 1, kMostPasses, false, true};
inline constexpr OptionRange kRepairs = {"repairs", words::kOff, 1, kMostPasses, false, true};
inline constexpr OptionRange kPatches = {"patches", words::kPatches};
inline constexpr OptionRange kSurface = {"surface", words::kSurface};
inline constexpr OptionRange kOrient = {"orient", words::kSwitch};
inline constexpr OptionRange kCreaseAngle = {"crease_angle", words::kOff, 0, 180, true};
inline constexpr OptionRange kQuads = {"quads", words::kSwitch};
inline constexpr OptionRange kQuadMethod = {"quad_method", words::kQuadMethod};
inline constexpr OptionRange kQuadFront = {"quad_front", words::kQuadFront};
inline constexpr OptionRange kAcross = {"across", words::kSwitch};
inline constexpr OptionRange kNormals = {"normals", words::kSwitch};
inline constexpr OptionRange kUv = {"uv", words::kSwitch};
inline constexpr OptionRange kTexture = {"texture", words::kSwitch};
inline constexpr OptionRange kMsh = {"msh", words::kMsh};
inline constexpr OptionRange kTile = {"tile", words::kOff, kLeastTile, kMostElements, false, true};
inline constexpr OptionRange kThreads = {"threads", words::kAll, 1, kMostThreads, false, true};
inline constexpr OptionRange kMaxElements = {"max_elements", {}, 1, kMostElements, false, true};

}  // namespace ranges

}  // namespace surfmesh
