#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Says which logs of the Freiburg benchmark are in the data folder, and where to get the others.
#   experiments/freiburg/where_are_the_logs.sh [DATA]
# DATA holds carmen/NAME.clf.gz and relations/NAME.relations.gz (gzipped or not); it is
# $GMAPPING_SPA_DATA or ../shared/data unless given.
set -euo pipefail
cd "$(dirname "$0")/../.."
if [[ ${1:-} == -* ]]; then
  sed -n '2,5s/^# \?//p' "$0"
  [[ $1 == -h || $1 == --help ]] && exit 0 || exit 1
fi
data=${1:-${GMAPPING_SPA_DATA:-../shared/data}}

state() {  # of the file with this name, gzipped or not
  [[ -s $1.gz || -s $1 ]] && echo "there" || echo "missing"
}

printf '%-14s %-9s %-9s\n' log scans relations
for name in intel fr079 aces mit-killian mit-csail fr101 belgioioso edmonton fhw usc-sal orebro; do
  printf '%-14s %-9s %-9s\n' "$name" "$(state "$data/carmen/$name.clf")" \
    "$(state "$data/relations/$name.relations")"
done
cat <<TEXT

Logs: CARMEN text as their authors recorded it, from
  https://github.com/MOLAorg/mola_test_datasets (folder datasets/radish), CC BY 3.0
  http://ais.informatik.uni-freiburg.de/slamevaluation/datasets.php ("raw log file")
  into $data/carmen/NAME.clf or NAME.clf.gz. Not the files called "corrected".
Relations: "relations" of the same page of the Freiburg benchmark (Kuemmerle et al. 2009),
  into $data/relations/NAME.relations or NAME.relations.gz.
A log without relations is mapped and shown, but not scored.
TEXT
