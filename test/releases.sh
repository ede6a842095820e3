#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the quick start and every test on bare Debian releases, makes the wheel of Python, and compares the bytes of the quick start's path.
# Usage: releases.sh [--again] [RELEASE ...] [options for ctest]     default: bookworm and trixie
#   --again  continues in the root of the last run, with its packages and build folder; otherwise a fresh copy of the bare root
# Needs root, and packages: cmake/install_dependencies.sh releases. Mirror, proxy and credentials are those of this
# system's apt. Takes at least half an hour per release, so it is not part of .ci/run.
# PCL_SPIRAL_RELEASES_DIR (/var/tmp/pcl_spiral_releases) keeps roots, packages and compiled objects, about 4 GB
# per release. Exit code 1 if something fails or the bytes differ.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
scratch=${PCL_SPIRAL_RELEASES_DIR:-/var/tmp/pcl_spiral_releases}

fail() { echo "releases: $*" >&2; exit 2; }

make_bare_root() { # RELEASE: once; debootstrap fetches by itself, so it is given the proxy of apt
  local proxy=
  [ -d "$scratch/$1/bare" ] && return
  eval "$(apt-config shell proxy Acquire::http::Proxy)"
  mkdir -p "$scratch/$1"
  rm -rf "$scratch/$1/bare.part"
  env ${proxy:+"http_proxy=$proxy"} debootstrap --variant=minbase "$1" "$scratch/$1/bare.part" "$mirror" \
    >"$scratch/$1/debootstrap.log" 2>&1 || fail "no bare root of $1, see $scratch/$1/debootstrap.log"
  mv "$scratch/$1/bare.part" "$scratch/$1/bare"
}

use_network_of_host() { # ROOT: names, certificates and what apt was told about fetching
  local file
  for file in /etc/resolv.conf /etc/hosts /etc/ssl/certs/ca-certificates.crt; do
    if [ -e "$file" ]; then install -D -m 644 "$file" "$1$file"; fi
  done
  apt-config dump Acquire | grep -v '^Acquire::IndexTargets' >"$1/etc/apt/apt.conf.d/90host"
}

copy_sources() { # ROOT: what a clone has
  mkdir -p "$1/src/pcl_spiral"
  find "$1/src/pcl_spiral" -mindepth 1 -maxdepth 1 ! -name 'build*' -exec rm -rf {} +
  git -C "$top" archive HEAD | tar -xm -C "$1/src/pcl_spiral"
}

# shellcheck disable=SC2317 # called in another shell
enter_root() { # ROOT KEPT COMMAND ...: runs in namespaces of its own, which take its mounts and processes with them
  local root=$1 kept=$2 name proxies=()
  shift 2
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  mount --bind "$kept/archives" "$root/var/cache/apt/archives"
  mount --bind "$kept/ccache" "$root/var/cache/ccache"
  for name in /etc/apt/auth.conf /etc/apt/auth.conf.d; do # credentials are shown, never copied
    if [ -d "$name" ]; then mkdir -p "$root$name"; elif [ -e "$name" ]; then touch "$root$name"; else continue; fi
    mount --bind "$name" "$root$name"
  done
  for name in http_proxy https_proxy no_proxy; do
    [ -z "${!name:-}" ] || proxies+=("$name=${!name}")
  done
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin CCACHE_DIR=/var/cache/ccache "${proxies[@]}" chroot "$root" "$@"
}

run_in_root() { # RELEASE COMMAND ...; bash stays the first process, for Xvfb reports to none with the number 1
  local kept=$scratch/$1
  shift
  mkdir -p "$kept/archives/partial" "$kept/ccache" "$kept/root/var/cache/ccache"
  setpriv --pdeathsig KILL unshare --mount --pid --ipc --fork --kill-child \
    bash -euo pipefail -c "$(declare -f enter_root); enter_root \"\$@\"" enter_root "$kept/root" "$kept" "$@"
}

step() { # RELEASE NAME COMMAND ...: says whether it passed, and how long it took
  local release=$1 name=$2 begin=$SECONDS result=passed took
  local log=$scratch/$release/$name.log
  shift 2
  run_in_root "$release" "$@" >"$log" 2>&1 </dev/null || result="FAILED, see $log"
  took=$((SECONDS - begin))
  echo "$release: $name $result ($((took / 60)) min $((took % 60)) s)"
  [ "$result" = passed ] || { tail -n 25 "$log"; failed=1; }
}

wheel='cd /src/pcl_spiral && bash cmake/install_dependencies.sh build python wheel
  rm -rf /venv && python3 -m venv --system-site-packages /venv
  /venv/bin/pip install --no-build-isolation --no-deps ./pcl_spiral/python
  cd / && /venv/bin/python -c "import pcl_spiral; print(pcl_spiral.__file__)" | grep ^/venv/'

run_release() { # RELEASE
  local root=$scratch/$1/root path=/src/pcl_spiral/quickstart_output/dome_spiral.csv sum=none
  make_bare_root "$1"
  if [ -z "$again" ] || [ ! -d "$root" ]; then
    rm -rf "$root"
    cp -a "$scratch/$1/bare" "$root"
  fi
  use_network_of_host "$root"
  copy_sources "$root"
  step "$1" quickstart bash -c 'cd /src/pcl_spiral && bash examples/quickstart.sh'
  step "$1" tests bash /src/pcl_spiral/test/run.sh "${ctest_options[@]}"
  [ "$1" = bookworm ] || step "$1" wheel bash -euc "$wheel" # whose backend is not in Debian 12
  [ ! -r "$root$path" ] || sum=$(sha256sum <"$root$path" | cut -c 1-64)
  echo "$1: sha256 of the quick start's path $sum"
  sums+=("$sum")
}

again=
[ "${1:-}" != --again ] || { again=yes; shift; }
releases=()
while [ $# -gt 0 ] && [[ $1 != -* ]]; do
  releases+=("$1")
  shift
done
[ ${#releases[@]} -gt 0 ] || releases=(bookworm trixie)
ctest_options=("$@")

[ "$(id -u)" -eq 0 ] || fail "a bare root needs the right to change root: run it as root or through sudo"
for program in debootstrap git; do
  command -v $program >/dev/null || fail "$program is missing: run cmake/install_dependencies.sh releases"
done
mirror=$(apt-get indextargets --format "\$(SITE)" 'Identifier: Packages' 'Origin: Debian' 'Label: Debian' | sed -n 1p)
[ -n "$mirror" ] || fail "apt knows no Debian mirror: name one in its sources and run apt-get update"

failed=0
sums=()
for release in "${releases[@]}"; do
  run_release "$release"
done
if [ "$(printf '%s\n' "${sums[@]}" | sort -u | wc -l)" -gt 1 ]; then
  echo "The quick start's bytes DIFFER between releases"
  failed=1
fi
exit $failed
