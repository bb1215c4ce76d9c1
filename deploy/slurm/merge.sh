#!/usr/bin/env bash
# The job after the array: merge.sh PROGRAM PARTS SHARDS OUT puts the parts together.
set -euo pipefail
program=$1 parts=$2 shards=$3 out=$4
folders=()
for ((k = 1; k <= shards; ++k)); do folders+=("$parts/part-$k"); done
exec "$program" merge "${folders[@]}" --out "$out"
