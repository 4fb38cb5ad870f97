#!/usr/bin/env bash
# Compare this working tree with an earlier revision, in processor time, memory and bytes written:
#
#   tools/bench.sh --against REV [--runs N] [CASE...]
#
# REV is a commit or tag, such as v1.0.0. Both are built the same way, in build/bench-against, where
# REV stays for the next time. N pairs of runs (5) are measured, the two first in turn; what is
# printed, and which cases there are, tests/bench/against.py tells. Exit status 2 if there is no REV.
set -euo pipefail

usage() {
  echo "usage: $0 --against REV [--runs N] [CASE...]" >&2
  exit 2
}

revision=
arguments=()
while [ $# -gt 0 ]; do
  case "$1" in
    --against)
      [ -n "${2-}" ] || usage
      revision=$2
      shift 2
      ;;
    --runs)
      [[ ${2-} =~ ^[1-9][0-9]{0,2}$ ]] || usage
      arguments+=(--runs "$2")
      shift 2
      ;;
    -*) usage ;;
    *)
      arguments+=("$1")
      shift
      ;;
  esac
done
[ -n "$revision" ] || usage

cd "$(dirname "${BASH_SOURCE[0]}")/.."
if ! commit=$(git rev-parse --verify --quiet --end-of-options "$revision^{commit}"); then
  echo "bench: there is no revision $revision" >&2
  exit 2
fi

export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"

# build SOURCE BUILD: the program alone.
build() {
  cmake -S "$1" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSURFMESH_BUILD_TESTS=OFF \
    -DSURFMESH_BUILD_BENCH=OFF -DSURFMESH_WITH_CAD=OFF -DSURFMESH_WITH_MPI=OFF >&2
  cmake --build "$2" --target surfmesh_program >&2
}

folder=build/bench-against
if [ ! -d "$folder/$commit/source" ]; then
  rm -rf "$folder/$commit/unpacked"
  mkdir -p "$folder/$commit/unpacked"
  git archive "$commit" | tar -x -C "$folder/$commit/unpacked"
  mv "$folder/$commit/unpacked" "$folder/$commit/source"
fi
build "$folder/$commit/source" "$folder/$commit/build"
build . "$folder/new"

echo "old: $(git log -1 --format='%h of %cs, %s' "$commit")"
echo "new: $(git describe --always --dirty), with $(nproc) cores and a load of $(cut -d' ' -f1 /proc/loadavg)"
echo
exec /usr/bin/python3 tests/bench/against.py "$folder/$commit/build/tools/surfmesh" \
  "$folder/new/tools/surfmesh" models "${arguments[@]}"
