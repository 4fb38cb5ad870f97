#!/usr/bin/env bash
# Install what the build needs, if anything is missing (Debian 12). Needs root only then.
# --readers adds programs that read what surfmesh writes, meshes, pictures, completions and manual pages:
# a minute and 900 MB. Tests that need them are skipped without, so it is no error if they cannot
# be installed.
# --cad adds OpenCASCADE, by which surfmesh reads STEP, IGES and BREP files: 40 MB to load, 250 MB
# installed.
# --mpi adds Open MPI and METIS, for meshing on clusters: 30 MB installed.
# --fuzz adds clang and its library for fuzzing, by which tests/fuzz is built: 55 MB to load, 310 MB
# installed. Its tests are skipped without, so it is no error if they cannot be installed.
# --python adds what the Python module and its examples take: 200 MB.
# --viewer makes the script of the pages that `surfmesh view` writes: it needs npm, which is installed
# if there is none (Debian's, 400 MB), and loads three.js, esbuild and what drives a browser in tests
# (50 MB), whose versions tools/view/page/package-lock.json keeps. With --readers, tests open such pages
# in Chromium.
# --reference adds Doxygen, for the pages of the public headers: 20 MB.
# --release adds that and what makes and tries packages: 30 MB.
# All may be given.
set -euo pipefail

required=(g++ cmake ninja-build libopenmesh-dev libeigen3-dev libosd-dev nlohmann-json3-dev
  libcli11-dev libfmt-dev libpng-dev libtbb-dev libboost-dev libexpat1-dev zlib1g-dev libgtest-dev
  libbenchmark-dev clang-format-14)
# Building again is faster with the first, and a test needs the second: installed along with the others
# where the system has them.
optional=(ccache python3-numpy)
readers=()
viewer=

for argument in "$@"; do
  case "$argument" in
    --readers)
      readers+=(strace python3-meshio python3-vtk9 gmsh python3-gmsh calculix-ccx admesh
        librsvg2-bin chromium zsh man-db mandoc)
      ;;
    # The second only because CMake files of the first name what is in it.
    --cad) required+=(libocct-data-exchange-dev libocct-modeling-algorithms-dev) ;;
    --fuzz) readers+=(clang libclang-rt-14-dev llvm) ;;
    --mpi) required+=(libopenmpi-dev openmpi-bin libmetis-dev) ;;
    --python)
      required+=(pybind11-dev python3-dev python3-numpy python3-scipy python3-matplotlib)
      ;;
    --reference) required+=(doxygen) ;;
    --release) required+=(doxygen dpkg-dev debootstrap) ;;
    --viewer) viewer=yes ;;
    *)
      echo "usage: $0 [--readers] [--cad] [--mpi] [--python] [--fuzz] [--reference] [--release]" \
        "[--viewer]" >&2
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

# The script of the pages. Nothing that the packages bring is run while they are installed.
make_viewer() {
  [ -n "$viewer" ] || return 0
  if ! command -v npm >/dev/null; then
    echo "setup: the script of the pages needs npm, which is not installed" >&2
    return 1
  fi
  cd "$(dirname "${BASH_SOURCE[0]}")/view/page"
  if [ -e dist/viewer.js ] && [ -z "$(find src *.json build.mjs -newer dist/viewer.js)" ]; then
    return 0
  fi
  npm ci --ignore-scripts --no-audit --no-fund
  npm run --silent build
  echo "setup: made $PWD/dist/viewer.js"
}

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is no Debian system; the build needs what Debian calls: ${required[*]}" >&2
  make_viewer
  exit 0
fi
if [ -n "$viewer" ] && ! command -v npm >/dev/null; then
  required+=(nodejs npm)
fi

mapfile -t missing < <(missing_of "${required[@]}")
mapfile -t missing_readers < <(missing_of "${readers[@]}")
if [ "${#missing[@]}" -eq 0 ] && [ "${#missing_readers[@]}" -eq 0 ]; then
  make_viewer
  exit
fi
echo "setup: missing packages: ${missing[*]} ${missing_readers[*]}"

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: cannot install them without root or sudo; as root, run" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]} ${missing_readers[*]}" >&2
    [ "${#missing[@]}" -eq 0 ] && make_viewer
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
make_viewer
