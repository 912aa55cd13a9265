#!/usr/bin/env bash
# The paper's experiments and ours around them: installs what is missing, builds, runs, reports.
#   experiments/paper/reproduce.sh [--quick] [-j N] [--work_dir DIR]
#     --quick     two seeds on a short tour: shows in minutes that everything runs
#     -j N        runs side by side; default: one a core
#     --work_dir  results; default: out/paper, with --quick out/paper_quick
# Stopped, it goes on where it was.
set -euo pipefail

usage() { sed -n '2,6s/^# \?//p' "$0"; }

quick=()
jobs=$(nproc)
work=
while [[ $# -gt 0 ]]; do
  case $1 in
    --quick) quick=(--quick); shift ;;
    -j) jobs=${2:?-j needs a number}; shift 2 ;;
    --work_dir) work=$(realpath -m "${2:?--work_dir needs a folder}"); shift 2 ;;
    --work_dir=*) work=$(realpath -m "${1#*=}"); shift ;;
    -h | --help) usage; exit 0 ;;
    *) usage >&2; exit 1 ;;
  esac
done
cd "$(dirname "$0")/../.."
work=${work:-$PWD/out/paper${quick:+_quick}}

experiments/install_packages.sh experiments
cmake --preset release >/dev/null
cmake --build --preset release --target gmapping_spa simulate evaluate_trajectory \
  evaluate_relations evaluate_map

studies=(experiment_1 experiment_2
  walking_pedestrian particles odometry_noise equation_14 back_ends scans_in_the_map)
files=("${studies[@]/#/experiments/paper/}")
files=("${files[@]/%/.yaml}")
/usr/bin/python3 experiments/workflow/run_study.py "${quick[@]}" -j "$jobs" --work_dir "$work" \
  "${files[@]}"
echo "The report: $work/report/index.html"
