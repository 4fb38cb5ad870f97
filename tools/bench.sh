#!/usr/bin/env bash
# Compare this working tree with an earlier revision, in processor time, memory and bytes written:
#
#   tools/bench.sh --against REV [--runs N] [CASE...]
#
# REV is a commit or tag, such as v1.0.0. Both are built the same way, REV in build/bench-against,
# where it stays for the next time. N pairs of runs (5) are measured, the two first in turn; what is
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

# build SOURCE FOLDER: the program alone. The folder lies in the source as a preset's does, so that
# ccache knows what was built there.
build() {
  (cd "$1" && cmake --preset release -B "build/$2" -DSURFMESH_BUILD_TESTS=OFF \
    -DSURFMESH_BUILD_BENCH=OFF -DSURFMESH_WITH_CAD=OFF -DSURFMESH_WITH_MPI=OFF) >&2
  cmake --build "$1/build/$2" --target surfmesh_program >&2
}

old="build/bench-against/$commit"
if [ ! -d "$old" ]; then
  rm -rf "$old.new"
  mkdir -p "$old.new"
  git archive "$commit" | tar -x -C "$old.new"
  mv "$old.new" "$old"
fi
build "$old" release
build . bench

echo "old: $(git log -1 --format='%h of %cs, %s' "$commit")"
echo "new: $(git describe --always --dirty), with $(nproc) cores and a load of $(cut -d' ' -f1 /proc/loadavg)"
echo
exec /usr/bin/python3 tests/bench/against.py "$old/build/release/tools/surfmesh" \
  build/bench/tools/surfmesh models "${arguments[@]}"
