#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails where an include leads backwards: between the top folders, or between the rooms of backend, whose
# order is that of the table in its README.
set -euo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C

# check_order FOLDER...: none includes those behind it.
check_order() {
  while [[ $# -gt 1 ]]; do
    local room=$1 later
    shift
    for later in "$@"; do
      if grep -rn --include='*.h' --include='*.cc' "^#include \"$later/" "$room"; then
        echo "check_includes.sh: $room must not include $later" >&2
        exit 1
      fi
    done
  done
}

check_order backend frontend plugins experiments
mapfile -t rooms < <(sed -n 's/^| `\([a-z]*\)` |.*/backend\/\1/p' backend/README.md)
if [[ $(printf '%s/\n' "${rooms[@]}" | sort) != "$(ls -d backend/*/)" ]]; then
  echo "check_includes.sh: the table in backend/README.md and the folders of backend differ" >&2
  exit 1
fi
check_order "${rooms[@]}"
# What lies on top is the language of all.
if grep -n '^#include "backend/.*/' backend/*.h backend/*.cc; then
  echo "check_includes.sh: files on top of backend must not include rooms" >&2
  exit 1
fi
