#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs clang-tidy with the checks in .clang-tidy; a finding fails. A file takes 6 to 15 s of CPU.
#   tests/check_tidy.sh                  every fifth source of the back end, which stand for the rest
#   tests/check_tidy.sh --since COMMIT   sources that differ from that commit
#   tests/check_tidy.sh --all            every source but the tests
#   tests/check_tidy.sh FILE...          these
# By the compile commands of the preset dev, which compiles every source by itself.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1:-} in
  --all) mapfile -t files < <(find backend experiments frontend plugins -name '*.cc') ;;
  --since) mapfile -t files < <(git diff --name-only --diff-filter=d "$2" -- '*.cc' ':!tests') ;;
  "") mapfile -t files < <(find backend -name '*.cc' | LC_ALL=C sort | awk 'NR % 5 == 1') ;;
  *) files=("$@") ;;
esac
if [[ ${#files[@]} -eq 0 ]]; then
  echo "check_tidy.sh: no source to check"
  exit 0
fi
[[ -f build-dev/compile_commands.json ]] || cmake --preset dev >/dev/null
# What is of ROS is not compiled everywhere.
compiled=()
for file in "${files[@]}"; do
  if [[ $file == experiments/ros/ros[12]/* ]] && ! grep -q "/$file\"" build-dev/compile_commands.json; then
    echo "check_tidy.sh: $file is left out, as it is not compiled"
  else
    compiled+=("$file")
  fi
done
files=("${compiled[@]}")
# stderr only counts what clang-tidy suppressed in headers of others; findings are on stdout.
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build-dev --quiet 2>/dev/null
echo "check_tidy.sh: ${#files[@]} sources without findings"
