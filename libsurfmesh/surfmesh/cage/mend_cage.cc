// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/mend_cage.hh"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "surfmesh/cage/cage_copies.hh"
#include "surfmesh/cage/open_seams.hh"
#include "surfmesh/cage/select_faces.hh"
#include "surfmesh/cage/turned_faces.hh"
#include "surfmesh/cage/weld_cage.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// A side is without length below this share of the diagonal: coordinates of 16 digits, after some
/// arithmetic.
constexpr double kNoLength = 1e-12;

/// The tolerance that is advised for a gap is a little larger, to survive its rounding in print.
constexpr double kAdvisedTolerance = 1.2;

/// "1 face", "3 faces".
std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

class Mender {
 public:
  Mender(const Cage& cage, const MendOptions& options)
      : original_(cage), options_(options), diagonal_(diagonal(cage)) {
    result_.cage = cage;
    result_.stand_ins.resize(cage.faces.size());
    std::iota(result_.stand_ins.begin(), result_.stand_ins.end(), 0);
  }

  MendedCage run() {
    if (options_.weld > 0) weld_vertices();
    leave_out_copies();
    if (!tell_open_seams()) tell_doubled_faces();
    tell_flat_faces();
    tell_or_turn_faces();
    result_.parent_faces = selected_faces(result_.stand_ins);
    for (const int f : result_.parent_faces) {
      result_.is_turned.push_back(is_turned_.empty() ? char{0}
                                                     : is_turned_[static_cast<std::size_t>(f)]);
    }
    if (result_.parent_faces.size() < faces().size()) {
      result_.cage = select_faces(result_.cage, result_.stand_ins);
    }
    return std::move(result_);
  }

 private:
  std::vector<std::vector<int>>& faces() { return result_.cage.faces; }
  std::vector<int>& face(int f) { return faces()[static_cast<std::size_t>(f)]; }
  const Vec3& point(int vertex) const {
    return result_.cage.points[static_cast<std::size_t>(vertex)];
  }

  Vec3 middle_of(const std::vector<int>& corners) const {
    Vec3 sum = Vec3::Zero();
    for (const int vertex : corners) sum += point(vertex);
    return sum / static_cast<double>(corners.size());
  }

  Vec3 middle_of(int f) { return middle_of(face(f)); }

  /// Of a face before vertices were welded.
  Vec3 middle_of_original(int f) const {
    return middle_of(original_.faces[static_cast<std::size_t>(f)]);
  }

  void tell(NoticeKind kind, const Vec3& at, std::string text) {
    Notice notice = warning(kind, std::move(text));
    notice.point = at;
    result_.notices.push_back(std::move(notice));
  }

  void weld_vertices() {
    const auto stand_ins = coincident_vertices(result_.cage, options_.weld);
    const WeldReport report = weld(result_.cage, stand_ins);
    for (const int f : report.collapsed) result_.stand_ins[static_cast<std::size_t>(f)] = -1;
    if (report.vertices.empty()) return;
    if (report.collapsed.size() == faces().size()) {
      throw Error(ErrorCode::InvalidOption,
                  fmt::format("{} = {} leaves no face of the cage (its diagonal is {:.3g})",
                              ranges::kWeld.name, options_.weld, diagonal_));
    }
    const Vec3& at = point(report.onto[0]);
    tell(NoticeKind::IgnoredInput, at,
         fmt::format("welded {} onto others, the first: vertex {} onto vertex {} at {}",
                     counted(report.vertices.size(), "vertex", "vertices"), report.vertices[0],
                     report.onto[0], point_text(at)));
    if (!report.collapsed.empty()) tell_collapsed(report.collapsed);
  }

  void tell_collapsed(const std::vector<int>& collapsed) {
    const Vec3 at = middle_of_original(collapsed[0]);
    tell(NoticeKind::LostFaces, at,
         fmt::format("{} = {:.3g} leaves out {} of {} faces, which have no area then, the first: "
                     "face {} at {}; the diagonal of the cage is {:.3g}",
                     ranges::kWeld.name, options_.weld, collapsed.size(), faces().size(),
                     collapsed[0], point_text(at), diagonal_));
  }

  void leave_out_copies() {
    const std::vector<int> kept = find_copies(result_.cage);
    std::size_t count = 0;
    int first = -1;
    for (int f = 0; static_cast<std::size_t>(f) < kept.size(); ++f) {
      if (kept[static_cast<std::size_t>(f)] == f) continue;
      if (count++ == 0) first = f;
      result_.stand_ins[static_cast<std::size_t>(f)] = kept[static_cast<std::size_t>(f)];
    }
    if (count == 0) return;
    const Vec3 at = middle_of(first);
    tell(NoticeKind::RepeatedFaces, at,
         fmt::format("left out {} given again, the first: face {}, the same as face {} at {}{}",
                     counted(count, "face", "faces"), first, kept[static_cast<std::size_t>(first)],
                     point_text(at), text_of_lost_holes(kept)));
    for (std::size_t f = 0; f < kept.size(); ++f) {
      if (kept[f] != static_cast<int>(f)) faces()[f].clear();
    }
  }

  /// What is said of holes in whose place surfaces are kept.
  std::string text_of_lost_holes(const std::vector<int>& kept) const {
    const std::set<int> holes(result_.cage.holes.begin(), result_.cage.holes.end());
    std::size_t count = 0;
    int first = -1;
    for (const int hole : holes) {
      if (hole < 0 || static_cast<std::size_t>(hole) >= kept.size()) continue;
      if (holes.contains(kept[static_cast<std::size_t>(hole)])) continue;
      if (count++ == 0) first = hole;
    }
    if (count == 0) return {};
    return fmt::format("; {} where the surface is kept, the first: face {}",
                       counted(count, "is a hole", "are holes"), first);
  }

  /// Returns  true if there are some
  bool tell_open_seams() {
    const double tolerance = ranges::kWeld.on * diagonal_;
    const OpenSeams seams = find_open_seams(result_.cage, tolerance);
    if (seams.edges == 0) return false;
    const Vec3 at = 0.5 * (point(seams.first[0]) + point(seams.first[1]));
    tell(NoticeKind::OpenSeams, at,
         fmt::format("{} on others, but with vertices of their own, the first: edge {}-{} at {}; "
                     "the surface is open there, {}",
                     counted(seams.edges, "open edge lies", "open edges lie"), seams.first[0],
                     seams.first[1], point_text(at), advice_for(seams.gap)));
    return true;
  }

  /// What joins seams of a gap; it is tried first.
  std::string advice_for(double gap) const {
    const double on = ranges::kWeld.on * diagonal_;
    const std::string printed = fmt::format("{:.2g}", kAdvisedTolerance * gap);
    const double tolerance = gap <= on ? on : std::stod(printed);
    const std::vector<int> stand_ins = coincident_vertices(result_.cage, tolerance);
    if (loses_sides(stand_ins)) {
      return fmt::format("by up to {:.2g}; a --weld that joins them joins ends of sides, too", gap);
    }
    Cage welded = result_.cage;
    weld(welded, stand_ins);
    if (find_open_seams(welded, on).edges > 0) {
      return fmt::format("by up to {:.2g}; --weld {} does not join them all", gap, printed);
    }
    return gap <= on ? "--weld joins them" : fmt::format("--weld {} joins them", printed);
  }

  /// True if welding makes points of sides that have a length.
  bool loses_sides(const std::vector<int>& stand_ins) const {
    const auto is_lost = [&](int a, int b) {
      return stand_ins[static_cast<std::size_t>(a)] == stand_ins[static_cast<std::size_t>(b)] &&
             (point(a) - point(b)).norm() > kNoLength * diagonal_;
    };
    return std::any_of(result_.cage.faces.begin(), result_.cage.faces.end(),
                       [&](const std::vector<int>& face) {
                         for (std::size_t i = 0; i < face.size(); ++i) {
                           if (is_lost(face[i], face[(i + 1) % face.size()])) return true;
                         }
                         return false;
                       });
  }

  /// The end of a sentence about what --weld by itself does, empty if it would do harm.
  std::string advice_to_weld(const std::vector<int>& stand_ins, const char* what) const {
    return loses_sides(stand_ins) ? std::string() : fmt::format("; --weld {}", what);
  }

  /// Faces that would be copies if vertices were welded: of closed surfaces that are given twice.
  void tell_doubled_faces() {
    const auto stand_ins = coincident_vertices(result_.cage, ranges::kWeld.on * diagonal_);
    Cage welded = result_.cage;
    if (weld(welded, stand_ins).vertices.empty()) return;
    const std::vector<int> kept = find_copies(welded);
    std::size_t count = 0;
    int first = -1;
    for (int f = 0; static_cast<std::size_t>(f) < kept.size(); ++f) {
      if (kept[static_cast<std::size_t>(f)] != f && count++ == 0) first = f;
    }
    if (count == 0) return;
    const Vec3 at = middle_of(first);
    tell(NoticeKind::RepeatedFaces, at,
         fmt::format("{} on others, but with vertices of their own, the first: face {} on face {} "
                     "at {}{}",
                     counted(count, "face lies", "faces lie"), first,
                     kept[static_cast<std::size_t>(first)], point_text(at),
                     advice_to_weld(stand_ins, "leaves them out")));
  }

  bool is_flat(const std::vector<int>& face) const {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i], b = face[(i + 1) % face.size()];
      if (a != b && (point(a) - point(b)).norm() <= kNoLength * diagonal_) return true;
    }
    return false;
  }

  void tell_flat_faces() {
    const auto flat = [this](const std::vector<int>& face) { return is_flat(face); };
    const auto first = std::find_if(faces().begin(), faces().end(), flat);
    if (first == faces().end()) return;
    const int f = static_cast<int>(first - faces().begin());
    const Vec3 at = middle_of(f);
    const auto stand_ins = coincident_vertices(result_.cage, ranges::kWeld.on * diagonal_);
    const auto count = static_cast<std::size_t>(std::count_if(first, faces().end(), flat));
    tell(NoticeKind::FlatFaces, at,
         fmt::format("{} sides between vertices in the same place, the first: face {} at {}{}",
                     counted(count, "face has", "faces have"), f, point_text(at),
                     advice_to_weld(stand_ins, "removes these sides")));
  }

  void tell_or_turn_faces() {
    const std::vector<char> is_turned = turned_faces(faces());
    const auto first = std::find(is_turned.begin(), is_turned.end(), 1);
    if (first == is_turned.end()) return;
    const int f = static_cast<int>(first - is_turned.begin());
    const Vec3 at = middle_of(f);
    const std::string where = fmt::format("the first: face {} at {}", f, point_text(at));
    const auto count = static_cast<std::size_t>(std::count(first, is_turned.end(), 1));
    if (options_.orient) {
      for (std::size_t i = 0; i < is_turned.size(); ++i) {
        if (is_turned[i]) std::reverse(faces()[i].begin() + 1, faces()[i].end());
      }
      is_turned_ = is_turned;
      tell(NoticeKind::IgnoredInput, at,
           fmt::format("turned {} to agree with {} neighbours, {}", counted(count, "face", "faces"),
                       count == 1 ? "its" : "their", where));
    } else {
      tell(NoticeKind::TurnedFaces, at,
           fmt::format(
               "{} turned against {} neighbours, {}; the surface has creases there, --orient "
               "turns back what is turned",
               counted(count, "face is", "faces are"), count == 1 ? "its" : "their", where));
    }
  }

  const Cage& original_;
  MendOptions options_;
  double diagonal_;
  std::vector<char> is_turned_;  ///< by face of the original; empty if none was
  MendedCage result_;
};

}  // namespace

MendedCage mend_cage(const Cage& cage, const MendOptions& options) {
  check_ranges(cage);
  if (options.weld != 0) check_option(ranges::kWeld, Length::units(options.weld));
  return Mender(cage, options).run();
}

}  // namespace surfmesh
