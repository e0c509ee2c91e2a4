#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs every libFuzzer target for some seconds, two at a time: run_targets.sh SECONDS [BUILD_DIR].
# FUZZ_SEED says where the search starts: always the same unless it is set, so that a failure can be had again.
# Fails when a target crashes (its reproducer is kept and named) or ran fewer than 1000 inputs.
set -eu

seconds=${1:?usage: run_targets.sh SECONDS [BUILD_DIR]}
here=$(cd "$(dirname "$0")" && pwd)
targets=${2:-$here/../build/fuzz}/fuzz/targets
work=$(mktemp -d)
least=1000
seed=${FUZZ_SEED:-1}

run_one() {
  name=$1
  mkdir -p "$work/$name/corpus" "$work/$name/found"
  # Mesh readers' corpora are named by their formats. libFuzzer adds what it finds: to a copy.
  cp "$here/corpus/${name#read_}"/* "$work/$name/corpus/"
  status=0
  TMPDIR="$work/$name" "$targets/${name}_fuzzer" -max_total_time="$seconds" -seed="$seed" \
    -max_len=4096 -timeout=25 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix="$work/$name/found/" "$work/$name/corpus" \
    > "$work/$name/log" 2>&1 || status=$?
  echo "$status" > "$work/$name/status"
}

names=$(cd "$targets" && ls ./*_fuzzer 2>/dev/null | sed 's|^\./||; s|_fuzzer$||')
[ -n "$names" ] || { echo "no fuzz targets in $targets: build the preset fuzz first" >&2; exit 2; }

set -- $names
while [ $# -gt 0 ]; do
  run_one "$1" &
  first=$!
  if [ $# -gt 1 ]; then
    run_one "$2" &
    wait $!
    shift
  fi
  wait $first
  shift
done

failed=0
for name in $names; do
  log=$work/$name/log
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  coverage=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)
  runs=${runs:-0}
  echo "$name: $runs executions, ${coverage:-0} edges covered"
  if [ "$(cat "$work/$name/status")" != 0 ]; then
    failed=1
    grep -a -B 2 -A 12 'ERROR: \|runtime error\|no complaint\|breaks\|differs' "$log" | head -n 40
    echo "$name FAILED, reproducer: $(ls "$work/$name/found"/* 2>/dev/null | tr '\n' ' ')(log: $log)"
  elif [ "$runs" -lt "$least" ]; then
    failed=1
    echo "$name FAILED: fewer than $least executions (log: $log)"
  fi
done
[ $failed -ne 0 ] || rm -rf "$work"
exit $failed
