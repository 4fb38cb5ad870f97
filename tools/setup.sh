#!/usr/bin/env bash
# Install what the build needs, if anything is missing (Debian 12). Needs root only then.
set -euo pipefail

required=(g++ cmake ninja-build libopenmesh-dev libeigen3-dev libosd-dev nlohmann-json3-dev
  libcli11-dev libfmt-dev libtbb-dev libboost-dev libgtest-dev libbenchmark-dev clang-format-14)
# Building again is faster with the first, and a test needs the second: installed along with the others
# where the system has them.
optional=(ccache python3-numpy)

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is no Debian system; the build needs what Debian calls: ${required[*]}" >&2
  exit 0
fi

missing=()
for package in "${required[@]}"; do
  is_installed "$package" || missing+=("$package")
done
[ "${#missing[@]}" -gt 0 ] || exit 0
echo "setup: missing packages: ${missing[*]}"

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: cannot install them without root or sudo; as root, run" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

"${as_root[@]}" apt-get update
for package in "${optional[@]}"; do
  if ! is_installed "$package" && apt-cache show "$package" >/dev/null 2>&1; then
    missing+=("$package")
  fi
done
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --no-install-recommends "${missing[@]}"
