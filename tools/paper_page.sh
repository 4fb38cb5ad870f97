#!/usr/bin/env bash
# Make the tables and pictures of libsurfmesh/PAPER.md again, by surfmesh-paper and compare.sh: ten
# minutes, on a machine without other work. What stands between "begin NAME" and "end NAME" in the
# page is replaced. --rounds N (3): runs of each program in the comparison.
set -euo pipefail

rounds=3
case "$#:${1-}" in
  0:) ;;
  2:--rounds) rounds=$2 ;;
  *)
    echo "usage: $0 [--rounds N]" >&2
    exit 2
    ;;
esac

cd "$(dirname "${BASH_SOURCE[0]}")/.."
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
cmake --preset release >&2
cmake --build --preset release --target surfmesh_paper >&2

tools/compare.sh -o out/compare --rounds "$rounds" --only plane --only cages
build/release/tools/paper/surfmesh-paper -o out/paper

page=libsurfmesh/PAPER.md
pictures=libsurfmesh/pictures/paper
mkdir -p "$pictures"
cp out/paper/figure*.svg out/compare/compare_*.svg "$pictures"

# Without its own heading, and without the commands, which name folders of this machine.
sed -e '1,2d' -e '/^## Commands/,$d' -e 's/^## /### /' out/compare/compare.md >out/compare/part.md

# replace NAME FILE: put a file between the marks of a name.
replace() {
  local mark
  for mark in "<!-- begin $1 -->" "<!-- end $1 -->"; do
    grep -qxF -- "$mark" "$page" || { echo "$page has no line '$mark'" >&2; exit 1; }
  done
  [ -s "$2" ] || { echo "$2 is empty" >&2; exit 1; }
  awk -v name="$1" -v file="$2" '
    $0 == "<!-- end " name " -->" { skips = 0 }
    !skips { print }
    $0 == "<!-- begin " name " -->" {
      print ""
      while ((getline line < file) > 0) print line
      skips = 1
    }' "$page" >out/page.md
  cat out/page.md >"$page"
}
replace tables out/paper/tables.md
replace comparison out/compare/part.md
