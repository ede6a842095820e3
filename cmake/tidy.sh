#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs clang-tidy over the library's sources and headers with the checks of .clang-tidy. Fails on any find.
# Usage: tidy.sh [PATTERN]     PATTERN: only batches whose path has it, such as src_io (a regular expression)
# It goes by the batches of the build (cmake/batches.cmake), since each source alone reads the headers of PCL anew: a batch takes about as
# long as a file. Needs the packages of install_dependencies.sh build lint. TIDY_JOBS: processes at a time, each up to 2 GB.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${PCL_SPIRAL_TIDY_DIR:-$top/build-tidy}
clang_tidy=${CLANG_TIDY:-clang-tidy-14}
jobs=${TIDY_JOBS:-$(nproc)}
command -v "$clang_tidy" >/dev/null || { echo "tidy: $clang_tidy is missing: bash cmake/install_dependencies.sh lint" >&2; exit 2; }

cmake -G Ninja -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DPCL_SPIRAL_UNITY_BUILD=ON \
  -DPCL_SPIRAL_BUILD_TESTS=OFF -DPCL_SPIRAL_BUILD_EXAMPLES=OFF >/dev/null
sources() {
  sed -n 's/^ *"file": "\(.*\)",\?$/\1/p' "$build/compile_commands.json" | grep -E "/pcl_spiral/" | grep -E "${1:-.}" | sort -u
}
found=$(sources "${1:-}")
[ -n "$found" ] || { echo "tidy: no batch has '${1:-}' in its path" >&2; exit 2; }
# A batch includes sources, which is what suspicious-include looks for; GCC's own warning flags are unknown to clang.
xargs -r -d '\n' -P "$jobs" -n 1 "$clang_tidy" -p "$build" --quiet --checks=-bugprone-suspicious-include --extra-arg=-Wno-unknown-warning-option <<<"$found"
