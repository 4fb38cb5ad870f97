#!/usr/bin/env bash
# Which lines of libsurfmesh the tests run: builds with counters in build/coverage, runs the tests and
# prints lines and branches by folder, and the files that are covered least. Exit status 1 if fewer
# lines than LEAST are covered. A page for each file is in build/coverage/report.
#
#   tests/coverage.sh            all tests but those with the label long
#   tests/coverage.sh -L quad    options of ctest choose among them; the counters of earlier runs stay
#   tests/coverage.sh --again    only print, from the counters that are there
set -euo pipefail

readonly LEAST=93  # percent of the lines

cd "$(dirname "${BASH_SOURCE[0]}")/.."
for program in gcovr cmake ctest; do
  if ! command -v "$program" >/dev/null; then
    echo "coverage: there is no $program; on Debian, apt-get install gcovr brings the first" >&2
    exit 2
  fi
done

if [ "${1-}" != --again ]; then
  cmake --preset coverage
  cmake --build --preset coverage
  # Tests that fail are told by ctest; their lines count as well.
  ctest --preset coverage -j "$(nproc)" "$@" || echo "coverage: some tests failed" >&2
fi

report=build/coverage/report
mkdir -p "$report"
gcovr --root . --object-directory build/coverage --filter libsurfmesh/surfmesh/ -j "$(nproc)" \
  --exclude-throw-branches --exclude-unreachable-branches --gcov-ignore-parse-errors \
  --json-summary "$report/summary.json" --html-details "$report/index.html" >/dev/null
exec /usr/bin/python3 tests/coverage.py "$report/summary.json" "$LEAST"
