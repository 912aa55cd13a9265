#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test.
#   tests/run.sh            release build, all tests; then the sanitizers: short tests with ASan and
#                           UBSan, those with threads with TSan
#   tests/run.sh PRESET...  only these presets: release, dev, asan, tsan
# Tests on real logs find them in $GMAPPING_SPA_DATA or ../shared/data, and are skipped elsewhere.
set -euo pipefail
cd "$(dirname "$0")/.."

experiments/install_packages.sh experiments
presets=("$@")
[[ ${#presets[@]} -gt 0 ]] || presets=(release asan tsan)
for preset in "${presets[@]}"; do
  echo "== $preset"
  cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset"
  ctest --preset "$preset" -j "$(nproc)"
done
