#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What an installation and the .deb have: the programs, a man page for each, machine files, licence and pages; no example.
# And a library without pictures configures on a system without X11.
# Usage: run.sh BUILD_DIR SOURCE_DIR
set -euo pipefail
build=$1
source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
programs=(drive ridge simulate_scan toolpath verify view)

fail() { echo "package: $*" >&2; exit 1; }

words() { sed 's/[][,:]//g' | tr -s '[:space:]' '\n' | sort -u; }

check_page() { # PROGRAM PAGE: its parts are there, every word of --help too, and groff has no warning
  local said section missing
  said=$(groff -man -ww -z "$2" 2>&1)
  [ -z "$said" ] || fail "groff on $2: $said"
  for section in NAME SYNOPSIS DESCRIPTION OPTIONS "EXIT STATUS" "SEE ALSO"; do
    grep -qx ".SH $section" "$2" || fail "$2 has no $section"
  done
  "$1" --help >"$scratch/help"
  groff -man -Tascii -P-cbou -rLL=200n "$2" >"$scratch/page"
  missing=$(comm -23 <(words <"$scratch/help") <(words <"$scratch/page") | grep -vxE 'Exit|code|Options' || true)
  [ -z "$missing" ] || fail "$2 lacks what --help says: $missing"
}

check_tree() { # PREFIX
  local name link found
  found=$(cd "$1/bin" && echo *)
  [ "$found" = "$(printf 'pcl_spiral_%s ' "${programs[@]}" | sed 's/ $//')" ] || fail "$1/bin has $found"
  for name in "${programs[@]}"; do
    check_page "$1/bin/pcl_spiral_$name" "$1/share/man/man1/pcl_spiral_$name.1"
  done
  diff -r "$source/examples/machines" "$1/share/pcl_spiral/machines" || fail "other machine files in $1"
  cmp "$source/LICENSE" "$1/share/doc/pcl_spiral/LICENSE" || fail "no licence in $1"
  if [ -e /usr/share/javascript/three/three.min.js ]; then
    grep -q 'three.js authors' "$1/share/doc/pcl_spiral/LICENSE.three.js" || fail "no licence of three.js in $1"
  fi
  for link in $(grep -oE '\]\([a-z_/]+\.(md|png)\)' "$1/share/doc/pcl_spiral/README.md" | tr -d '()]'); do
    [ -e "$1/share/doc/pcl_spiral/$link" ] || fail "README.md names $link, which is not in $1"
  done
  found=$(find "$1" -name 'example_*')
  [ -z "$found" ] || fail "examples were installed: $found"
}

check_python() { # PREFIX: the package of Python, if it was built, finds its libraries there
  [ -d "$build/python/pcl_spiral" ] || return 0
  PYTHONPATH=$1/lib/python3/dist-packages /usr/bin/python3 -B -c "
import pcl_spiral, sys
assert pcl_spiral.__file__.startswith(sys.argv[1]), pcl_spiral.__file__
libraries = [line.split()[-1] for line in open('/proc/self/maps') if 'libpcl_spiral' in line]
assert libraries and all(library.startswith(sys.argv[1]) for library in libraries), libraries" "$1" || fail "no package of Python in $1"
}

cmake --install "$build" --prefix "$scratch/prefix" >/dev/null
check_tree "$scratch/prefix"
check_python "$scratch/prefix"

cpack --config "$build/CPackConfig.cmake" -G DEB -B "$scratch/cpack" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "cpack fails"; }
for package in "$scratch"/cpack/*.deb; do
  dpkg-deb -x "$package" "$scratch/deb"
done
check_tree "$scratch/deb/usr"
check_python "$scratch/deb/usr"

cmake -G Ninja -S "$source" -B "$scratch/without" -DPCL_SPIRAL_BUILD_VISUALIZATION=OFF -DCMAKE_DISABLE_FIND_PACKAGE_X11=ON \
  >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "the filters do not configure without X11"; }
cmake --build "$scratch/without" --target help >"$scratch/targets"
! grep -q visualization "$scratch/targets" || fail "the pictures are built although they are not wanted"

# Components: what runs, without what compiles.
for component in libraries programs; do
  cmake --install "$build" --prefix "$scratch/parts" --component "$component" >/dev/null
done
"$scratch/parts/bin/pcl_spiral_toolpath" --version >/dev/null || fail "the programs do not run from their components"
found=$(cd "$scratch/parts" && find . -name '*.h' -o -name '*.cmake' -o -name '*.pc')
[ -z "$found" ] || fail "the components libraries and programs have $found"

# As a subproject: the libraries alone, and the parent keeps its own settings and names of targets.
mkdir "$scratch/parent"
cat >"$scratch/parent/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.22)
project(parent LANGUAGES C CXX)
add_custom_target(doc)
enable_testing()
add_subdirectory("$source" pcl_spiral)
if(CMAKE_BUILD_TYPE OR CMAKE_CXX_STANDARD OR CMAKE_CXX_COMPILER_LAUNCHER)
  message(FATAL_ERROR "the subproject sets what is the parent's")
endif()
file(WRITE "$scratch/main.cpp" "#include <pcl_spiral/core/step_over.h>\nint main() { return 0; }\n")
add_executable(own "$scratch/main.cpp")
target_link_libraries(own PRIVATE pcl_spiral::pcl_spiral)
END
cmake -G Ninja -S "$scratch/parent" -B "$scratch/parent_build" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "the subproject does not configure"; }
cmake --build "$scratch/parent_build" --target help >"$scratch/targets"
found=$(grep -oE '^(test_|example_|pcl_spiral_(toolpath|drive|ridge|verify|view|programs|acceptance))[a-z_]*' "$scratch/targets" || true)
[ -z "$found" ] || fail "the subproject builds $found"
grep -q '^CMAKE_BUILD_TYPE:[A-Z]*=$' "$scratch/parent_build/CMakeCache.txt" || fail "the subproject sets the parent's build type"
mkdir "$scratch/nothing"
cmake --install "$scratch/parent_build" --prefix "$scratch/nothing" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "the subproject installs itself with the parent"; }
found=$(find "$scratch/nothing" -type f)
[ -z "$found" ] || fail "the subproject installs $found"
