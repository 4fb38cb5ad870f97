#!/usr/bin/env bash
# Make the packages of a release and install them where nothing else is: the .deb files in one
# minimal Debian, the .tar.gz in another. Mesh with each of them, and compile a program against the
# library: clean_root_test.sh SOURCE FOLDER. Exit status 77 (skipped) where no such root can be made.
# The minimal Debian is kept in FOLDER for the next time.
set -euo pipefail

source=$1 folder=$2

skip() {
  echo "skipped: $1"
  exit 77
}

[ "$(id -u)" -eq 0 ] || skip "another root can be entered by root only"
command -v debootstrap >/dev/null || skip "debootstrap is not installed (tools/setup.sh --release)"
suite=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
[ -e "/usr/share/debootstrap/scripts/$suite" ] || skip "debootstrap does not know '$suite'"

# What is mounted below is gone with this process.
if [ -z "${SURFMESH_OWN_MOUNTS-}" ]; then
  unshare --mount true 2>/dev/null || skip "nothing can be mounted in another root"
  SURFMESH_OWN_MOUNTS=yes exec unshare --mount bash "$0" "$@"
fi

fail() {
  echo "failed: $1" >&2
  exit 1
}

# Where this system gets its packages.
mirror=$({ cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null || true; } |
  sed -nE 's#^(URIs:|deb( \[[^]]*\])?) *(https?://[^ ]*/debian)/?( .*)?$#\3#p' | head -1)
mirror=${mirror:-http://deb.debian.org/debian}

mkdir -p "$folder"
base="$folder/$suite.tar"
if [ ! -e "$base" ]; then
  rm -rf "$folder/base"
  if ! debootstrap --variant=minbase "$suite" "$folder/base" "$mirror" >"$folder/debootstrap.log" 2>&1; then
    tail -5 "$folder/debootstrap.log"
    skip "no $suite can be had from $mirror"
  fi
  rm -rf "$folder/base"/var/cache/apt/archives/*.deb
  tar -C "$folder/base" -cf "$base.new" .
  mv "$base.new" "$base"
  rm -rf "$folder/base"
fi

# A new root of this name.
make_root() {
  root="$folder/$1"
  rm -rf --one-file-system "$root"
  mkdir "$root"
  tar -C "$root" -xf "$base"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  mount -t proc proc "$root/proc" || mount --rbind /proc "$root/proc"
  in_root apt-get update --quiet
}

remove_root() {
  umount -l "$root/proc"
  rm -rf --one-file-system "$root"
}

# Run a command in the root, without what this system's environment sets.
in_root() {
  chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@"
}

install_in_root() {
  in_root apt-get install --yes --quiet --no-install-recommends "$@"
}

expect_files() {
  local file
  for file in "$@"; do
    [ -s "$root/$file" ] || fail "$file is not installed"
  done
}

# mesh PROGRAM MODEL: it does, and writes a mesh of more than 500 triangles.
mesh() {
  in_root "$1" mesh "$2" -o /tmp/mesh.obj --quiet
  local triangles
  triangles=$(grep -c '^f ' "$root/tmp/mesh.obj")
  [ "$triangles" -gt 500 ] || fail "$1 makes $triangles triangles of $2"
  rm "$root/tmp/mesh.obj"
}

expect_version() {
  in_root "$1" --version | grep -qx "surfmesh $version" || fail "$1 --version tells another"
}

"$source/tools/release.sh" --no-tests
packages="$source/build/package/packages"
version=$(sed -n 's/^set(CPACK_PACKAGE_VERSION "\(.*\)")/\1/p' "$source/build/package/CPackConfig.cmake")
models=usr/share/surfmesh/models

echo "== the package of the program alone"
make_root deb
cp "$packages"/*.deb "$root/tmp"
# install_package NAME
install_package() {
  install_in_root "/tmp/$(cd "$root/tmp" && ls "$1"_*.deb)"
}
install_package surfmesh
expect_version surfmesh
mesh surfmesh /$models/torus.obj
mesh surfmesh /$models/teapot.json
expect_files usr/share/man/man1/surfmesh.1 usr/share/man/man1/surfmesh-mesh.1 \
  usr/share/bash-completion/completions/surfmesh usr/share/zsh/site-functions/_surfmesh \
  usr/share/doc/surfmesh/copyright usr/share/doc/surfmesh/changelog.gz \
  usr/share/doc/surfmesh/libsurfmesh/REFERENCE.md
if in_root dpkg-query -W -f '${Package}\n' | grep -E '^lib(occt|openmpi)'; then
  fail "it brings OpenCASCADE or MPI along"
fi
if [ -e "$root/usr/include/surfmesh" ]; then fail "it has headers"; fi

if compgen -G "$packages/surfmesh-cad_*" >/dev/null; then
  echo "== CAD files"
  install_package surfmesh-cad
  mesh surfmesh /$models/part.step
fi
if compgen -G "$packages/surfmesh-mpi_*" >/dev/null; then
  echo "== MPI"
  install_package surfmesh-mpi
  install_in_root openmpi-bin
  expect_files usr/share/man/man1/surfmesh-mpi.1 usr/share/man/man1/surfmesh-mpi-mesh.1 \
    usr/share/bash-completion/completions/surfmesh-mpi usr/share/zsh/site-functions/_surfmesh-mpi
  in_root env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    mpirun --oversubscribe -n 2 surfmesh-mpi mesh /$models/wave.json -o /tmp/ranks.obj --quiet
  [ "$(grep -c '^f ' "$root/tmp/ranks.obj")" -gt 1000 ] || fail "surfmesh-mpi makes no mesh"
fi
if compgen -G "$packages/python3-surfmesh_*" >/dev/null; then
  echo "== Python"
  install_package python3-surfmesh
  in_root python3 -c "import surfmesh; mesh = surfmesh.mesh('/$models/torus.obj')
assert surfmesh.__version__ == '$version' and len(mesh.triangles) > 1000"
fi

echo "== the library"
install_package libsurfmesh-dev
install_in_root g++ pkg-config
cp "$source/tests/package/walk_result.cc" "$root/tmp/main.cc"
in_root sh -c 'c++ -std=c++20 /tmp/main.cc $(pkg-config --cflags --libs --static surfmesh) -o /tmp/walk'
in_root /tmp/walk /$models/torus.obj | grep -q 'triangles, greatest distance' ||
  fail "the program that is linked to the library tells nothing"
remove_root

echo "== the archive"
make_root archive
# The line of README.md that tells what it needs.
needed=$(sed -n 's/^apt-get install \(lib[^#]*\).*/\1/p' "$source/README.md")
[ -n "$needed" ] || fail "README.md does not tell what the archive needs"
# shellcheck disable=SC2086  # several packages
install_in_root $needed
tar -C "$root/opt" -xzf "$packages"/surfmesh-*.tar.gz
unpacked=$(cd "$root" && ls -d opt/surfmesh-*)
expect_version "/$unpacked/bin/surfmesh"
mesh "/$unpacked/bin/surfmesh" "/$unpacked/share/surfmesh/models/torus.obj"
expect_files "$unpacked/share/man/man1/surfmesh-mesh.1" "$unpacked/share/doc/surfmesh/LICENSE" \
  "$unpacked/include/surfmesh/surfmesh.hh"
remove_root
echo "all packages work"
