// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "surfmesh/core/interval.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// Evaluations of bounds that a search may spend on one patch: about 50 ms.
inline constexpr std::size_t kSearchBudget = 100'000;

/// Finds small sizes that samples of a patch's fields miss, however small the area is in which they
/// are asked for. It needs fields with bounds, such as formulas; find_hidden
/// (sizes/hidden_sizes.hh) looks into the others.
///
/// It counts what it spends and belongs to one thread.
class FieldSearch {
 public:
  /// The field must outlive the search.
  explicit FieldSearch(const SizeField& field, std::size_t budget = kSearchBudget);

  /// Find a point of a box where a field asks for a least length below `size`.
  ///
  /// The box is divided where bounds leave room for such a length, first where they leave most. A
  /// part below 0.1 % of the domain in both directions is not searched completely: the half with
  /// the lower bound is followed for ten halvings, in the 32 parts with the lowest bounds. So
  /// features of 0.1 % are found, and smaller ones with bounds as tight as those of formulas in
  /// which u and v occur once. Positions in space are those of samples: least_length_in
  /// (sizes/field_size.hh).
  ///
  /// Beyond the diagonal of a triangular domain nothing is found. Sizes are clamped afterwards, so
  /// none is below hmin.
  ///
  /// Cost     one evaluation of bounds for each field, if they leave no room
  /// Throws   InvalidInput if a field is not positive (definite) and finite at a point that is
  ///          looked at, naming (u,v)
  std::optional<Uv> find_smaller(const UvBox& box, double size);

  /// True if the budget is spent. Nothing is found from then on.
  bool is_exhausted() const { return evaluations_ >= budget_; }

  /// Evaluations of bounds so far, of all fields.
  std::size_t evaluations() const { return evaluations_; }

 private:
  /// A part of the box, and a bound of the least length in it.
  struct Part {
    UvBox box;
    double bound;
  };

  std::optional<Uv> search(const FieldSource& field, const UvBox& box, double size);
  std::optional<Uv> follow(const FieldSource& field, Part part, double size);
  std::vector<Part> parts_below(const FieldSource& field, const UvBox& box, double size);
  Part bounded(const FieldSource& field, const UvBox& box);
  std::array<UvBox, 2> halves(const UvBox& box) const;
  bool is_small(const UvBox& box) const;
  bool is_beyond(Uv uv) const;
  Uv inner_point(const UvBox& box) const;

  const SizeField& field_;
  Domain domain_;
  std::size_t budget_;
  std::size_t evaluations_ = 0;
};

}  // namespace surfmesh
