#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds everything and runs every test. Installs missing packages on a Debian system.
# Usage: test/run.sh [options for ctest]     build folder: build, or PCL_SPIRAL_BUILD_DIR
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${PCL_SPIRAL_BUILD_DIR:-$top/build}

bash "$top/cmake/install_dependencies.sh" build test display python

echo "Configuring $build"
cmake -G Ninja -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release -DPCL_SPIRAL_BUILD_TESTS=ON \
  -DPCL_SPIRAL_BUILD_EXAMPLES=ON -DPCL_SPIRAL_BUILD_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3

# A compiler process needs up to 1.7 GB, some tests as much.
memory_jobs=$(awk '/MemAvailable/ { print int($2 / 1.8e6) }' /proc/meminfo)
jobs=$(nproc)
[ "$memory_jobs" -ge "$jobs" ] || jobs=$((memory_jobs > 0 ? memory_jobs : 1))
echo "Building with $jobs jobs"
cmake --build "$build" --parallel "$jobs"

# Threads that spin while they wait slow the tests beside them 3.5 times. Programs with both do not start again.
export OMP_WAIT_POLICY=passive GLIBC_TUNABLES=glibc.malloc.hugetlb=1

echo "Testing with $jobs tests at a time"
display=()
[ -n "${DISPLAY:-}" ] || display=(xvfb-run -a -s "-screen 0 1280x1024x24")
"${display[@]}" ctest --test-dir "$build" --parallel "$jobs" --output-on-failure "$@"
