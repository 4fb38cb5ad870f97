// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// What a notice is about.
enum class NoticeKind {
  IgnoredInput,      ///< a part of a file or cage is ignored, left out or mended
  UnjoinedSides,     ///< sides run along each other, or end near each other, unjoined
  TurnedFaces,       ///< faces of a cage pass an edge in the same direction as their neighbours
  OpenSeams,         ///< open edges of a cage lie on others, but have vertices of their own
  RepeatedFaces,     ///< faces of a cage are given more than once
  LostFaces,         ///< faces of a cage vanish where its vertices are welded
  FlatFaces,         ///< faces of a cage have sides without length
  FineCage,          ///< faces of a cage are smaller than the elements asked for
  TurnedLoop,        ///< a loop was given the wrong way round
  NarrowGap,         ///< loops nearly meet
  UnusedContour,     ///< no loop names a contour
  UnusedOption,      ///< an option has no effect
  UnusedSource,      ///< a source of sizes has no effect
  AmbiguousName,     ///< a name means two things
  ChangedNames,      ///< names of patches and groups are others in a file
  SurfaceGap,        ///< surfaces of neighbouring faces do not quite meet
  SurfaceJump,       ///< the formulas of a surface jump inside a patch
  ClampedSizes,      ///< sizes of sources are brought into the bounds
  RoundedPositions,  ///< a file holds fewer digits of positions than its mesh
  CutEdges,          ///< edges are left open, as a half-edge mesh cannot be so
  SplitVertices,     ///< vertices are taken apart, likewise
  FlatTriangles,     ///< triangles of very low quality
  FlatQuads,         ///< quads of a very low scaled Jacobian
  InvertedQuads,     ///< quads that are turned over in the parameters, or concave
  LeftTriangles,     ///< triangles that could not become quads
  CoarseControl,     ///< a control space does not hold its precision
  MissedPrecision,   ///< the control space misses its precision on an independent sample
  UnsearchedSizes,   ///< the search for small sizes in fields ended at its budget
  GivenUp,           ///< refinement was given up
  TurnedTriangles,   ///< triangles against the normal of the surface
  SagNotReached,     ///< mesh and surface are farther apart than asked for
  BrokenPromise,     ///< the mesh is not as the model promises
  HealedShape,       ///< a shape of a CAD file was mended
  LooseFit,          ///< surfaces of a CAD file are farther apart than the usual tolerance
  MergedContours,    ///< contours, or patches, below the tolerance are points, or lines
  ChosenSurface,     ///< which surface a mesh or cage got, and why
  MissedPoints,      ///< a surface does not pass through the points it was to interpolate
  WavySurface,       ///< an interpolating surface turns more than the faces do
  NoisyInput,        ///< faces of a mesh turn to and fro, as those of a scan with noise do
};

/// How many kinds there are.
inline constexpr std::size_t kNoticeKinds = 39;

/// The name of a kind in reports: "ignored_input", "turned_triangles", ...
std::string_view name(NoticeKind kind);

/// How much a notice matters.
enum class Severity {
  Warning,      ///< done as asked, but the user may not have meant it
  Shortfall,    ///< something asked for was not reached; a tool ends with status 3
  Information,  ///< what was decided for the user, and how to decide otherwise
};

/// The name of a severity in reports: "warning", "shortfall", "information".
std::string_view name(Severity severity);

/// Something to tell the user, as text and as data.
struct Notice {
  NoticeKind kind = NoticeKind::IgnoredInput;
  Severity severity = Severity::Warning;
  std::string text;                ///< plain English, with the location and what helps
  int patch = -1;                  ///< the patch it is about, or the first of several; -1 for none
  int contour = -1;                ///< likewise
  std::optional<Vec3> point = {};  ///< in space
  std::size_t count = 1;           ///< how often it came, with the same text or one like it
  /// So many characters at the beginning of the text only say where: "a.json: patch wing: ".
  /// Notices of a kind whose texts are the same after them are told as one.
  std::size_t location_size = 0;

  friend bool operator==(const Notice&, const Notice&) = default;
};

/// In the order in which they came.
using Notices = std::vector<Notice>;

/// @{
/// A notice of this severity.
inline Notice warning(NoticeKind kind, std::string text) {
  return {.kind = kind, .severity = Severity::Warning, .text = std::move(text)};
}
inline Notice information(NoticeKind kind, std::string text) {
  return {.kind = kind, .severity = Severity::Information, .text = std::move(text)};
}
inline Notice shortfall(NoticeKind kind, std::string text) {
  return {.kind = kind, .severity = Severity::Shortfall, .text = std::move(text)};
}
/// @}

/// Put where it is in front of the text of a notice, "a.json", with a colon.
void locate(std::string_view location, Notice& notice);

/// A warning with a location in front: "a.json: the text".
Notice warning_at(std::string_view location, NoticeKind kind, std::string text);

/// A point as written in messages: "(1, 2.5, 0)".
std::string point_text(const Vec3& point);

/// Add notices at the end. One with the kind and text of an earlier one only adds to its count.
void append(Notices more, Notices& notices);

/// True if something asked for was not reached.
bool has_shortfall(const Notices& notices);

/// Lines for a terminal, "warning: text", "not reached: text" or "note: text": the first few of
/// each kind, and how many more there are. What differs only in its location is told once.
std::vector<std::string> lines_of(const Notices& notices);

}  // namespace surfmesh
