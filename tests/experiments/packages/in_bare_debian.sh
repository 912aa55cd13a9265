#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs in a bare Debian 12 that has the packages in /packages: installs them with what they depend on, and
# nothing else, and looks whether they do their work.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive
install() { apt-get install -y -qq --no-install-recommends "$@" >/dev/null; }
step() { echo "== $*"; }

step "the runtime package alone"
apt-get update -qq
install /packages/gmapping-spa_*.deb
gmapping_spa --version
cd "$(mktemp -d)"
data=/usr/share/gmapping_spa
for program in gmapping_spa convert_log edit_closures inspect_log optimize_graph simulate simulate_slam drive evaluate_relations \
  evaluate_trajectory evaluate_map; do
  "$program" --help >/dev/null
  test -s "/usr/share/man/man1/$program.1" || test -s "/usr/share/man/man1/$program.1.gz"
  test -s "/usr/share/bash-completion/completions/$program"
done

step "the quickstart"
simulate --world=$data/worlds/paper_building.yaml \
  --path=$data/worlds/paper_building.short.path.yaml --output_dir=simulated --seed=1
gmapping_spa --log=simulated/log.clf --output_dir=slam
gmapping_spa --flagfile=$data/flags/paper.flags --log=simulated/log.clf --output_dir=paper
evaluate_trajectory --truth=simulated/truth.tum --trajectory=slam/trajectory.tum >errors.json
test -s slam/map.png

step "every back end, in a process of its own too"
for backend in spa ceres none; do
  optimize_graph --input=slam/graph.g2o --backend=$backend >$backend.json
done
optimize_graph --input=slam/graph.g2o --backend_timeout_s=60 >process.json

step "the development package"
install cmake g++ make
install /packages/libgmapping-spa-dev_*.deb
examples=/usr/share/doc/libgmapping-spa-dev/examples
cmake -S $examples -B examples >/dev/null
cmake --build examples
examples/map_a_log simulated/log.clf mapped
cmp mapped.pgm slam/map.pgm
examples/swap_back_end simulated/log.clf
cmake -S $examples/back_end -B back_end -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build back_end
examples/optimize_a_graph >square.g2o
optimize_graph --input=square.g2o \
  --backend="$PWD/back_end/libgmapping_spa_dense_gauss_newton.so" --loss=none >dense.json

step "the Python package"
install /packages/python3-gmapping-spa_*.deb
python3 - <<'PYTHON'
import gmapping_spa

assert {"ceres", "none", "spa"} <= {back_end["name"] for back_end in gmapping_spa.list_backends()}
slam = gmapping_spa.Slam()
for scan in gmapping_spa.CarmenLog("simulated/log.clf"):
    slam.add_scan(scan)
slam.finish()
gmapping_spa.write_g2o("python.g2o", slam.graph)
PYTHON
cmp python.g2o slam/graph.g2o

step "removed, nothing is left"
apt-get remove -y -qq gmapping-spa libgmapping-spa-dev python3-gmapping-spa >/dev/null
left=$(find /usr -name '*gmapping*')
[[ -z $left ]] || {
  echo "expected no file of the packages, found $left" >&2
  exit 1
}
