#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs in a bare Debian 12 that has the packages in /packages: installs them with what they depend on, and
# nothing else, and looks whether they do their work.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive
install() { apt-get install -y -qq --no-install-recommends "$@" >/dev/null; }
step() { echo "== $*"; }
fail() {
  echo "in_bare_debian.sh: $*" >&2
  exit 1
}

step "the runtime package alone"
apt-get update -qq
install /packages/gmapping-spa_*.deb
cd "$(mktemp -d)"
gmapping_spa --version | tee version.txt
package=$(dpkg-query -W -f='${Version}' gmapping-spa)
if [[ $package == *~git* ]]; then
  commit=${package##*.}
  grep -qF "${commit%+changed}" version.txt || fail "expected a build of the commit of package $package"
fi
data=/usr/share/gmapping_spa
for program in $(dpkg -L gmapping-spa | sed -n 's|^/usr/bin/||p'); do
  "$program" --help >/dev/null
  test -s "/usr/share/man/man1/$program.1" || test -s "/usr/share/man/man1/$program.1.gz"
  test -s "/usr/share/bash-completion/completions/$program"
done
ros=$(dpkg-query -W -f='${db:Status-Abbrev}${Package} ' | grep -oE 'ii (lib|python3-)?ros[a-z0-9-]*' || true)
[[ -z $ros ]] || fail "expected nothing of ROS, found $ros"

step "the quickstart"
simulate --world=$data/worlds/paper_building.yaml \
  --path=$data/worlds/paper_building.short.path.yaml --output_dir=simulated --seed=1
gmapping_spa --log=simulated/log.clf --output_dir=slam
gmapping_spa --flagfile=$data/flags/paper.flags --log=simulated/log.clf --output_dir=paper
evaluate_trajectory --truth=simulated/truth.tum --trajectory=slam/trajectory.tum >errors.json
test -s slam/map.png

step "a bag, and loop closures edited by hand"
convert_log --log=simulated/log.clf --output=log.bag
inspect_log --log=log.bag >inspected.txt
gmapping_spa --log=log.bag --output_dir=bag --save_session=robot.session
edit_closures --session=robot.session --closures=bag/loop_closures.csv --output_dir=edited
test -s edited/map.png

step "the page of a run, which is in the program"
touch view.txt
gmapping_spa --view=slam --view_port=0 2>view.txt &
viewer=$!
for ((tries = 0; tries < 100; ++tries)); do
  port=$(sed -n 's|^view: http://127.0.0.1:\([0-9]*\)/$|\1|p' view.txt)
  [[ -z $port ]] || break
  sleep 0.1
done
[[ -n $port ]] || fail "expected the address of a page, found $(cat view.txt)"
exec 3<>"/dev/tcp/127.0.0.1/$port"
printf 'GET / HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nConnection: close\r\n\r\n' "$port" >&3
timeout 10 cat <&3 >page.html
kill $viewer
grep -q '<html' page.html

step "every back end, in a process of its own too"
for backend in spa ceres none; do
  optimize_graph --input=slam/graph.g2o --backend=$backend >$backend.json
done
optimize_graph --input=slam/graph.g2o --backend_timeout_s=60 >process.json

step "man and Tab"
install bash-completion man-db
man edit_closures >page.txt
grep -q 'loop_closures.csv' page.txt
apropos -s 1 'pose graph' | grep -q '^optimize_graph '
bash --norc -c '
  source /usr/share/bash-completion/bash_completion
  _completion_loader convert_log
  [[ $(complete -p convert_log) == "complete -F _gmapping_spa_complete convert_log" ]]'

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

step "the example in Python"
install python3-matplotlib
python3 /usr/share/doc/python3-gmapping-spa/examples/example.py example.png
test -s example.png

step "removed, nothing is left"
apt-get remove -y -qq gmapping-spa libgmapping-spa-dev python3-gmapping-spa >/dev/null
left=$(find /usr -name '*gmapping*')
[[ -z $left ]] || fail "expected no file of the packages, found $left"
