#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The Freiburg SLAM benchmark on every log of the data folder, beside the published results.
#   experiments/freiburg/reproduce.sh [--quick] [--data DIR] [-j N] [flags of run_study.py...]
# Results and the report: out/freiburg, or --work_dir DIR. where_are_the_logs.sh says where logs are.
set -euo pipefail
cd "$(dirname "$0")/../.."
if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  sed -n '2,4s/^# \?//p' "$0"
  exit
fi
work=out/freiburg
for word in "$@"; do [[ $word == --quick ]] && work=out/freiburg_quick; done

experiments/install_packages.sh experiments
cmake --preset release >/dev/null
cmake --build --preset release --target gmapping_spa simulate evaluate_relations \
  evaluate_trajectory evaluate_map
exec experiments/workflow/run_study.py experiments/freiburg/freiburg.yaml --work_dir "$work" "$@"
