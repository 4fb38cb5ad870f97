#!/usr/bin/env bash
# Build the program, mesh a control cage and a formula, and tell where the meshes lie (out/), with
# pages that show them where npm is there to make their script.
set -euo pipefail

if [ $# -gt 0 ]; then
  echo "usage: $0" >&2
  exit 2
fi

cd "$(dirname "${BASH_SOURCE[0]}")/.."
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"

tools/setup.sh
pages=()
if command -v npm >/dev/null && tools/setup.sh --viewer; then
  pages=(knob wave)
fi
cmake --preset release
cmake --build --preset release --target surfmesh_program

mkdir -p out
for model in models/knob.obj models/wave.json; do
  name="$(basename "$model")"
  name="${name%.*}"
  printf '\n%s\n' "$model"
  status=0
  build/release/tools/surfmesh mesh "$model" -o "out/$name.om" --report "out/$name.report.json" ||
    status=$?
  # 3: the mesh is there, but something asked for was not reached, as the program has said.
  if [ "$status" -ne 0 ] && [ "$status" -ne 3 ]; then
    exit "$status"
  fi
done

for name in "${pages[@]}"; do
  build/release/tools/surfmesh view "out/$name.om" -o "out/$name.html" --quiet
done

printf '\nMeshes and reports lie in %s:\n' "$PWD/out"
for name in knob wave; do
  printf '  %s\n' "out/$name.om" "out/$name.report.json"
done
if [ "${#pages[@]}" -gt 0 ]; then
  printf 'Open out/knob.html or out/wave.html in a browser to see them.\n'
else
  printf 'To see them in a browser: tools/setup.sh --viewer, then\n'
  printf '  build/release/tools/surfmesh view out/knob.om -o out/knob.html\n'
fi
