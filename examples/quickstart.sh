#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes a spiral toolpath, a report and pictures of a scan. Installs missing packages on a Debian system.
# Usage: examples/quickstart.sh [SCAN] [options of pcl_spiral_toolpath]
#   without SCAN it simulates a line-laser scan of a tank dome, for a ball of 10 mm radius and a scallop of 0.05 mm
#   with SCAN, give the cutter: examples/quickstart.sh part.ply --tool-radius 6 --scallop 0.02
# It also writes a program for LinuxCNC's XYZAC machine (examples/machines/xyzac.yaml); of your own scan only with --machine FILE.
# The files are written to quickstart_output in the current folder.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${PCL_SPIRAL_BUILD_DIR:-$top/build}
output=$PWD/quickstart_output

case "${1:-}" in
  -h | --help) sed -n '3,8s/^# //p' "${BASH_SOURCE[0]}"; exit 0 ;;
  "" | -*) scan= ;;
  *)
    scan=$1
    shift
    [ -r "$scan" ] || { echo "$scan: no such file, or not readable" >&2; exit 1; }
    ;;
esac
options=("$@")

default() { # OPTION VALUE: adds it unless the user gave it, or a job file that may hold it
  local given
  for given in ${options[@]+"${options[@]}"}; do
    case "$given" in "$1" | "$1="* | --config | --config=*) return ;; esac
  done
  options+=("$1" "$2")
}

groups=(build)
display=()
if [ -z "${DISPLAY:-}" ]; then # pictures need a display
  groups+=(display)
  display=(xvfb-run -a -s "-screen 0 1280x1024x24")
fi
bash "$top/cmake/install_dependencies.sh" "${groups[@]}"

echo "Building the programs in $build (a few minutes the first time)"
if [ ! -f "$build/CMakeCache.txt" ]; then
  cmake -G Ninja -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release -DPCL_SPIRAL_BUILD_TESTS=OFF >/dev/null
fi
cmake --build "$build" --target pcl_spiral_toolpath pcl_spiral_verify pcl_spiral_view pcl_spiral_simulate_scan

mkdir -p "$output"
if [ -z "$scan" ]; then
  scan=$output/dome.pcd
  echo "Simulating a scan"
  "$build/bin/pcl_spiral_simulate_scan" -o "$scan"
  default --tool-radius 10
  default --scallop 0.05
  default --machine "$top/examples/machines/xyzac.yaml"
  default --tool 1
  default --spindle 8000
fi

name=$(basename "$scan")
part=$output/${name%.*}_spiral
program=()
machine=
for ((i = 0; i < ${#options[@]}; ++i)); do
  case "${options[i]}" in --machine) machine=${options[i + 1]:-} ;; --machine=*) machine=${options[i]#*=} ;; esac
done
[ -z "$machine" ] || program=(-o "$part.ngc")
echo "Making the toolpath"
"${display[@]}" "$build/bin/pcl_spiral_toolpath" "$scan" -o "$part.csv" -o "$part.vtp" -o "$part.json" \
  -o "$part.png" -o "$part.html" ${program[@]+"${program[@]}"} --verify ${options[@]+"${options[@]}"}

echo "Written:"
ls -1 "$part"*

same=() # the scan and the cutter as the report has them, for the other programs
report=$(tr -d ' \n' <"$part.json")
as_made() { # OPTION FIELD VALUE_TO_LEAVE_OUT
  local value=
  if [[ $report =~ \"$2\":(\[([^]]*)\]|\"?([^\",}]*)) ]]; then value=${BASH_REMATCH[2]}${BASH_REMATCH[3]}; fi
  [ "$value" = "$3" ] || same+=("$1" "$value")
}
as_made --tool-radius tool_radius ""
as_made --scallop scallop ""
as_made --chord-error chord_error 0.005
as_made --units unit mm
as_made --origin origin 0.0,0.0,0.0
as_made --view-point view_point null
case "$report" in *'"flip_normals":true'*) same+=(--flip-normals) ;; esac
for ((i = 0; i < ${#options[@]}; ++i)); do
  case "${options[i]}" in --columns) same+=("${options[@]:i:2}") ;; --columns=*) same+=("${options[i]}") ;; esac
done
call() { # WORD ...: as a line to copy into a shell
  local word
  for word; do
    case "$word" in *[!A-Za-z0-9_./,:=+-]*) printf ' %q' "$word" ;; *) printf ' %s' "$word" ;; esac
  done
  echo
}
[ -z "$machine" ] || echo "Before the first run of $part.ngc ($machine): check work zero, tool length, limits and clamps, and run it above the part"
echo "To look at it in a window, and to judge it again:"
call "$build/bin/pcl_spiral_view" "$scan" "$part.csv" "${same[@]}"
call "$build/bin/pcl_spiral_verify" "$scan" "$part.csv" "${same[@]}"
[ -z "$machine" ] || call "$build/bin/pcl_spiral_verify" "$scan" "$part.ngc" --machine "$machine" "${same[@]}"
