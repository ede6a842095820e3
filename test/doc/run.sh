#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Doxygen has nothing to say of the project's own headers and pages: every public member has a comment. It finds every fault
# planted in a copy of them.
# Usage: run.sh SOURCE_DIR
set -euo pipefail
source_dir=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() { echo "doc: $*" >&2; exit 1; }

document() { # SOURCE_DIR OUTPUT_DIR
  cmake -DSOURCE_DIR="$1" -DOUTPUT_DIR="$2" -P "$source_dir/cmake/make_doc.cmake"
}

html=$scratch/own/html
document "$source_dir" "$scratch/own"
grep -q 'setPlanner' "$html/classpcl__spiral_1_1SpiralToolpathGenerator.html" || fail "a class is missing"
grep -q 'Two commands' "$html/index.html" || fail "README is not the first page"
for picture in "$source_dir"/pcl_spiral/doc/*.png; do
  grep -q "src=\"$(basename "$picture")\"" "$html"/md_*.html "$html/index.html" || fail "no page shows $picture"
  [ -s "$html/$(basename "$picture")" ] || fail "$picture is not beside the page"
done
[ -z "$(find "$html" -name '*_8hpp*.html' -o -name '*_8cpp*.html')" ] || fail "more than the public headers is documented"

mkdir -p "$scratch/tree/pcl_spiral/doc"
cp -r "$source_dir/pcl_spiral/include" "$scratch/tree/pcl_spiral"
cp "$source_dir/README.md" "$scratch/tree"
cat >>"$scratch/tree/pcl_spiral/include/pcl_spiral/common/status.h" <<'PLANTED'
namespace pcl_spiral {
/** Planted. \param shares of the work */
double percentOf(double share);
/** Planted. \unknowncommand */
double secondPlanted();
double thirdPlanted();
/** Planted. */
struct FourthPlanted {
  double without_comment = 0.0;
};
}
PLANTED
sed -i 's| ///< The value of setNumberOfThreads.||' "$scratch/tree/pcl_spiral/include/pcl_spiral/common/impl/thread_limit.h"
printf '# A page\nSee \\ref NoSuchClass.\n' >"$scratch/tree/pcl_spiral/doc/planted.md"
if said=$(document "$scratch/tree" "$scratch/planted" 2>&1); then
  fail "planted faults are not found"
fi
for fault in "status.h.*argument 'shares'" "status.h.*unknowncommand" "status.h.*thirdPlanted.* not documented" \
  "status.h.*without_comment.* not documented" "thread_limit.h.*getNumberOfThreads.* not documented" "planted.md.*NoSuchClass"; do
  grep -q "$fault" <<<"$said" || fail "not found: $fault in: $said"
done
