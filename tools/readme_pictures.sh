#!/usr/bin/env bash
# Make the pictures of libsurfmesh/pictures again, by surfmesh mesh and surfmesh picture: some
# seconds. The commands are those of libsurfmesh/GALLERY.md, in its order; models lie in models/.
# Those of CAD files are left as they are where surfmesh cannot read them.
set -euo pipefail

if [ $# -gt 0 ]; then
  echo "usage: $0" >&2
  exit 2
fi

cd "$(dirname "${BASH_SOURCE[0]}")/.."
source="$PWD"
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
cmake --preset release >&2
cmake --build --preset release --target surfmesh_program >&2
PATH="$source/build/release/tools:$PATH"

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$source/models" models

# The lines of the code blocks that call the program.
mapfile -t commands < <(awk '/^```/ { is_code = !is_code } is_code && /^surfmesh /' \
  "$source/libsurfmesh/GALLERY.md")
reads_cad=$(surfmesh --version | sed -n 2p)
for command in "${commands[@]}"; do
  words=${command%%#*}
  if [ -z "$reads_cad" ] && [[ "$words" == *part* ]]; then
    echo "left out, surfmesh reads no CAD files: $words" >&2
    continue
  fi
  echo "$words" >&2
  eval "$words" >/dev/null
done
for picture in *.png *.svg; do
  [ -e "$picture" ] && mv "$picture" "$source/libsurfmesh/pictures/"
done
