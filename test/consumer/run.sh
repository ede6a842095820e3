#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the build, makes outside programs against it, runs them, moves the installation, runs them again.
# Usage: run.sh BUILD_DIR [option for the outside programs' cmake ...]
set -euo pipefail
build=$1
shift
options=("$@")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
first="$scratch/first prefix"
second="$scratch/second prefix"
# The same cache entries whatever the scratch folder is called, for compilers that start in it.
export CCACHE_BASEDIR=$scratch CCACHE_NOHASHDIR=1

fail() { echo "consumer: $*" >&2; exit 1; }

make_program() { # NAME PREFIX BUILD: configures and builds an outside program, installs it beside the library
  # X11 is for windows, which none of them opens
  cmake -G Ninja -S "$here/$1" -B "$3" "${options[@]}" -DCMAKE_DISABLE_FIND_PACKAGE_X11=ON -DCMAKE_PREFIX_PATH="$2" \
    -DCMAKE_INSTALL_PREFIX="$2" >"$scratch/log" 2>&1 ||
    { cat "$scratch/log"; fail "$1 does not configure"; }
  cmake --build "$3" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "$1 does not build"; }
  cmake --install "$3" >/dev/null
}

make_by_pkg_config() { # NAME PACKAGE PREFIX: the same sources as NAME, by pkg-config and the bare compilers
  local compile link source compiler objects=() # pkg-config escapes blanks as a shell does, hence eval
  compile=$(PKG_CONFIG_PATH="$3/lib/pkgconfig" pkg-config --cflags "$2")
  link=$(PKG_CONFIG_PATH="$3/lib/pkgconfig" pkg-config --libs "$2")
  for source in "$here/$1"/*.c "$here/$1"/*.cpp; do
    [ -e "$source" ] || continue
    objects+=("$scratch/$1_$(basename "$source").o")
    compiler="${CXX:-c++} ${CXXFLAGS:-} -std=c++17"
    [[ $source != *.c ]] || compiler=${CC:-cc}
    (cd "$scratch" && eval "$compiler -c -o \"\${objects[-1]}\" \"\$source\" $compile")
  done
  eval "${CXX:-c++} ${CXXFLAGS:-} -o \"\$3/bin/$1_by_pkg_config\" \"\${objects[@]}\" $link '-Wl,-rpath,\$ORIGIN/../lib'"
}

refuse_without_lz4() { # PREFIX: FLANN's headers call it, so a program cannot do without; the remedy is named
  ! cmake -Dlz4_LIBRARY= "$scratch/c_and_cxx" >"$scratch/log" 2>&1 || fail "c_and_cxx configures without lz4"
  grep -q liblz4-dev "$scratch/log" || { cat "$scratch/log"; fail "a missing lz4 is not named"; }
  PKG_CONFIG_PATH="$1/lib/pkgconfig" pkg-config --print-requires pcl_spiral | grep -qx liblz4 || fail "pcl_spiral.pc does not name lz4"
}

run_toolpath() { # PROGRAM: the README's program makes a path of the simulated scan
  rm -f "$scratch/path.csv"
  "$1" "$scratch/dome.pcd" "$scratch/path.csv" 2>"$scratch/log" || { cat "$scratch/log"; fail "'$1' fails"; }
  [ "$(wc -l <"$scratch/path.csv")" -gt 1000 ] || fail "'$1' wrote no path"
}

run_stages() { # PROGRAM: the path made stage by stage says how many turns it has
  "$1" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "'$1' fails"; }
  grep -qE '^[1-9][0-9]+ turns, ' "$scratch/log" || { cat "$scratch/log"; fail "'$1' names no turns"; }
}

run_all() { # PREFIX
  "$1/bin/pcl_spiral_simulate_scan" -o "$scratch/dome.pcd" --line-spacing 4 --point-spacing 3 ||
    fail "the installed program fails in '$1'"
  run_toolpath "$1/bin/cxx_only"
  run_toolpath "$1/bin/cxx_only_by_pkg_config"
  "$1/bin/c_and_cxx" || fail "c_and_cxx fails in '$1'"
  "$1/bin/c_and_cxx_by_pkg_config" || fail "c_and_cxx, by pkg-config, fails in '$1'"
  run_stages "$1/bin/stages"
}

cmake --install "$build" --prefix "$first" >/dev/null
make_program cxx_only "$first" "$scratch/cxx_only"
make_program c_and_cxx "$first" "$scratch/c_and_cxx"
make_program stages "$first" "$scratch/stages"
make_by_pkg_config cxx_only pcl_spiral_io "$first"
make_by_pkg_config c_and_cxx pcl_spiral "$first"
refuse_without_lz4 "$first"
run_all "$first"
# With a sanitizer clang links whatever is named (--no-as-needed), and keeps the names of sources for its reports.
sanitized=$([[ "${options[*]}" == *-fsanitize* ]] && echo yes || echo no)
if [ "$sanitized" = no ] && readelf -d "$first/bin/c_and_cxx" | grep -E 'NEEDED.*(vtk|Qt)'; then
  fail "a program that wants the filters alone was linked to the libraries above"
fi
if [ "$sanitized" = no ]; then
  for program in "$first"/bin/pcl_spiral_*; do
    if ldd "$program" | grep pcl_features; then
      fail "'$program' loads pcl_features, and needs nothing of it"
    fi
  done
fi

mv "$first" "$second"
run_all "$second"
said=$(grep -rlF -e "$first" "$second" || true)
[ -z "$said" ] || [ "$sanitized" = yes ] || fail "these installed files know where they were first: $said"
said=$(grep -rlFI -e "$build" "$second" || true)
[ -z "$said" ] || fail "these installed files know the build folder: $said"
make_program cxx_only "$second" "$scratch/cxx_only_again"
run_toolpath "$second/bin/cxx_only"
