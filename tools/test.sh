#!/usr/bin/env bash
# Build everything but the benchmarks in build/release, and run the tests. Exit status 0 if all of them
# pass.
# --all adds those that take long: random models, faults from outside, and small stages under the address
# and undefined-behaviour sanitizers. It also installs the programs by which written files are judged,
# OpenCASCADE, by which CAD files are read, Open MPI and METIS, what the Python module takes, Doxygen, and
# the script of the pages that `surfmesh view` writes. It is meant to take 45 minutes at most on two
# cores; --nightly adds the rest: more sanitizers, fuzzing by clang, the library as part of another
# project, each public header alone, packages in a clean root; and it builds the benchmarks.
set -euo pipefail

tests=release
setup=()
targets=(all)
case "$#:${1-}" in
  0:) ;;
  1:--all | 1:--nightly)
    tests=${1#--}
    setup=(--readers --cad --mpi --python --reference)
    if [ "$tests" = nightly ]; then
      setup+=(--fuzz --release)
      targets+=(surfmesh_benches)
    fi
    ;;
  *)
    echo "usage: $0 [--all | --nightly]" >&2
    exit 2
    ;;
esac

cd "$(dirname "${BASH_SOURCE[0]}")/.."
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
export CTEST_PARALLEL_LEVEL="${CTEST_PARALLEL_LEVEL:-$CMAKE_BUILD_PARALLEL_LEVEL}"

tools/setup.sh "${setup[@]}"
if [ "${#setup[@]}" -gt 0 ]; then
  tools/setup.sh --viewer || echo "test: there are no pages for browsers, their tests are skipped" >&2
fi
# What is built from nothing is built faster in joined files; a build that is there stays as it is.
joined=()
if [ ! -f build/release/CMakeCache.txt ]; then
  joined=(-D SURFMESH_UNITY_BUILD=ON)
fi
cmake --preset release "${joined[@]}"
cmake --build --preset release --target "${targets[@]}"
exec ctest --preset "$tests"
