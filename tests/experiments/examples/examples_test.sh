#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# examples_test.sh EXAMPLES PREFIX WORLDS: what the examples in the folder EXAMPLES do is what the
# executables installed in PREFIX do.
set -euo pipefail
examples=$1 bin=$2/bin worlds=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$bin/simulate" --world="$worlds/paper_building.yaml" \
  --path="$worlds/paper_building.short.path.yaml" --output_dir=. --seed=1 \
  --bump_probability=0.3 --bump_deg=20  # there is something to warn of
"$bin/gmapping_spa" --log=log.clf --output_dir=expected

"$examples/map_a_log" log.clf mapped 2> warnings.txt | tee pose.txt
grep -q 'contradicts the odometry' warnings.txt
grep -q '^The robot is at .* rad\.$' pose.txt
cmp mapped.pgm expected/map.pgm
diff <(grep -v '^image:' mapped.yaml) <(grep -v '^image:' expected/map.yaml)

"$examples/swap_back_end" log.clf 2>> warnings.txt | tee swapped.txt
if grep InitGoogleLogging warnings.txt; then exit 1; fi
grep -q 'the cost went from' swapped.txt
nodes=$(grep -c '^VERTEX_SE2' expected/graph.g2o)
grep -q "^$nodes nodes in the end$" swapped.txt

"$examples/optimize_a_graph" > square.g2o
"$bin/optimize_graph" --input=square.g2o --backend=spa --output=again.g2o > summary.json
diff <(cut -c1-20 square.g2o) <(cut -c1-20 again.g2o)  # it is at the minimum

# Mistakes are told, with a status to match.
if "$examples/map_a_log" no_such.clf mapped 2> error.txt; then exit 1; fi
grep -qx 'cannot read no_such.clf' error.txt
