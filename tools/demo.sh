#!/usr/bin/env bash
# Build the program, mesh a control cage and a formula, and tell where the meshes lie (out/).
set -euo pipefail

if [ $# -gt 0 ]; then
  echo "usage: $0" >&2
  exit 2
fi

cd "$(dirname "${BASH_SOURCE[0]}")/.."
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"

tools/setup.sh
cmake --preset release
cmake --build --preset release --target surfmesh_program

mkdir -p out
for model in models/knob.obj models/wave.json; do
  name="$(basename "$model")"
  name="${name%.*}"
  printf '\n%s\n' "$model"
  status=0
  build/release/tools/surfmesh mesh "$model" -o "out/$name.obj" --report "out/$name.report.json" ||
    status=$?
  # 3: the mesh is there, but something asked for was not reached, as the program has said.
  if [ "$status" -ne 0 ] && [ "$status" -ne 3 ]; then
    exit "$status"
  fi
done

printf '\nMeshes and reports lie in %s:\n' "$PWD/out"
for name in knob wave; do
  printf '  %s\n' "out/$name.obj" "out/$name.report.json"
done
