#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs every command of doc/scans.md on the published scans: its turns and length, or its refusal, are those that the page reports.
# Usage: run.sh PROGRAM PAGE FOLDER       exit code 77 without the folder of the scans
set -euo pipefail
program=$1 page=$2 scans=$3
if [ ! -d "$scans" ]; then
  echo "skipped: no folder $scans with the published scans; set PCL_SPIRAL_SCANS to it and configure again"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_WAIT_POLICY=passive GLIBC_TUNABLES=glibc.malloc.hugetlb=1

passed=0 failed=0
while read -r command; do
  read -r expected
  expected=${expected#\# }
  read -ra words <<< "$command"
  status=0
  "$program" "$scans/${words[1]}" "${words[@]:2}" -o "$work/part.csv" > "$work/out" 2> "$work/err" || status=$?
  if [ "$status" -eq 0 ]; then
    turns=$(sed -n 's/^spiral  *\([0-9]*\) turns.*/\1/p' "$work/out")
    metres=$(sed -n 's/^path length  *\([0-9.]*\) m.*/\1/p' "$work/out")
    found=$(printf '%s turns, %.1f m' "$turns" "$metres")
  else
    found="refused: $(cat "$work/err")"
  fi
  case "$found" in
    "$expected") ;;
    "refused: "*"${expected#refused: }"*) [ "${expected#refused: }" != "$expected" ] ;;
    *) false ;;
  esac && passed=$((passed + 1)) || {
    failed=$((failed + 1))
    printf 'FAILED: %s\n  the page: %s\n  found (exit %s): %s\n' "$command" "$expected" "$status" "$found"
  }
done < <(sed -n '/^```sh/,/^```/p' "$page" | grep -A1 '^pcl_spiral_toolpath ' | grep -v '^--$')
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
