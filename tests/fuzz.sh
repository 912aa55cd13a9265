#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fuzzes every reader of files, from its seeds and what was once found, with ASan and UBSan.
#   tests/fuzz.sh [SECONDS [READER...]]   builds with the preset asan; 10 s each, all readers, unless told
# An input that breaks the contract (tests/fuzz/contract.h), takes more than 5 s or 1 GB is kept in
# tests/fuzz/findings/READER; name it for what is wrong, mend the reader, and commit both. The corpus
# stays in build-asan/corpus, so that later runs begin where earlier ones ended.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-10}
[[ $seconds =~ ^[0-9]+$ ]] || { echo "fuzz.sh: expected a number of seconds, found '$seconds'" >&2; exit 1; }
shift || true
readers=("$@")
[[ ${#readers[@]} -gt 0 ]] || readers=($(basename -s _fuzz.cc -a tests/fuzz/*_fuzz.cc))

cmake --preset asan >/dev/null
cmake --build --preset fuzz --target "${readers[@]/%/_fuzz}"
export TMPDIR=${TMPDIR:-/tmp}
[[ -w /dev/shm ]] && TMPDIR=/dev/shm  # readers that want a path get a file for each input
export UBSAN_OPTIONS=print_stacktrace=1
broken=()
for reader in "${readers[@]}"; do
  seeds=tests/fuzz/seeds/$reader
  findings=tests/fuzz/findings/$reader
  corpus=build-asan/corpus/$reader
  log=build-asan/$reader.log
  mkdir -p "$corpus" "$findings"
  dictionary=(tests/fuzz/dictionaries/"$reader")
  options=(-max_total_time="$seconds" -timeout=5 -rss_limit_mb=1024 -max_len=4096 -print_final_stats=1
    -artifact_prefix="$findings/")
  [[ ! -e ${dictionary[0]} ]] || options+=(-dict="${dictionary[0]}")
  build-asan/tests/fuzz/"$reader"_fuzz "${options[@]}" "$corpus" "$seeds" "$findings" \
    >"$log" 2>&1 || broken+=("$reader")
  rmdir --ignore-fail-on-non-empty "$findings"  # folders without files are not kept
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  covered=$(grep -aoE 'cov: [0-9]+' "$log" | tail -n 1 || true)
  echo "$reader: ${executions:-?} executions, edges of code covered: ${covered#cov: }"
done
if [[ ${#broken[@]} -gt 0 ]]; then
  for reader in "${broken[@]}"; do
    echo "fuzz.sh: $reader is broken (build-asan/$reader.log):" >&2
    grep -a -m 5 -E 'broken contract|ERROR|runtime error|Test unit written' "build-asan/$reader.log" >&2 || true
  done
  exit 1
fi
