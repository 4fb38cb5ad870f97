#!/usr/bin/env bash
# Compare surfmesh with Gmsh, BAMG (ffbamg of Debian's freefem++), Mmg2d and Mmgs: those of them
# that are in PATH, nothing is installed. Results in DIR (out/compare): compare.md, compare.json,
# and the charts compare_speed.svg and compare_quality.svg.
# --rounds N (3): how often each tool runs. --quick leaves out the mesh of a million triangles, and
# all but the smallest inputs of remeshing.
# --only PART: plane, cages or remeshing; may be given again for another part.
#
# Remeshing has two more tools, programs of your own around libraries, if they are in PATH:
#   pmp_remesh INPUT.off OUTPUT.off LENGTH ANGLE     pmp::uniform_remeshing
#   cgal_remesh INPUT.off OUTPUT.off LENGTH ANGLE    CGAL's isotropic_remeshing
# with sides of LENGTH in 10 iterations; edges at which faces meet at more than ANGLE degrees are
# kept. With --version alone they print the version of the library.
set -euo pipefail

usage() {
  echo "usage: $0 [-o DIR] [--rounds N] [--quick] [--only PART]..." >&2
  exit 2
}

source="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
output="$source/out/compare"
arguments=()
while [ $# -gt 0 ]; do
  case "$1" in
    -o)
      [ $# -ge 2 ] && [ -n "$2" ] || usage
      output=$2
      shift 2
      ;;
    --rounds)
      [[ ${2-} =~ ^[1-9][0-9]?$ ]] || usage
      arguments+=(--rounds "$2")
      shift 2
      ;;
    --quick)
      arguments+=(--quick)
      shift
      ;;
    --only)
      [[ ${2-} =~ ^(plane|cages|remeshing)$ ]] || usage
      arguments+=(--only "$2")
      shift 2
      ;;
    *) usage ;;
  esac
done

# As given from where the script was started.
mkdir -p -- "$output"
output="$(cd -- "$output" && pwd)"

cd "$source"
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
if [ ! -f build/release/build.ninja ]; then
  cmake --preset release >&2
fi
cmake --build --preset release --target surfmesh_compare surfmesh_program >&2

exec build/release/tools/compare/surfmesh_compare --source "$source" \
  --program build/release/tools/surfmesh -o "$output" "${arguments[@]}"
