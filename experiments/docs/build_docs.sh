#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the documentation as a site: build_docs.sh [FOLDER], by default build/docs; its first page is
# FOLDER/html/index.html. Needs Doxygen (experiments/install_packages.sh docs) and the executables, in
# $GMAPPING_SPA_BINARIES or build/bin. Warnings are errors.
set -euo pipefail
cd "$(dirname "$0")/../.."

binaries=${GMAPPING_SPA_BINARIES:-build/bin}
folder=$(realpath -m "${1:-build/docs}")
command -v doxygen >/dev/null || {
  echo "build_docs.sh: doxygen is missing: experiments/install_packages.sh docs" >&2
  exit 1
}

executables=()
for name in gmapping_spa edit_closures inspect_log convert_log optimize_graph simulate simulate_slam drive evaluate_relations \
  evaluate_trajectory evaluate_map; do
  executables+=("$binaries/$name")
done
rm -rf "$folder"
mkdir -p "$folder/pages"
experiments/docs/flags_reference.py "${executables[@]}" >"$folder/pages/flags.md"
experiments/docs/flags_reference.py --check experiments/docs/*.md -- "${executables[@]}"
doxygen - <<SETTINGS
$(cat Doxyfile)
INPUT += "$folder/pages"
OUTPUT_DIRECTORY = "$folder"
STRIP_FROM_PATH += "$folder/pages"
SETTINGS
echo "$folder/html/index.html"
