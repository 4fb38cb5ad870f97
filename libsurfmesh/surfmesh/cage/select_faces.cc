// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/select_faces.hh"

#include <algorithm>
#include <utility>

namespace surfmesh {
namespace {

bool is_face(int number, const std::vector<int>& stand_ins) {
  return number >= 0 && static_cast<std::size_t>(number) < stand_ins.size();
}

bool is_selected(int face, const std::vector<int>& stand_ins) {
  return stand_ins[static_cast<std::size_t>(face)] == face;
}

}  // namespace

std::vector<int> selected_faces(const std::vector<int>& stand_ins) {
  std::vector<int> faces;
  for (int f = 0; is_face(f, stand_ins); ++f) {
    if (is_selected(f, stand_ins)) faces.push_back(f);
  }
  return faces;
}

Cage select_faces(const Cage& cage, const std::vector<int>& stand_ins) {
  Cage result = cage;
  result.faces.clear();
  std::vector<int> numbers(stand_ins.size(), -1);
  for (const int f : selected_faces(stand_ins)) {
    numbers[static_cast<std::size_t>(f)] = static_cast<int>(result.faces.size());
    result.faces.push_back(cage.faces[static_cast<std::size_t>(f)]);
  }
  result.holes.clear();
  for (const int hole : cage.holes) {
    if (!is_face(hole, stand_ins))
      result.holes.push_back(hole);
    else if (is_selected(hole, stand_ins))
      result.holes.push_back(numbers[static_cast<std::size_t>(hole)]);
  }
  for (Cage::FaceGroup& group : result.groups) {
    std::vector<int> faces;
    for (const int face : group.faces) {
      if (!is_face(face, stand_ins)) {
        faces.push_back(face);
      } else if (const int selected = stand_ins[static_cast<std::size_t>(face)]; selected >= 0) {
        faces.push_back(numbers[static_cast<std::size_t>(selected)]);
      }
    }
    group.faces = std::move(faces);
  }
  return result;
}

}  // namespace surfmesh
