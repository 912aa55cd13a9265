#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the Debian packages of this source tree: gmapping-spa, libgmapping-spa-dev and python3-gmapping-spa.
#   experiments/packages/build_packages.sh [FOLDER] [CMake options...]
# FOLDER, by default out/packages, gets the packages; options such as -DGMAPPING_SPA_CERES=OFF leave out parts.
# The same commit on the same system makes the same bytes. Install them with
#   apt-get install ./out/packages/*.deb
set -euo pipefail
if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  sed -n '3,7s/^# //p' "$0"
  exit 0
fi
folder=$(realpath -m "out/packages")
if [[ $# -gt 0 && $1 != -D* ]]; then
  folder=$(realpath -m "$1")
  shift
fi
cd "$(dirname "$0")/../.."

experiments/install_packages.sh packages python
build=build-packages
# Symbols are bound at the start, and what binds them is read-only from then on, as hardening=+bindnow has it.
hardening=-Wl,-z,relro,-z,now
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
  -DGMAPPING_SPA_TESTS=OFF -DGMAPPING_SPA_ROS=OFF -DCMAKE_EXE_LINKER_FLAGS=$hardening -DCMAKE_SHARED_LINKER_FLAGS=$hardening \
  -DCMAKE_MODULE_LINKER_FLAGS=$hardening "$@" >/dev/null
rm -rf "$build/bin"  # executables tell the commit at which they were linked
cmake --build "$build"

umask 022  # which folders in packages have
# Stamps of files in packages.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CHANGELOG.md)
export SOURCE_DATE_EPOCH
rm -rf "$build/packages"
(cd "$build" && cpack)
mkdir -p "$folder"
for package in "$build"/packages/*.deb; do
  cp "$package" "$folder"
  echo "$folder/${package##*/}"
done
