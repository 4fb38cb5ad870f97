#!/usr/bin/env bash
# Fuzz the readers and the pipeline: run.sh [--built] SECONDS [TARGET...], each target (all of them)
# for so many seconds. Tells for each the executions, what it reached of the code, and findings.
# --build only builds; --built does not build again.
#
# Exit status 1 where something was found; the input, as small as a minute can make it, then lies in
# build/fuzz/findings/TARGET. 77 (skipped) where clang or its library for fuzzing is missing:
# tools/setup.sh --fuzz installs them. What is learnt stays in build/fuzz/corpus. With a number in
# SURFMESH_FUZZ_SEED the same changes of inputs are tried each time.
set -euo pipefail

usage() {
  echo "usage: $0 --build | [--built] SECONDS [TARGET...]" >&2
  exit 2
}

is_built=
case "${1-}" in
  --build)
    [ $# -eq 1 ] || usage
    ;;
  --built)
    is_built=yes
    shift
    ;;
esac
[ "${1-}" = --build ] || [[ "${1-}" =~ ^[1-9][0-9]*$ ]] || usage

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=build/fuzz
programs=$build/tests/fuzz

has_fuzzer() {
  command -v clang++ >/dev/null || return 1
  echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
    clang++ -fsanitize=fuzzer,address -x c++ - -o /dev/null 2>/dev/null
}

if [ -z "$is_built" ]; then
  if ! has_fuzzer; then
    echo "skipped: clang++ or libFuzzer is not installed (tools/setup.sh --fuzz)"
    exit 77
  fi
  export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
  cmake --preset fuzz >&2
  cmake --build --preset fuzz >&2
  rm -rf "$build/seeds"
  # OpenCASCADE keeps what its writers allocate.
  ASAN_OPTIONS=detect_leaks=0 "$programs/surfmesh_make_seeds" "$build/seeds"
fi
if [ "$1" = --build ]; then
  exit 0
elif [ ! -d "$build/seeds" ]; then
  echo "skipped: $build is not built"
  exit 77
fi
seconds=$1
shift
targets=("$@")
if [ $# -eq 0 ]; then
  mapfile -t targets < <(ls "$build/seeds")
fi

# Bytes of the longest inputs: longer ones are slow, and show little more.
longest() {
  case "$1" in
    formula) echo 200 ;;
    pipeline) echo 300 ;;
    cad) echo 24000 ;;
    result) echo 6000 ;;
    *) echo 3000 ;;
  esac
}

export UBSAN_OPTIONS="print_stacktrace=1"
# Targets that end by a finding leave their files behind.
remove_left_files() {
  local folder
  for folder in /dev/shm/surfmesh_fuzz.* "${TMPDIR:-/tmp}"/surfmesh_fuzz.*; do
    if [ -d "$folder" ] && ! kill -0 "${folder##*.}" 2>/dev/null; then
      rm -rf "$folder"
    fi
  done
}
trap remove_left_files EXIT

# number NAME: the last number that libFuzzer tells by this name, 0 if none.
number() {
  { grep -oE "$1:? +[0-9]+" "$log" || echo 0; } | tail -1 | grep -oE '[0-9]+$'
}

# Make a finding smaller, and tell where it is.
tell_finding() {
  local target=$1 input=$2 kind
  kind=$(basename "$input")
  grep -E -m 3 'FINDING:|ERROR: |runtime error:' "$log" >&2 || true
  if [[ $kind == crash-* ]]; then
    "$programs/fuzz_$target" -minimize_crash=1 -max_total_time=60 \
      -exact_artifact_path="$input.small" "$input" >"$log.small" 2>&1 || true
    [ -s "$input.small" ] && mv "$input.small" "$input"
  fi
  echo "$target: found $input" >&2
}

status=0
printf '%-10s %12s %10s %10s  %s\n' target executions coverage features findings
for target in "${targets[@]}"; do
  if [ ! -x "$programs/fuzz_$target" ]; then
    echo "$0: there is no target $target" >&2
    exit 2
  fi
  corpus=$build/corpus/$target found=$build/findings/$target log=$build/$target.log
  mkdir -p "$corpus" "$found"
  folders=("$corpus" "$build/seeds/$target")
  [ -d "tests/fuzz/findings/$target" ] && folders+=("tests/fuzz/findings/$target")
  dictionary=()
  [ -e "tests/fuzz/$target.dict" ] && dictionary=(-dict="tests/fuzz/$target.dict")
  # OpenCASCADE keeps what its readers allocate, which would be told at the end, too.
  leaks=1
  [ "$target" = cad ] && leaks=0
  export ASAN_OPTIONS="detect_leaks=$leaks"
  # Entropic scheduling takes a third of the time where each run is long.
  entropic=1
  [ "$target" = pipeline ] && entropic=0
  touch "$build/started"
  "$programs/fuzz_$target" "${folders[@]}" "${dictionary[@]}" -max_total_time="$seconds" \
    -max_len="$(longest "$target")" -timeout=120 -rss_limit_mb=2048 \
    -detect_leaks=$leaks -entropic=$entropic -seed="${SURFMESH_FUZZ_SEED:-0}" \
    -artifact_prefix="$found/" -print_final_stats=1 >"$log" 2>&1 || true
  mapfile -t findings < <(find "$found" -type f -newer "$build/started" ! -name 'slow-unit-*')
  printf '%-10s %12s %10s %10s  %s\n' "$target" "$(number stat::number_of_executed_units)" \
    "$(number cov)" "$(number ft)" "${#findings[@]}"
  if [ "$(number stat::number_of_executed_units)" = 0 ] && [ "${#findings[@]}" -eq 0 ]; then
    tail -20 "$log" >&2
    status=1
  fi
  for finding in "${findings[@]}"; do
    tell_finding "$target" "$finding"
    status=1
  done
done
exit "$status"
