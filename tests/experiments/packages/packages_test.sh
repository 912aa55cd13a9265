#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# packages_test.sh SOURCE: builds the packages of the folder SOURCE, installs them into a bare Debian 12 and
# runs there what is in them. Status 77, which skips the test, where $GMAPPING_SPA_TEST_PACKAGES is empty
# (tests/run.sh packages sets it) or no such Debian can be had: that takes root, mmdebstrap and Debian's
# archive. $GMAPPING_SPA_BARE_DEBIAN is a tarball of one, to save the minutes;
# $GMAPPING_SPA_PACKAGES is a folder of packages to test instead of building them.
set -euo pipefail
source=$1
work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT

skip() {
  echo "packages_test.sh: skipped: $1" >&2
  exit 77
}
[[ -n ${GMAPPING_SPA_TEST_PACKAGES:-} ]] || skip "tests/run.sh packages runs it"
[[ $(id -u) -eq 0 ]] || skip "only root can make a bare Debian"
unshare --mount --pid --fork true || skip "this system allows no mounts"
bare=${GMAPPING_SPA_BARE_DEBIAN:-$work/bare.tar}
if [[ ! -f $bare ]]; then
  command -v mmdebstrap >/dev/null || skip "there is no mmdebstrap"
  mmdebstrap --quiet --variant=minbase bookworm "$bare" || skip "Debian's archive cannot be had"
fi

packages=${GMAPPING_SPA_PACKAGES:-$work/packages}
[[ -n ${GMAPPING_SPA_PACKAGES:-} ]] || "$source/experiments/packages/build_packages.sh" "$packages"
command -v lintian >/dev/null && lintian --fail-on error,warning "$packages"/*.deb

root=$work/root
mkdir "$root"
tar -C "$root" -xf "$bare"
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
cp "$(dirname "$0")/in_bare_debian.sh" "$root"
cp /etc/resolv.conf "$root/etc"
unshare --mount --pid --fork --kill-child bash -euc '
  mount -t proc proc "$1/proc"
  mount --rbind /dev "$1/dev"
  exec chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 /in_bare_debian.sh' - "$root"
