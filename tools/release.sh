#!/usr/bin/env bash
# Make a release: run all tests but the nightly ones, and make an archive, Debian packages and the
# reference of the public headers in build/package.
# --no-tests leaves the tests out. It needs what `tools/setup.sh --cad --mpi --python --release`
# installs; what is missing of the optional parts has no package.
set -euo pipefail

case "$#:${1-}" in
  0:) has_tests=yes ;;
  1:--no-tests) has_tests= ;;
  *)
    echo "usage: $0 [--no-tests]" >&2
    exit 2
    ;;
esac

cd "$(dirname "${BASH_SOURCE[0]}")/.."
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
if [ -n "$has_tests" ]; then
  tools/test.sh --all
fi

cmake --preset package
cmake --build --preset package
rm -rf build/package/packages
(cd build/package && cpack)
rm -rf build/package/packages/_CPack_Packages
if [ ! -e tools/view/page/dist/viewer.js ]; then
  echo "release: surfmesh view has no script for its pages: run tools/setup.sh --viewer before" >&2
fi
if command -v doxygen >/dev/null; then
  cmake --build --preset package --target reference
else
  echo "release: there is no reference of the headers: doxygen is not installed" >&2
fi
echo "release: made these:"
ls -d "$PWD"/build/package/packages/*.* "$PWD"/build/package/reference/html/index.html
