#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The guards pass the project's own tree and find every fault planted in a copy of it; README's program is the one
# that the consumer test builds and runs.
# Usage: run.sh SOURCE_DIR
set -euo pipefail
source_dir=$1
guards=$source_dir/cmake/guards.sh
bash "$guards" "$source_dir"

diff <(sed -n '/^```cpp$/,/^```$/ { /^```/d; p }' "$source_dir/README.md") <(grep -v SPDX "$source_dir/test/consumer/cxx_only/main.cpp") ||
  { echo "README's program differs from test/consumer/cxx_only/main.cpp" >&2; exit 1; }

tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cp -r "$source_dir"/{pcl_spiral,examples,cmake,CMakeLists.txt,CMakePresets.json} "$tree"

# All faults stand in one copy. No guard is meant to find two of them in one file: what it says of the file is of this fault alone.
titles=() found_in=() lines=()
plant() { # TITLE FILE LINE [FOUND]: puts LINE at the end of FILE; the guard of that TITLE is to name FILE, or what it FOUND
  mkdir -p "$(dirname "$tree/$2")"
  [ -e "$tree/$2" ] || echo '// SPDX-License-Identifier: BSD-3-Clause' >"$tree/$2" # so that it is not this that is found
  printf '%s\n' "$3" >>"$tree/$2"
  titles+=("$1") found_in+=("${4:-$2}") lines+=("$3")
}

headers=pcl_spiral/include/pcl_spiral
sources=pcl_spiral/src
plant 'core stands on Eigen alone' $headers/core/polyline.h '#include <pcl/point_types.h>'
plant 'core stands on Eigen alone' $sources/core/polyline.cpp '# include "pcl/point_cloud.h"'
plant 'core includes common, which' $headers/core/polyline.h '#include <pcl_spiral/common/status.h>'
plant 'common includes surface, which' $headers/common/status.h '#include <pcl_spiral/surface/mls_projector.h>'
plant 'cleaning includes surface, which' $sources/cleaning/planted.cpp '#include "surface/gap_filling.h"'
plant 'spiral includes ridge, which' $headers/spiral/impl/planted.hpp '#include <pcl_spiral/ridge/ridge_surface.h>'
plant 'results are named Report' $headers/core/polyline.h 'struct PlantedFigures {'
plant 'surface includes geodesic, which' $headers/surface/impl/planted.hpp '#include <pcl_spiral/geodesic/geodesic_path.h>'
plant 'cutter includes io, which' $sources/cutter/planted.cpp '#include <pcl_spiral/io/toolpath_writer.h>'
plant 'mesh includes drive, which' $sources/mesh/planted.cpp '#include "drive/line_gaps.h"'
plant 'spiral/lines includes spiral/loops, which' $sources/spiral/lines/segment_set.h '#include "spiral/loops/loop_finder.h"'
plant 'io/read includes io/post, which' $sources/io/read/text_scan.h '#include "io/post/post_text.h"'
plant 'visualization/. includes visualization/viewer, which' $sources/visualization/sheet.h '#include "visualization/viewer/viewer_keys.h"'
plant 'folder without a place in the layers' $headers/utils/planted.h '#pragma once' $headers/utils/
plant 'folder without a place in its room' $sources/mesh/planted/planted.h '#pragma once' $sources/mesh/planted/
plant 'public headers that are in neither' $headers/core/planted.h '#pragma once'
plant 'forwarding header with more than one include' $headers/toolpath/tool_axis.h 'struct PlantedAxis {};'
plant 'classes with the same name' $sources/ridge/planted.h 'class OutlineSide {};'
plant 'newer PCL base classes' $headers/common/status.h 'struct PlantedStatus { int threads_ = 0; };'
plant 'newer PCL base classes' $headers/spiral/spiral_settings.h 'struct PlantedSettings { int chunk_size_ = 0; };'
plant 'messages of the library name setters' $sources/core/polyline.cpp 'const char* const planted = "thin it (--thin)";'
plant 'names of settings typed' $sources/core/polyline.cpp 'const char* const planted = "thin it (setThinning)";'
plant 'units typed' $sources/core/polyline.cpp 'const char* const planted = " mm are left";'
plant 'fields in a text that is no diagnostic' $sources/core/polyline.cpp 'const std::string planted = "take {mm}";'
plant 'fields of sentences' $sources/core/polyline.cpp 'const char* const planted = "the {skan} is empty";'
plant 'fields of sentences' pcl_spiral/tools/terminal/scan_side.cpp 'const Diagnostic planted = "start it in {header: [G55]}";'
plant 'setters in sentences without an option' $sources/spiral/settings_check.cpp 'const char* const planted = "set it ({setPlanted})";'
plant 'setters in sentences of planners' $sources/planning/plan_regions.cpp 'const char* const planted = "set it ({setPlanted})";'
plant 'planning steered by exceptions' pcl_spiral/tools/drive/planning.cpp 'void planted() try {} catch (...) {}'
plant 'planning steered by exceptions' $sources/planning/plan_regions.cpp 'void planted() try {} catch (...) {}'
plant 'sentences searched or cut' pcl_spiral/tools/terminal/scan_side.cpp 'const bool planted = status.message().find("gap") > 0;'
plant 'sentences searched or cut' pcl_spiral/tools/drive/planning.cpp 'const Diagnostic planted = surface->warnings().front();'
plant 'constants changed by a cast' $sources/core/polyline.cpp 'void planted(const int& n) { const_cast<int&>(n) = 0; }'
plant 'flags that break' CMakeLists.txt 'add_compile_options(-march=native)' ./CMakeLists.txt
plant 'flags that break' pcl_spiral/CMakeLists.txt 'target_compile_options(pcl_spiral PRIVATE -ffast-math)' ./pcl_spiral/CMakeLists.txt
plant 'flags that break' cmake/planted.cmake 'add_compile_definitions(PCL_NO_PRECOMPILE)' ./cmake/planted.cmake
plant 'pragmas that break' $sources/core/polyline.cpp '#pragma GCC optimize("fast-math")'
plant 'lines of over 140' $headers/common/status.h "// $(yes x | head -n 140 | tr -d '\n')"
: >"$tree/$sources/core/planted.h"
plant 'files without the line of their licence' $sources/core/planted.h '#pragma once'
plant 'examples that are too long' examples/example_step_over.cpp "$(yes '// more' | head -n 61)"
plant 'examples that are too long' examples/example_stage_by_stage.cpp "$(yes '// more' | head -n 20)"
plant 'lines of code that are in no example' pcl_spiral/doc/stage_by_stage.md '```cpp
surface->noSuchFunction();
```'
plant 'constants on a page' pcl_spiral/doc/constants_path.md '| `tie = 1.5` in `src/spiral/method_choice.cpp` | ratio | planted | planted |'
plant 'files that a page names' pcl_spiral/doc/code_map.md 'See `src/spiral/planted.cpp`.'
plant 'pages of over 150 lines' pcl_spiral/doc/limits.md "$(yes 'more' | head -n 150)"
plant 'names that are not in the declaration' $headers/common/impl/progress.h '/** Of \p shares in the work. */
double percentOf(double share);'
plant 'values of a public enumeration' $headers/common/status.h 'enum class PlantedRow { One, Two };'
plant 'values of a public enumeration' $headers/spiral/spiral_settings.h 'enum class PlantedColumn {
  One, ///< the first
  Two
};'

if CLANG_FORMAT=none bash "$guards" "$tree" >"$tree/said" 2>&1; then
  echo "the guards pass a tree with faults" >&2
  exit 1
fi
missed=0
for n in "${!titles[@]}"; do
  # a guard's report is a paragraph: its title, then what it found
  awk -v RS= -v title="${titles[n]}" -v found="${found_in[n]}" \
    'index($0, title) == 1 && index($0, "\n" found) + index($0, " " found) { named = 1 } END { exit !named }' "$tree/said" ||
    { echo "not found under '${titles[n]}': '${lines[n]%%$'\n'*}' in ${found_in[n]}" >&2; missed=1; }
done
exit $missed
