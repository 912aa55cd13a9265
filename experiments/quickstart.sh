#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From a fresh clone to a map: installs what is missing, builds, simulates a robot in a building,
# runs SLAM on its log and compares the result with the truth.
#   experiments/quickstart.sh [output folder] [flags of gmapping_spa...]
set -euo pipefail
cd "$(dirname "$0")/.."

if [[ ${1:-} == -* ]]; then
  sed -n '2,4s/^# //p' "$0"
  [[ $1 == -h || $1 == --help ]] && exit 0 || exit 1
fi
output=${1:-out/quickstart}
if [[ $# -gt 0 ]]; then shift; fi

experiments/install_packages.sh
cmake --preset release >/dev/null
cmake --build --preset release --target gmapping_spa simulate evaluate_trajectory

bin=build/bin
"$bin/simulate" --world=experiments/simulation/worlds/paper_building.yaml \
  --output_dir="$output/simulated" --seed=1
"$bin/gmapping_spa" --log="$output/simulated/log.clf" --output_dir="$output/slam" \
  --threads="$(nproc)" "$@"
"$bin/evaluate_trajectory" --truth="$output/simulated/truth.tum" \
  --trajectory="$output/slam/trajectory.tum" > "$output/slam/errors.json"

python3 - "$output" <<'PY'
import json, sys
output = sys.argv[1]
ate = json.load(open(f"{output}/slam/errors.json"))["ate"]
run = json.load(open(f"{output}/slam/run.json"))
print(f"""
Log         {output}/simulated/log.clf ({run['counts']['scans']} scans of a simulated building)
Map         {output}/slam/map.yaml, map.pgm (for ROS map_server)
Picture     {output}/slam/map.png
Trajectory  {output}/slam/trajectory.tum (TUM format, a pose for every scan)
Pose graph  {output}/slam/graph.g2o
Record      {output}/slam/run.json

Against the true trajectory, after the best rigid alignment:
  position  {100 * ate['translation_m']['rmse']:.1f} cm RMSE, {100 * ate['translation_m']['max']:.1f} cm at most
  heading   {ate['rotation_deg']['rmse']:.2f} deg RMSE""")
PY
