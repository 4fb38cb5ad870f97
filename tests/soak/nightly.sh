#!/usr/bin/env bash
# What takes a night: nightly.sh BUILD [LOGS]
#
# 2,000 random models of each of three seeds by both scripts, the bytes of 200 on 1, 2, 3 and 8
# threads, all faults from outside, and 2,000 allocations that fail in each small run. Outputs go to
# LOGS (nightly-logs unless given). Exit status 1 if anything failed.
set -uo pipefail

if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  echo "usage: $0 BUILD [LOGS]" >&2
  exit 2
fi
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$(cd "$1" && pwd)
logs=${2:-nightly-logs}
program=$build/tools/surfmesh
mkdir -p "$logs"
status=0

# step NAME COMMAND...
step() {
  local name=$1
  shift
  local start=$SECONDS
  if "$@" >"$logs/$name.log" 2>&1; then
    echo "passed  $name  $((SECONDS - start)) s"
  elif [ $? -eq 77 ]; then
    echo "skipped $name"
  else
    echo "FAILED  $name  $((SECONDS - start)) s, see $logs/$name.log"
    status=1
  fi
}

soak=("$tests/soak/soak.sh")
for seed in 1 2 3; do
  for script in "$tests/../../shared/bench/soak.py" "$tests/soak/soak.py"; do
    kind=own
    [ "$script" = "$tests/soak/soak.py" ] || kind=shared
    step "soak-$kind-$seed" bash "${soak[@]}" "$script" "$program" \
      --runs 2000 --minutes 600 --seed "$seed"
  done
done
step threads bash "${soak[@]}" "$tests/soak/soak.py" "$program" \
  --runs 200 --minutes 600 --seed 4 --threads 1,2,3,8
step faults /usr/bin/python3 "$tests/faults/faults.py" "$build/tools" --full
SURFMESH_ALLOCATION_FAILURES=2000 step allocations "$build/tests/allocation_test"
exit $status
