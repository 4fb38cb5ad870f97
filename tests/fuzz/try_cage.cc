// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <string>

#include "fuzz/byte_reader.hh"
#include "fuzz/checks.hh"
#include "fuzz/targets.hh"
#include "surfmesh/cage/cage_model.hh"

namespace surfmesh::fuzz {
namespace {

/// Larger cages show nothing new and take long.
constexpr std::size_t kMostFacesOfCage = 64;

CageOptions read_options(ByteReader& bytes) {
  CageOptions options;
  constexpr std::array kSchemes = {Scheme::Auto, Scheme::CatmullClark, Scheme::Loop,
                                   Scheme::Bilinear};
  constexpr std::array kKinds = {PatchKind::Auto, PatchKind::Faces, PatchKind::Blocks,
                                 PatchKind::Regions};
  constexpr std::array kSurfaces = {SurfaceKind::Auto, SurfaceKind::Limit,
                                    SurfaceKind::Interpolate};
  options.scheme = bytes.one_of(kSchemes);
  options.patches = bytes.one_of(kKinds);
  options.surface = bytes.one_of(kSurfaces);
  if (bytes.happens(40)) options.weld = Length::share(bytes.real(0, 0.1));
  if (bytes.happens(40)) options.orient = true;
  if (bytes.happens(40)) options.crease_angle = bytes.real(0, 180);
  if (bytes.happens(40)) options.fit = Length::share(bytes.real(0, 0.1));
  return options;
}

}  // namespace

bool try_cage(Bytes input) {
  ByteReader bytes(input);
  const auto formats = formats_that([](const MeshFormat& f) { return f.parse_cage != nullptr; });
  const MeshFormat& format = *bytes.one_of(formats);
  const CageOptions options = read_options(bytes);
  const std::string text = bytes.rest();
  return accepts([&] {
    const Cage cage = format.parse_cage(text, std::string("cage").append(format.ending));
    check_ranges(cage);
    if (cage.faces.size() > kMostFacesOfCage) return;
    check_usable(model_from_cage(cage, options));
  });
}

}  // namespace surfmesh::fuzz
