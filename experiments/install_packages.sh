#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the packages of Debian 12 or Ubuntu 24.04 that the project needs, where they are missing and
# this user may.
#   install_packages.sh [checks] [docs] [experiments] [fuzz] [packages] [python] [ros] [slurm]
# checks: formatting and clang-tidy; docs: the documentation as a site; experiments: studies and their
# reports; fuzz: Clang with its sanitizers and libFuzzer; packages: what makes Debian packages and tests
# them; python: the Python module and its example; ros: the node for ROS 1 and its test; slurm: a Slurm on
# this machine, to test studies on clusters.
set -euo pipefail

packages=(
  # building
  cmake g++ make ninja-build pkg-config
  # libraries
  libboost-dev libboost-iostreams-dev libbz2-dev libcairo2-dev libcereal-dev libceres-dev
  libeigen3-dev libgflags-dev libgoogle-glog-dev liblz4-dev libmetis-dev libpng-dev librandom123-dev libsqlite3-dev
  libssl-dev libstb-dev libsuitesparse-dev libyaml-cpp-dev libzstd-dev nlohmann-json3-dev
  # tests and scripts
  googletest libbenchmark-dev libgmock-dev libgtest-dev python3
)
for option in "$@"; do
  case $option in
    checks) packages+=(clang-format clang-tidy) ;;
    docs) packages+=(doxygen) ;;
    experiments)
      packages+=(python3-jinja2 python3-matplotlib python3-numpy python3-pil python3-scipy
        python3-yaml snakemake)
      # Ubuntu has it as a snap only; the test that looks at a report in a browser is skipped there.
      grep -q '^ID=ubuntu' /etc/os-release || packages+=(chromium chromium-driver)
      ;;
    fuzz) packages+=(clang libclang-rt-dev llvm) ;;  # llvm: reports name lines
    packages) packages+=(dpkg-dev file groff-base lintian man-db mmdebstrap) ;;
    python) packages+=(pybind11-dev python3-dev python3-matplotlib python3-numpy python3-venv) ;;
    ros)
      # Ubuntu has ROS in archives of its own only.
      packages+=(libdiagnostic-msgs-dev libnav-msgs-dev libroscpp-dev libsensor-msgs-dev libstd-srvs-dev
        libtf2-msgs-dev libtf2-ros-dev libvisualization-msgs-dev python3-diagnostic-msgs python3-nav-msgs
        python3-numpy python3-rosbag python3-roslaunch python3-rospy python3-std-srvs python3-tf2-msgs
        python3-visualization-msgs)
      ;;
    slurm) packages+=(munge slurm-client slurmctld slurmd) ;;
    *)
      echo "install_packages.sh: expected 'checks', 'docs', 'experiments', 'fuzz', 'packages', 'python', 'ros' or 'slurm', found '$option'" >&2
      exit 1
      ;;
  esac
done

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [[ $status == "install ok installed" ]] || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

if [[ $(id -u) -eq 0 ]]; then
  as_root=(env)
elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
  as_root=(sudo)
else
  echo "These Debian packages are missing, and this user may not install them:" >&2
  echo "  ${missing[*]}" >&2
  echo "Ask an administrator to run: apt-get install ${missing[*]}" >&2
  exit 1
fi
echo "Installing ${missing[*]}" >&2
"${as_root[@]}" apt-get update -qq >&2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
