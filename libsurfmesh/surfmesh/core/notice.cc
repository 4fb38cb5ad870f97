// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/notice.hh"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace surfmesh {
namespace {

/// Of each kind so many stand in a terminal: enough to see what they have in common.
constexpr std::size_t kMostLines = 3;

std::string_view front_of(Severity severity) {
  switch (severity) {
    case Severity::Warning:
      return "warning";
    case Severity::Shortfall:
      return "not reached";
    case Severity::Information:
      return "note";
  }
  return "unknown";
}

std::string line_of(const Notice& notice) {
  const std::string_view front = front_of(notice.severity);
  const std::string more =
      notice.count > 1 ? fmt::format(" (and {} more)", notice.count - 1) : std::string();
  return fmt::format("{}: {}{}", front, notice.text, more);
}

/// What a notice says without the location before it: "the loop is turned" of "patch a: the loop is
/// turned".
std::string_view without_location(const Notice& notice) {
  return std::string_view(notice.text).substr(std::min(notice.location_size, notice.text.size()));
}

/// Of notices that differ only in the location the first, counting the others.
Notices with_alike_counted(const Notices& notices) {
  Notices result;
  std::map<std::tuple<NoticeKind, Severity, std::string_view>, std::size_t> index_of;
  for (const Notice& notice : notices) {
    const std::tuple key(notice.kind, notice.severity, without_location(notice));
    const auto [found, is_new] = index_of.emplace(key, result.size());
    if (is_new) {
      result.push_back(notice);
    } else {
      result[found->second].count += notice.count;
    }
  }
  return result;
}

}  // namespace

std::string_view name(NoticeKind kind) {
  switch (kind) {
    case NoticeKind::IgnoredInput:
      return "ignored_input";
    case NoticeKind::UnjoinedSides:
      return "unjoined_sides";
    case NoticeKind::TurnedFaces:
      return "turned_faces";
    case NoticeKind::OpenSeams:
      return "open_seams";
    case NoticeKind::RepeatedFaces:
      return "repeated_faces";
    case NoticeKind::LostFaces:
      return "lost_faces";
    case NoticeKind::FlatFaces:
      return "flat_faces";
    case NoticeKind::FineCage:
      return "fine_cage";
    case NoticeKind::TurnedLoop:
      return "turned_loop";
    case NoticeKind::NarrowGap:
      return "narrow_gap";
    case NoticeKind::UnusedContour:
      return "unused_contour";
    case NoticeKind::UnusedOption:
      return "unused_option";
    case NoticeKind::UnusedSource:
      return "unused_source";
    case NoticeKind::AmbiguousName:
      return "ambiguous_name";
    case NoticeKind::ChangedNames:
      return "changed_names";
    case NoticeKind::SurfaceGap:
      return "surface_gap";
    case NoticeKind::SurfaceJump:
      return "surface_jump";
    case NoticeKind::ClampedSizes:
      return "clamped_sizes";
    case NoticeKind::RoundedPositions:
      return "rounded_positions";
    case NoticeKind::CutEdges:
      return "cut_edges";
    case NoticeKind::SplitVertices:
      return "split_vertices";
    case NoticeKind::FlatTriangles:
      return "flat_triangles";
    case NoticeKind::FlatQuads:
      return "flat_quads";
    case NoticeKind::InvertedQuads:
      return "inverted_quads";
    case NoticeKind::LeftTriangles:
      return "left_triangles";
    case NoticeKind::CoarseControl:
      return "coarse_control";
    case NoticeKind::MissedPrecision:
      return "missed_precision";
    case NoticeKind::UnsearchedSizes:
      return "unsearched_sizes";
    case NoticeKind::GivenUp:
      return "given_up";
    case NoticeKind::TurnedTriangles:
      return "turned_triangles";
    case NoticeKind::SagNotReached:
      return "sag_not_reached";
    case NoticeKind::BrokenPromise:
      return "broken_promise";
    case NoticeKind::HealedShape:
      return "healed_shape";
    case NoticeKind::LooseFit:
      return "loose_fit";
    case NoticeKind::MergedContours:
      return "merged_contours";
    case NoticeKind::ChosenSurface:
      return "chosen_surface";
    case NoticeKind::MissedPoints:
      return "missed_points";
    case NoticeKind::WavySurface:
      return "wavy_surface";
    case NoticeKind::NoisyInput:
      return "noisy_input";
  }
  return "unknown";
}

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::Warning:
      return "warning";
    case Severity::Shortfall:
      return "shortfall";
    case Severity::Information:
      return "information";
  }
  return "unknown";
}

void locate(std::string_view location, Notice& notice) {
  const std::string front = fmt::format("{}: ", location);
  notice.text.insert(0, front);
  notice.location_size += front.size();
}

Notice warning_at(std::string_view location, NoticeKind kind, std::string text) {
  Notice notice = warning(kind, std::move(text));
  locate(location, notice);
  return notice;
}

std::string point_text(const Vec3& point) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", point.x(), point.y(), point.z());
}

void append(Notices more, Notices& notices) {
  std::map<std::pair<NoticeKind, std::string>, std::size_t> known;
  for (std::size_t i = 0; i < notices.size(); ++i) {
    known.emplace(std::pair(notices[i].kind, notices[i].text), i);
  }
  for (Notice& notice : more) {
    const auto [found, is_new] = known.emplace(std::pair(notice.kind, notice.text), notices.size());
    if (is_new) {
      notices.push_back(std::move(notice));
    } else {
      notices[found->second].count += notice.count;
    }
  }
}

bool has_shortfall(const Notices& notices) {
  return std::any_of(notices.begin(), notices.end(),
                     [](const Notice& notice) { return notice.severity == Severity::Shortfall; });
}

std::vector<std::string> lines_of(const Notices& every) {
  const Notices notices = with_alike_counted(every);
  std::map<NoticeKind, std::size_t> notices_of, times_of, shown;
  for (const Notice& notice : notices) {
    ++notices_of[notice.kind];
    times_of[notice.kind] += notice.count;
  }
  std::vector<std::string> lines;
  for (const Notice& notice : notices) {
    const bool is_cut = notices_of[notice.kind] > kMostLines + 1;
    const std::size_t number = ++shown[notice.kind];
    if (is_cut && number > kMostLines) continue;
    lines.push_back(line_of(notice));
    times_of[notice.kind] -= notice.count;
    if (is_cut && number == kMostLines) {
      lines.back() += fmt::format("; and {} more like these", times_of[notice.kind]);
    }
  }
  return lines;
}

}  // namespace surfmesh
