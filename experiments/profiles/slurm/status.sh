#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Tells Snakemake about a job: status.sh JOB_ID prints running, success or failed.
set -uo pipefail
answer=$(scontrol show job --oneliner "$1" 2>&1)
state=$(grep -oP '\bJobState=\K\w+' <<<"$answer")
if [[ -z $state && $answer == *"Invalid job id"* ]]; then
  # Slurm forgets finished jobs after a while; its data base, if there is one, does not.
  state=$(sacct --noheader --allocations --jobs="$1" --format=State%20 2>/dev/null |
    awk 'NR == 1 { print $1 }')
  state=${state:-UNKNOWN}
fi
case $state in
  COMPLETED) echo success ;;
  CONFIGURING | COMPLETING | PENDING | REQUEUED | RESIZING | RUNNING | STAGE_OUT | SUSPENDED)
    echo running ;;
  "") echo running ;;  # the controller does not answer just now
  *) echo failed ;;
esac
