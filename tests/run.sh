#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds, and runs every test.
#   tests/run.sh          the format, a sample of clang-tidy, the release build and all tests; then the
#                         sanitizers: short tests with ASan and UBSan, those with threads with TSan; and
#                         three minutes of fuzzing what ASan and UBSan have built
#   tests/run.sh STEP...  only these: format, tidy, docs, fuzz, packages (in a bare Debian, minutes), ros (the
#                         node for ROS 1 under a roscore), drive (in a browser, minutes), or a preset: release, dev, asan, tsan
# Tests on real logs find them in $GMAPPING_SPA_DATA or ../shared/data, and are skipped elsewhere.
set -euo pipefail
cd "$(dirname "$0")/.."

experiments/install_packages.sh checks experiments python
experiments/install_packages.sh docs ||
  echo "run.sh: without Doxygen the documentation is not tested" >&2
steps=("$@")
[[ ${#steps[@]} -gt 0 ]] || steps=(format tidy release asan tsan fuzz)
for step in "${steps[@]}"; do
  echo "== $step"
  case $step in
    format) tests/check_format.sh ;;
    tidy) tests/check_tidy.sh ;;
    fuzz)
      experiments/install_packages.sh fuzz
      tests/fuzz.sh 8  # each reader
      ;;
    packages)
      experiments/install_packages.sh packages
      cmake --preset release >/dev/null
      GMAPPING_SPA_TEST_PACKAGES=1 ctest --preset release -R '^Packages'
      ;;
    ros)  # with release where its packages are there
      experiments/install_packages.sh ros
      cmake --preset release >/dev/null
      cmake --build --preset release --target gmapping_spa_ros1 gmapping_spa evaluate_map
      ctest --preset release -R '^ros1'
      ;;
    drive)  # a browser is driven through the building, minutes
      cmake --preset release >/dev/null
      cmake --build --preset release --target gmapping_spa_apps
      GMAPPING_SPA_TEST_DRIVE=1 ctest --preset release -R '^drive_page'
      ;;
    docs)  # with release, a test builds them
      cmake --preset release >/dev/null
      cmake --build --preset release --target gmapping_spa_apps
      experiments/docs/build_docs.sh
      ;;
    *)
      [[ $step != [at]san ]] || experiments/install_packages.sh fuzz  # by Clang, as the fuzzing
      cmake --preset "$step" >/dev/null
      cmake --build --preset "$step"
      ctest --preset "$step" -j "$(nproc)"
      ;;
  esac
done
