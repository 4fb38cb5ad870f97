#!/usr/bin/env bash
# Build everything in build/release and run all tests. Exit status 0 if all of them pass.
set -euo pipefail

if [ $# -gt 0 ]; then
  echo "usage: $0" >&2
  exit 2
fi

cd "$(dirname "${BASH_SOURCE[0]}")/.."
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
export CTEST_PARALLEL_LEVEL="${CTEST_PARALLEL_LEVEL:-$CMAKE_BUILD_PARALLEL_LEVEL}"

tools/setup.sh
cmake --preset release
cmake --build --preset release
exec ctest --preset release
