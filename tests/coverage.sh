#!/usr/bin/env bash
# Which lines of libsurfmesh the tests run: builds with counters in build/coverage, runs the tests and
# prints lines and branches by folder, and the files that are covered least. Exit status 1 if fewer
# lines than LEAST are covered. A page for each file is in build/coverage/report.
#
#   tests/coverage.sh               the test programs of all stages
#   tests/coverage.sh quad metric   those of some; the counters of earlier runs stay
#   tests/coverage.sh --again       only print, from the counters that are there
set -euo pipefail

readonly LEAST=93  # percent of the lines

cd "$(dirname "${BASH_SOURCE[0]}")/.."
for program in gcovr cmake; do
  if ! command -v "$program" >/dev/null; then
    echo "coverage: there is no $program; on Debian, apt-get install gcovr brings the first" >&2
    exit 2
  fi
done

# Run the tests of a stage by one program: each program adds its counters to those of all the library,
# which takes longer than most tests.
run_stage() {
  local log=build/coverage/$1.log
  "build/coverage/tests/$1_test" --gtest_brief=1 >"$log" 2>&1 && return
  # Lines of tests that fail count as well.
  echo "coverage: tests of $1 failed, see $log" >&2
}
export -f run_stage

if [ "${1-}" != --again ]; then
  cmake --preset coverage
  cmake --build --preset coverage
  stages=("$@")
  if [ $# -eq 0 ]; then
    mapfile -t stages < <(cd build/coverage/tests && ls -S ./*_test | sed 's,^./,,; s,_test$,,')
  fi
  printf '%s\n' "${stages[@]}" | xargs -P "$(nproc)" -I{} bash -c 'run_stage {}'
fi

report=build/coverage/report
mkdir -p "$report"
gcovr --root . --object-directory build/coverage --filter libsurfmesh/surfmesh/ -j "$(nproc)" \
  --exclude-throw-branches --exclude-unreachable-branches --gcov-ignore-parse-errors \
  --json-summary "$report/summary.json" --html-details "$report/index.html" >/dev/null
exec /usr/bin/python3 tests/coverage.py "$report/summary.json" "$LEAST"
