// SPDX-License-Identifier: BSD-3-Clause
// What libFuzzer calls, for the target SURFMESH_FUZZ_TARGET.
#include <cstdio>
#include <cstdlib>

#include "fuzz/targets.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    surfmesh::fuzz::SURFMESH_FUZZ_TARGET({bytes, size});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "FINDING: %s\n", error.what());
    std::abort();
  }
  return 0;
}
