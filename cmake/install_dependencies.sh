#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the missing Debian packages: as root or with sudo; otherwise it lists them.
# Usage: install_dependencies.sh [build] [test] [display] [benchmark] [fuzz] [sanitizers] [lint] [doc] [python] [wheel] [releases]
# (without names: build)
set -euo pipefail

build=(g++ cmake ninja-build ccache libpcl-dev libvtk9-dev libx11-dev libeigen3-dev libboost-dev
  libboost-program-options-dev nlohmann-json3-dev libyaml-cpp-dev liblz4-dev
  libjs-three # shows the part in reports; it is put into the library
  file) # by which cpack finds what a .deb depends on
test=(libgtest-dev pkg-config groff-base linuxcnc-uspace linuxcnc-uspace-dev admesh chromium) # linuxcnc: its interpreter rs274 and its planner run our programs; admesh counts faults of meshes; chromium opens reports
display=(xvfb xauth libgl1-mesa-dri) # pictures where there is no screen
benchmark=(libbenchmark-dev libcgal-dev) # CGAL's slicer of meshes runs beside ours
fuzz=(clang libclang-rt-dev) # libFuzzer; no test needs it
sanitizers=(clang libclang-rt-dev libomp-dev) # presets asan and tsan
lint=(clang-format-14 clang-tidy-14 libomp-14-dev) # other versions break lines elsewhere and have other checks; in Debian 12
doc=(doxygen)
python=(python3-dev pybind11-dev python3-numpy # the module, and arrays that it takes and gives
  python3-pytest mypy) # its tests, and the check of its types
wheel=(python3-venv python3-scikit-build-core) # pip install ./pcl_spiral/python; Debian 13
releases=(debootstrap git) # tests on bare Debian releases

wanted=()
for group in "${@:-build}"; do
  case "$group" in
    build) wanted+=("${build[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    display) wanted+=("${display[@]}") ;;
    benchmark) wanted+=("${benchmark[@]}") ;;
    fuzz) wanted+=("${fuzz[@]}") ;;
    sanitizers) wanted+=("${sanitizers[@]}") ;;
    lint) wanted+=("${lint[@]}") ;;
    doc) wanted+=("${doc[@]}") ;;
    python) wanted+=("${python[@]}") ;;
    wheel) wanted+=("${wheel[@]}") ;;
    releases) wanted+=("${releases[@]}") ;;
    *)
      echo "unknown group '$group': name build, test, display, benchmark, fuzz, sanitizers, lint, doc, python, wheel or releases" >&2
      exit 2
      ;;
  esac
done

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "This is no Debian system, so nothing is checked or installed. Needed, by Debian's names: ${wanted[*]}" >&2
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "Packages: all there."
  exit 0
fi

if [ "$(id -u)" -eq 0 ]; then
  as_root=(env)
elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
  as_root=(sudo env)
else
  echo "Missing packages, and neither root nor sudo at hand. Have an administrator run:" >&2
  echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
  exit 1
fi
echo "Packages: installing ${missing[*]}"
"${as_root[@]}" apt-get update -q || echo "apt-get update failed; trying with the lists that are there" >&2
"${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
