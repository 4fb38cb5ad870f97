#!/usr/bin/env bash
# Install what the build needs, if anything is missing (Debian 12). Needs root only then.
# --readers adds other programs that read meshes, by which tests judge the files that are written:
# half a minute and 450 MB. Those tests are skipped without them, so it is no error if they cannot
# be installed.
# --cad adds OpenCASCADE, by which surfmesh reads STEP, IGES and BREP files: 40 MB to load, 250 MB
# installed. --python adds what the Python module and its examples take: 200 MB. All may be given.
set -euo pipefail

required=(g++ cmake ninja-build libopenmesh-dev libeigen3-dev libosd-dev nlohmann-json3-dev
  libcli11-dev libfmt-dev libtbb-dev libboost-dev libgtest-dev libbenchmark-dev clang-format-14)
# Building again is faster with the first, and a test needs the second: installed along with the others
# where the system has them.
optional=(ccache python3-numpy)
readers=()

for argument in "$@"; do
  case "$argument" in
    --readers) readers=(python3-meshio python3-vtk9 gmsh admesh) ;;
    # The second only because CMake files of the first name what is in it.
    --cad) required+=(libocct-data-exchange-dev libocct-modeling-algorithms-dev) ;;
    --python)
      required+=(pybind11-dev python3-dev python3-numpy python3-scipy python3-matplotlib)
      ;;
    *)
      echo "usage: $0 [--readers] [--cad] [--python]" >&2
      exit 2
      ;;
  esac
done

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Which of these packages are not installed.
missing_of() {
  local package
  for package in "$@"; do
    is_installed "$package" || echo "$package"
  done
}

install() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-install-recommends "$@"
}

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is no Debian system; the build needs what Debian calls: ${required[*]}" >&2
  exit 0
fi

mapfile -t missing < <(missing_of "${required[@]}")
mapfile -t missing_readers < <(missing_of "${readers[@]}")
[ "${#missing[@]}" -gt 0 ] || [ "${#missing_readers[@]}" -gt 0 ] || exit 0
echo "setup: missing packages: ${missing[*]} ${missing_readers[*]}"

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: cannot install them without root or sudo; as root, run" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]} ${missing_readers[*]}" >&2
    [ "${#missing[@]}" -eq 0 ]
    exit
  fi
  as_root=(sudo)
fi

if [ "${#missing[@]}" -gt 0 ]; then
  "${as_root[@]}" apt-get update
  for package in "${optional[@]}"; do
    if ! is_installed "$package" && apt-cache show "$package" >/dev/null 2>&1; then
      missing+=("$package")
    fi
  done
  install "${missing[@]}"
elif ! "${as_root[@]}" apt-get update; then
  missing_readers=()
fi
for package in "${missing_readers[@]}"; do
  install "$package" || echo "setup: cannot install $package; its tests are skipped" >&2
done
