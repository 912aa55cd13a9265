#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs a small study on a real Slurm, started here for this purpose, and again without it: both must
# give the same results. Needs a build in build/ and the rights to install packages, if they lack.
set -euo pipefail
cd "$(dirname "$0")/../../.."
root=$PWD
experiments/install_packages.sh experiments slurm

folder=$(mktemp -d)
chmod 755 "$folder"
export SLURM_CONF=$folder/slurm.conf
daemons=()
stop() {
  scontrol shutdown >/dev/null 2>&1 || true
  for pid in "${daemons[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait
  rm -rf "$folder"
}
trap stop EXIT

dd if=/dev/urandom of="$folder/munge.key" bs=1024 count=1 status=none
chmod 600 "$folder/munge.key"
munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
  --pid-file="$folder/munge.pid" --seed-file="$folder/munge.seed" \
  --log-file="$folder/munge.log" 2>"$folder/munged.err" &
daemons+=($!)

mkdir "$folder/state" "$folder/spool"
host=$(hostname -s)
memory_mb=$(free -m | awk '/^Mem/ { print $2 }')
cat >"$SLURM_CONF" <<END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
MailProg=/bin/true
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_interval=2
JobCompType=jobcomp/filetxt
JobCompLoc=$folder/completed.txt
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$memory_mb State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
slurmctld -D -c 2>"$folder/slurmctld.err" &
daemons+=($!)
slurmd -D 2>"$folder/slurmd.err" &
daemons+=($!)
for _ in $(seq 100); do
  [[ $(sinfo --noheader --format=%T 2>/dev/null) == idle ]] && break
  sleep 0.3
done
sinfo --noheader --format="Slurm %T with %c CPUs" | grep idle || {
  echo "Slurm does not start:" >&2
  tail -n 5 "$folder"/*.log "$folder"/*.err >&2
  exit 1
}

study=experiments/profiles/slurm/test_study.yaml
experiments/workflow/run_study.py "$study" --until scores --work_dir "$folder/slurm" \
  --profile experiments/profiles/slurm
experiments/workflow/run_study.py "$study" --until scores --work_dir "$folder/local"

# Slurm's own record of the jobs: 1 log, 4 runs of which 2 fail as they should, 4 scores.
for job in "make_log 1" "slam 4" "score 4"; do
  read -r name expected <<<"$job"
  found=$(grep -c " Name=$name .*JobState=COMPLETED" "$folder/completed.txt")
  if [[ $found != "$expected" ]]; then
    echo "Slurm completed $found jobs of $name, expected $expected" >&2
    exit 1
  fi
done
/usr/bin/python3 "$root/experiments/profiles/slurm/same_results.py" "$folder/slurm" "$folder/local"
