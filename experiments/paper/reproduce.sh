#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The paper's experiments and ours around them: installs what is missing, builds, runs, reports.
#   experiments/paper/reproduce.sh [--quick] [-j N] [--work_dir DIR] [--world FILE ...]
#     --quick      one seed on a short tour: shows in minutes that everything runs
#     -j N         runs side by side; default: one a core
#     --work_dir   results; default: out/paper, with --quick out/paper_quick
#     --world      a world of your own (experiments/simulation/README.md) instead of the paper's building;
#                  results: out/paper_NAME, with --quick out/paper_NAME_quick
#     --path       its way points; default: the world's name with .path.yaml
#     --obstacles  obstacles for it; without, studies with obstacles are left out
# Stopped, it goes on where it was.
set -euo pipefail

usage() { sed -n '2,11s/^# \?//p' "$0"; }

fail() {
  echo "reproduce.sh: error: $1" >&2
  exit 1
}

# A file that a flag names, as seen from the caller's folder.
file_of() {
  [[ -f $2 ]] || fail "$1=$2: expected a file"
  realpath "$2"
}

quick=()
world=()
name=paper
jobs=$(nproc)
work=
while [[ $# -gt 0 ]]; do
  case $1 in
    --world | --path | --obstacles | --work_dir)
      [[ $# -ge 2 ]] || fail "$1 needs a value"
      flag=$1 value=$2
      shift 2
      set -- "$flag=$value" "$@"
      ;;
    --world=* | --path=* | --obstacles=*)
      file=$(file_of "${1%%=*}" "${1#*=}")
      world+=("${1%%=*}=$file")
      if [[ $1 == --world=* ]]; then
        name=$(basename "$file")
        name=paper_${name%.*}
      fi
      shift
      ;;
    --quick) quick=(--quick); shift ;;
    -j) jobs=${2-}; shift $(($# > 1 ? 2 : 1)) ;;
    -j*) jobs=${1#-j}; shift ;;
    --work_dir=*)
      work=${1#*=}
      [[ -n $work && $work != -* ]] || fail "--work_dir: expected a folder, found '$work'"
      work=$(realpath -m -- "$work")
      shift
      ;;
    -h | --help) usage; exit 0 ;;
    *) usage >&2; exit 1 ;;
  esac
done
[[ $jobs =~ ^[1-9][0-9]*$ ]] || fail "-j: expected a number from 1, found '$jobs'"
[[ ${#world[@]} -eq 0 || $name != paper ]] || fail "--path and --obstacles need --world=FILE"
cd "$(dirname "$0")/../.."
work=${work:-$PWD/out/$name${quick:+_quick}}

experiments/install_packages.sh experiments
cmake --preset release >/dev/null
cmake --build --preset release --target gmapping_spa simulate evaluate_trajectory \
  evaluate_relations evaluate_map

studies=(experiment_1 experiment_2 original parts choices speed_and_resolution particles
  walking_pedestrian scans_in_the_map)
files=("${studies[@]/#/experiments/paper/}")
files=("${files[@]/%/.yaml}")
if [[ ${#world[@]} -gt 0 ]]; then
  moved=$(/usr/bin/python3 experiments/paper/in_another_world.py "${world[@]}" \
    --output "$work/studies" "${files[@]}")
  mapfile -t files <<<"$moved"
fi
/usr/bin/python3 experiments/workflow/run_study.py "${quick[@]}" -j "$jobs" --work_dir "$work" \
  "${files[@]}"
echo "The report: $work/report/index.html"
