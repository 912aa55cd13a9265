#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What the defaults survive: recorded logs under stress, scored by their relations.
#   experiments/stress/reproduce.sh [--quick] [--data DIR] [-j N] [flags of run_study.py...]
# Results, the report and tables/stress_survival.md: out/stress, or --work_dir DIR.
set -euo pipefail
cd "$(dirname "$0")/../.."
if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  sed -n '2,4s/^# \?//p' "$0"
  exit
fi
work=out/stress
table=()  # those of the flags that survival.py needs too
words=("$@")
for ((i = 0; i < $#; i++)); do
  case ${words[i]} in
    --quick) table+=(--quick); [[ $work == out/stress ]] && work=out/stress_quick ;;
    --work_dir=*) work=${words[i]#*=} ;;
    --work_dir) work=${words[i + 1]:?--work_dir needs a folder} ;;
    --data=* | --bin=*) table+=("${words[i]}") ;;
    --data | --bin) table+=("${words[i]}=${words[i + 1]:?${words[i]} needs a folder}") ;;
  esac
done

experiments/install_packages.sh experiments
cmake --preset release >/dev/null
cmake --build --preset release --target gmapping_spa simulate evaluate_relations \
  evaluate_trajectory evaluate_map
study=experiments/stress/stress.yaml
experiments/workflow/run_study.py "$study" "$@" --work_dir "$work"
experiments/stress/survival.py "$study" --work_dir "$work" "${table[@]}"
