// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/faces_of_cage.hh"

#include "surfmesh/cage/face_weights.hh"

namespace surfmesh {

std::vector<FaceOfCage> faces_of_cage(const Cage& cage, const MendedCage& mended,
                                      const RefinedCage& regular) {
  std::vector<char> is_turned(cage.faces.size(), 0);
  for (std::size_t f = 0; f < mended.parent_faces.size(); ++f) {
    is_turned[static_cast<std::size_t>(mended.parent_faces[f])] = mended.is_turned[f];
  }
  std::vector<FaceOfCage> faces;
  faces.reserve(regular.parent_faces.size());
  for (std::size_t f = 0; f < regular.parent_faces.size(); ++f) {
    const QuarterOfFace& quarter = regular.quarters[f];
    FaceOfCage face{regular.parent_faces[f], -1, quarter.corners, quarter.rotation, false};
    face.is_turned = is_turned[static_cast<std::size_t>(face.face)] != 0;
    if (quarter.part >= 0) {
      // A face that is turned keeps its first corner.
      const int part =
          face.is_turned ? (quarter.corners - quarter.part) % quarter.corners : quarter.part;
      face.part = kept_corners(cage, face.face, quarter.corners)[static_cast<std::size_t>(part)];
    }
    faces.push_back(face);
  }
  return faces;
}

}  // namespace surfmesh
