#!/usr/bin/env bash
# One job of the array: shard.sh PROGRAM PARTS SHARDS COMMAND... makes part SLURM_ARRAY_TASK_ID of SHARDS.
set -euo pipefail
program=$1 parts=$2 shards=$3
shift 3
part="$parts/part-$SLURM_ARRAY_TASK_ID"
if [ -d "$part" ]; then
  echo "part $SLURM_ARRAY_TASK_ID is there"
  exit 0
fi
resume=()
[ ! -d "$part.partial" ] || resume=(--resume)  # this job was stopped before
code=0
"$program" "$@" --shard "$SLURM_ARRAY_TASK_ID/$shards" --threads "${SLURM_CPUS_PER_TASK:-1}" --out "$part" \
  "${resume[@]}" || code=$?
# 1: some tasks could not be made, which the merge tells; the part itself is whole.
if [ "$code" -eq 1 ] && [ -d "$part" ]; then code=0; fi
exit "$code"
