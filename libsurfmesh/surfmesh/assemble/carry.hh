// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include "surfmesh/assemble/result_places.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace detail {

/// The type of the coordinates of a vector; void for what is none.
template <class Value>
auto coordinate_of() {
  if constexpr (requires { typename Value::Scalar; }) {
    return typename Value::Scalar();
  } else if constexpr (requires { typename Value::value_type; }) {
    return typename Value::value_type();
  }
}

/// Real numbers and vectors of them have means; labels have not.
template <class Value>
constexpr bool has_mean() {
  using Coordinate = decltype(coordinate_of<Value>());
  if constexpr (std::is_floating_point_v<Value>) {
    return true;
  } else if constexpr (std::is_floating_point_v<Coordinate>) {
    return requires(Value & sum, Coordinate weight) { sum += Value(Value(sum - sum) * weight); };
  } else {
    return false;
  }
}

/// The value where there is none: 0 in all coordinates. OpenMesh's vectors leave them unset.
template <class Value>
Value no_value() {
  if constexpr (requires { Value::Zero(); }) {
    return Value::Zero();
  } else if constexpr (requires(Value v) { v.vectorize(v[0]); }) {
    return Value(decltype(coordinate_of<Value>())());
  } else {
    return Value{};
  }
}

template <class Value>
Value scaled(const Value& value, double weight) {
  if constexpr (std::is_floating_point_v<Value>) {
    return static_cast<Value>(weight * static_cast<double>(value));
  } else {
    return value * static_cast<decltype(coordinate_of<Value>())>(weight);
  }
}

/// The mean of values by their weights; of labels, the one that has the greatest weight. `value_at`
/// gives the value of a corner.
template <class Value, class ValueAt>
Value mean_of(const std::vector<double>& weights, const ValueAt& value_at) {
  const auto greatest = std::max_element(weights.begin(), weights.end());
  const auto nearest = static_cast<std::size_t>(greatest - weights.begin());
  if constexpr (has_mean<Value>()) {
    // Equal values keep all their digits: what is added are differences.
    Value sum = value_at(nearest);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (i == nearest || weights[i] == 0) continue;
      sum += scaled<Value>(value_at(i) - value_at(nearest), weights[i]);
    }
    return sum;
  } else {
    return value_at(nearest);
  }
}

}  // namespace detail

/// Carries properties of an OpenMesh mesh to the result of meshing it: of a mesh of any traits,
/// from which cage_from_mesh made the cage of the model.
///
/// Real numbers and vectors of them (OpenMesh's or Eigen's) are linear in triangles, bilinear in
/// quads (see face_weights). Values of any other type, like labels, are those of the nearest
/// corner. What is not on the cage of the mesh has the value Value{}, or 0 in all coordinates.
///
/// Values at corners may differ at a vertex, as texture coordinates do along seams. A corner of the
/// result has those of the face of the mesh on which its own face lies there: a seam stays where a
/// contour runs along it, for instance at creases, at the borders of groups, and where each face is
/// a patch whose contours are not crossed (across off). Elsewhere faces of the result lie across
/// it, and the values of both sides are smeared in them.
template <class Mesh>
class PropertyCarrier {
 public:
  /// All must outlive this. `cage` is that of the mesh, as Patch::cage has it; null if the model
  /// has only one.
  ///
  /// Throws   InvalidInput if the model has no cage, or several and none is given, or the mesh is
  ///          not the one that it was made of; otherwise as ResultPlaces
  PropertyCarrier(const Mesh& mesh, const Model& model, PolyMesh& result,
                  const Cage* cage = nullptr)
      : mesh_(mesh),
        result_(result),
        places_(result, model),
        cage_(cage != nullptr ? cage : only_cage(model)) {
    number_elements();
  }

  /// Carry the vertex property of that name and type to the vertices of the result, where it has
  /// the same name.
  ///
  /// Returns  how many vertices of the result are not on the cage
  /// Cost     0.3 µs a vertex
  /// Throws   MissingProperty, naming it
  template <class Value>
  std::size_t vertices(const std::string& name) {
    OpenMesh::VPropHandleT<Value> from, to;
    find_source(from, name, "vertex");
    if (!result_.get_property_handle(to, name)) result_.add_property(to, name);
    std::size_t missing = 0;
    for (const VertexHandle vh : result_.vertices()) {
      const CageShares shares = places_.of_vertex(vh);
      missing += shares.cage != cage_;
      result_.property(to, vh) = value_of<Value>(shares, [&](std::size_t corner) -> Value {
        return mesh_.property(from, mesh_.to_vertex_handle(corner_handle(corner)));
      });
    }
    return missing;
  }

  /// Carry the halfedge property of that name and type, which has the values of corners at the tips
  /// of halfedges as OpenMesh's texture coordinates have ("h:texcoords2D"), to the corners of the
  /// result.
  ///
  /// Returns  how many corners of the result are not on the cage
  /// Cost     0.4 µs a corner
  /// Throws   MissingProperty, naming it
  template <class Value>
  std::size_t corners(const std::string& name) {
    OpenMesh::HPropHandleT<Value> from, to;
    find_source(from, name, "halfedge");
    if (!result_.get_property_handle(to, name)) result_.add_property(to, name);
    std::size_t missing = 0;
    for (const HalfedgeHandle heh : result_.halfedges()) {
      result_.property(to, heh) = detail::no_value<Value>();
      if (result_.is_boundary(heh)) continue;
      const CageShares shares = places_.of_corner(heh);
      missing += shares.cage != cage_;
      result_.property(to, heh) = value_of<Value>(shares, [&](std::size_t corner) -> Value {
        return mesh_.property(from, corner_handle(corner));
      });
    }
    return missing;
  }

 private:
  static const Cage* only_cage(const Model& model) {
    const Cage* only = nullptr;
    for (const Patch& patch : model.patches) {
      if (patch.cage == nullptr || patch.cage.get() == only) continue;
      if (only != nullptr) {
        throw Error(ErrorCode::InvalidInput,
                    "the model has several cages: tell which one the mesh is");
      }
      only = patch.cage.get();
    }
    if (only == nullptr) throw Error(ErrorCode::InvalidInput, "the model has no cage");
    return only;
  }

  /// Find the corners of the mesh, face by face, as cage_from_mesh does.
  void number_elements() {
    std::vector<int> numbers;
    int count = 0;
    for (const auto vh : mesh_.all_vertices()) {
      const bool is_deleted = mesh_.has_vertex_status() && mesh_.status(vh).deleted();
      numbers.push_back(is_deleted ? -1 : count++);
    }
    for (const auto fh : mesh_.all_faces()) {
      if (mesh_.has_face_status() && mesh_.status(fh).deleted()) continue;
      first_.push_back(corners_.size());
      const std::size_t face = first_.size() - 1;
      for (auto heh = mesh_.cfh_ccwbegin(fh); heh != mesh_.cfh_ccwend(fh); ++heh) {
        check_corner(face, corners_.size() - first_.back(),
                     numbers[index(mesh_.to_vertex_handle(*heh))]);
        corners_.push_back(*heh);
      }
      if (corners_.size() - first_.back() != cage_->faces[face].size()) fail();
    }
    if (first_.size() != cage_->faces.size()) fail();
  }

  void check_corner(std::size_t face, std::size_t corner, int vertex) const {
    if (face >= cage_->faces.size() || corner >= cage_->faces[face].size() ||
        cage_->faces[face][corner] != vertex) {
      fail();
    }
  }

  [[noreturn]] static void fail() {
    throw Error(ErrorCode::InvalidInput, "the mesh is not the one that the cage was made of");
  }

  template <class Property>
  void find_source(Property& property, const std::string& name, const char* element) const {
    if (mesh_.get_property_handle(property, name)) return;
    throw Error(ErrorCode::MissingProperty,
                std::string("the mesh has no ") + element + " property " + name + " of this type");
  }

  OpenMesh::HalfedgeHandle corner_handle(std::size_t corner) const { return corners_[corner]; }

  template <class Value, class ValueAt>
  Value value_of(const CageShares& shares, const ValueAt& value_at) const {
    if (shares.cage != cage_) return detail::no_value<Value>();
    const std::size_t first = first_[static_cast<std::size_t>(shares.face)];
    return detail::mean_of<Value>(shares.weights,
                                  [&](std::size_t i) -> Value { return value_at(first + i); });
  }

  const Mesh& mesh_;
  PolyMesh& result_;
  ResultPlaces places_;
  const Cage* cage_;
  std::vector<OpenMesh::HalfedgeHandle> corners_;  ///< of the mesh, face by face
  std::vector<std::size_t> first_;                 ///< of each face
};

}  // namespace surfmesh
