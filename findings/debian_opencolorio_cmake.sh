#!/usr/bin/env bash
# libopencolorio-dev 2.1.2+dfsg1-4+b3 (Debian 12): find_package(OpenColorIO CONFIG) does not find it, and told where it is, looks for the library elsewhere.
#
# Seen: the package puts OpenColorIOConfig.cmake straight into usr/share/cmake, where CMake searches no package of any name:
# "Could not find a package configuration file". With OpenColorIO_DIR set to that folder it is read, but the targets
# take the root for four folders above theirs, as if they lay in lib/TRIPLET/cmake/OpenColorIO, and ask for
# lib/x86_64-linux-gnu/libOpenColorIO.so.2.1.2 beside usr and not in it: "references the file ... but this file does
# not exist". On a Debian whose /lib is a link to /usr/lib this second fault does not show.
#
# Whom it bites: whoever builds against Debian 12's OpenColorIO by CMake: renderers, compositors, image tools. What works
# is find_path and find_library, or pkg-config, which the package has too.
#
# The script fails if the package comes to behave otherwise. It needs cmake, a C++ compiler, curl, dpkg-deb and the network.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

pool=http://deb.debian.org/debian/pool/main/o/opencolorio
for package in libopencolorio-dev libopencolorio2.1; do
  curl -fsSL -o "$package.deb" "$pool/${package}_2.1.2+dfsg1-4+b3_amd64.deb"
  dpkg-deb -x "$package.deb" root
done
[ -e root/usr/lib/x86_64-linux-gnu/libOpenColorIO.so.2.1.2 ] || { echo "the library is not where it was" >&2; exit 1; }

mkdir project
cat >project/CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.20)
project(user CXX)
set(CMAKE_FIND_USE_CMAKE_SYSTEM_PATH OFF) # this machine's own packages are not meant
set(CMAKE_FIND_USE_SYSTEM_ENVIRONMENT_PATH OFF)
find_package(OpenColorIO CONFIG REQUIRED)
CMAKE

expect() { # TEXT ARGUMENT ...: configuring must fail, and say this
  local text=$1
  shift
  if cmake -S project -B "build-$RANDOM" "$@" >log 2>&1; then
    echo "CMake found it: $*" >&2
    exit 1
  fi
  tr -s ' \n' ' ' <log | grep -qF "$text" || { cat log >&2; exit 1; }
  echo "as seen: $text"
}

expect 'Could not find a package configuration file provided by "OpenColorIO"' \
  -DCMAKE_PREFIX_PATH="$work/root/usr"
expect 'but this file does not exist' -DOpenColorIO_DIR="$work/root/usr/share/cmake"
