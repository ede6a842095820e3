#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs one fuzzer, or all in sequence, starting with the inputs of earlier runs; the inputs stay in the build folder.
# Usage: run.sh BUILD_DIR SECONDS [FORMAT]...     exit code 1 if it finds a fault; its input is kept
set -uo pipefail
[ $# -ge 2 ] || { sed -n 3p "$0" >&2; exit 2; }
build=$(cd "$1" && pwd)/test/fuzz
seconds=$2
shift 2
[ $# -gt 0 ] || set -- pcd ply text stl obj las pts toolpath job machine

cd "$build" || exit 2
[ -d seeds ] || ./fuzz_seeds seeds
findings=0
TIMEFORMAT='%U s of processor time'
for format in "$@"; do
  mkdir -p "inputs/$format" "findings"
  options=(-max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -malloc_limit_mb=256 -max_len=4096 -print_final_stats=1)
  # VTK and yaml-cpp are not instrumented and keep memory: leaks are not checked.
  time { ASAN_OPTIONS=detect_leaks=0 "./fuzz_$format" "${options[@]}" -artifact_prefix="findings/$format-" \
    "inputs/$format" "seeds/$format" >"$format.log" 2>&1 || findings=1; }
  grep -E 'ERROR|SUMMARY|runtime error' "$format.log"
  printf '%s %s: %s; %s\n' "$(date -u +%H:%M)" "$format" "$(grep -E 'DONE|cov:' "$format.log" | tail -1)" \
    "$(grep -o 'number_of_executed_units: .*' "$format.log")"
done
exit $findings
