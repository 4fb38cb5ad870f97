// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// Look for points where a field without bounds, such as a C++ function, asks for sizes much
/// smaller than around: below 0.7 of those at the nearest samples on both sides, in some direction.
///
/// 15,001 samples lie on a lattice of equilateral triangles that is tilted against axes and
/// diagonals; neighbours are 0.9 % of the domain apart. From the 16 that are lowest against those
/// beside, without being that low, 20 rounds of four samples each lead downwards. The lowest point
/// in each of 64 × 64 cells is returned.
///
/// What is between the samples and has no slope at them is not found. Share found of 1000 features
/// at random places, whose sizes fall from 0.1 to 0.002 over half their width, by the width as a
/// share of the domain (tests/bench/hidden_sizes_bench.cc):
///
///   width                        0.1 %   0.3 %    1 %
///   bands at any angle            99 %    99 %   100 %
///   rings                        100 %   100 %   100 %
///   spots                          1 %    11 %   100 %
///   spots in the form of a bell   23 %   100 %   100 %
///
/// With as many samples, lines along u and v find 12 % of the spots of 1 %, a jittered grid 57 %,
/// a quasi-random sequence 63 %, and a quadtree that is divided where samples differ 63 %.
///
/// Cost     16,281 evaluations of each such field, and of the surface where the field needs it
/// Throws   InvalidInput if a field is not positive (definite) and finite there, naming (u,v)
std::vector<Uv> find_hidden(const SizeField& field);

}  // namespace surfmesh
