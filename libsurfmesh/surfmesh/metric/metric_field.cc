// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

QueryCounts& QueryCounts::operator+=(const QueryCounts& other) {
  single += other.single;
  triangle += other.triangle;
  circles += other.circles;
  linear += other.linear;
  lattice += other.lattice;
  extended += other.extended;
  reused += other.reused;
  walks += other.walks;
  steps += other.steps;
  return *this;
}

}  // namespace surfmesh
