#!/usr/bin/env bash
# Generates a data set on a Slurm cluster: an array of jobs, one per shard, and a job that merges them when all succeeded.
set -euo pipefail

usage() {
  cat <<'TEXT'
Usage: submit.sh --shards N --out DIR [OPTIONS] -- benchmark|training|generate [OPTIONS OF unietp]

  submit.sh --shards 100 --out /shared/ten-million -- training --count 10000000
  submit.sh --shards 2 --out /shared/mine -- generate --count 200 --seed 7 --modes M1,M2

  --shards N         Number of shards, each a job of its own; 2 or more
  --out DIR          The data set, on a disk visible from all nodes; DIR.parts/ gets shards and logs
  --at-once N        Shards that run at the same time (default: no limit)
  --cpus N           Processors per shard (default: 1)
  --memory SIZE      Memory per shard (default: 2G)
  --time LIMIT       Time limit of a shard (default: the partition's)
  --partition NAME   Slurm partition (default: the cluster's)
  --program FILE     The program (default: unietp on the PATH)
  --sbatch OPTION    Anything else for sbatch, such as --sbatch=--account=me; can be repeated
  --wait             Wait for the merge and return its exit code; 2 when a shard failed, so that nothing was merged
  --help

A shard that is requeued goes on where it stopped. Giving the same command again redoes what is missing: shards that are
there already end at once. The bytes are those that one process would have made.
TEXT
}

fail() { echo "submit.sh: $*" >&2; exit 2; }

shards='' out='' at_once='' cpus=1 memory=2G wait='' program=unietp extra=() limits=()
while [ $# -gt 0 ]; do
  case "$1" in
    --help) usage; exit 0 ;;
    --wait) wait=--wait; shift; continue ;;
    --) shift; break ;;
    --sbatch=*) extra+=("${1#--sbatch=}"); shift; continue ;;
    --*) [ $# -ge 2 ] || fail "$1 needs a value" ;;
    *) fail "unexpected \"$1\"; put the unietp command after --" ;;
  esac
  case "$1" in
    --shards) shards=$2 ;;
    --out) out=$2 ;;
    --at-once) at_once=$2 ;;
    --cpus) cpus=$2 ;;
    --memory) memory=$2 ;;
    --time) limits+=("--time=$2") ;;
    --partition) extra+=("--partition=$2") ;;
    --program) program=$2 ;;
    --sbatch) extra+=("$2") ;;
    *) fail "unknown option $1; see --help" ;;
  esac
  shift 2
done
[[ "$shards" =~ ^[1-9][0-9]*$ && "$shards" != 1 ]] || fail "--shards needs an integer >= 2"
[ -n "$out" ] || fail "--out is missing"
case "${1:-}" in
  benchmark | training | generate) ;;
  *) fail "expected benchmark, training or generate after --" ;;
esac
for option in "$@"; do
  case "$option" in
    --out | --out=* | --shard | --shard=* | --threads | --threads=* | --resume) fail "$option is set by the jobs" ;;
  esac
done
program=$(command -v "$program") || fail "cannot find the program unietp; set it with --program"
program=$(realpath "$program")
[ ! -e "$out" ] || fail "$out exists already; a new folder is expected"
command -v sbatch > /dev/null || fail "there is no sbatch here; this runs where jobs are submitted"

here=$(dirname "$(realpath "$0")")
out=$(realpath -m "$out")
parts="$out.parts"
mkdir -p "$parts/logs"
array="1-$shards${at_once:+%$at_once}"
array_job=$(sbatch --parsable --requeue --job-name=unietp-shard --array="$array" --cpus-per-task="$cpus" \
  --mem="$memory" --output="$parts/logs/shard-%a.log" --open-mode=append "${limits[@]}" "${extra[@]}" \
  "$here/shard.sh" "$program" "$parts" "$shards" "$@")
array_job=${array_job%%;*}
echo "array $array_job: $shards shards, logs in $parts/logs"
echo "merge: after $array_job, into $out"
code=0
sbatch $wait --parsable --job-name=unietp-merge --dependency="afterok:$array_job" --kill-on-invalid-dep=yes \
  --mem="$memory" --output="$parts/logs/merge.log" --open-mode=append "${extra[@]}" \
  "$here/merge.sh" "$program" "$parts" "$shards" "$out" || code=$?
[ -n "$wait" ] && [ ! -d "$out" ] || exit "$code"

# Slurm reports success for a merge that it canceled because a shard failed, so the folders decide.
for ((k = 1; k <= shards; ++k)); do
  [ -d "$parts/part-$k" ] || echo "submit.sh: shard $k failed: see $parts/logs/shard-$k.log" >&2
done
echo "submit.sh: $out was not made: see $parts/logs; the same command redoes only what is missing" >&2
[ "$code" -ne 0 ] || code=2
exit "$code"
