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
missed=0

plant() { # FILE LINE: a fresh copy with LINE at the end of FILE must be refused, naming FILE
  rm -rf "${tree:?}"/*
  cp -r "$source_dir"/{pcl_spiral,examples,cmake,CMakeLists.txt,CMakePresets.json} "$tree"
  mkdir -p "$(dirname "$tree/$1")"
  [ -e "$tree/$1" ] || echo '// SPDX-License-Identifier: BSD-3-Clause' >"$tree/$1" # so that it is not this that is found
  printf '%s\n' "$2" >>"$tree/$1"
  if said=$(CLANG_FORMAT=none bash "$guards" "$tree" 2>&1) || ! grep -qF "$(dirname "$1")" <<<"$said"; then
    echo "not found: '$2' in $1" >&2
    missed=1
  fi
}

headers=pcl_spiral/include/pcl_spiral
plant $headers/core/polyline.h '#include <pcl/point_types.h>'
plant pcl_spiral/src/core/polyline.cpp '# include "pcl/point_cloud.h"'
plant $headers/core/polyline.h '#include <pcl_spiral/common/status.h>'
plant $headers/common/status.h '#include <pcl_spiral/surface/mls_projector.h>'
plant $headers/surface/impl/planted.hpp '#include <pcl_spiral/geodesic/geodesic_path.h>'
plant pcl_spiral/src/cutter/planted.cpp '#include <pcl_spiral/io/toolpath_writer.h>'
plant $headers/utils/planted.h '#pragma once'
plant $headers/core/planted.h '#pragma once'
plant $headers/toolpath/tool_axis.h 'struct Planted {};'
plant pcl_spiral/src/mesh/planted.cpp '#include "drive/line_gaps.h"'
plant pcl_spiral/src/spiral/lines/segment_set.h '#include "spiral/loops/loop_finder.h"'
plant pcl_spiral/src/io/read/text_scan.h '#include "io/post/post_text.h"'
plant pcl_spiral/src/visualization/sheet.h '#include "visualization/viewer/viewer_keys.h"'
plant pcl_spiral/src/mesh/planted/planted.h '#pragma once'
plant $headers/common/status.h "// $(yes x | head -n 140 | tr -d '\n')"
plant $headers/common/status.h 'struct Planted { int threads_ = 0; };'
plant $headers/spiral/spiral_settings.h 'struct Planted { int chunk_size_ = 0; };'
plant pcl_spiral/src/core/polyline.cpp 'const char* const planted = "thin it (--thin)";'
plant pcl_spiral/src/core/polyline.cpp 'const char* const planted = "thin it (setThinning)";'
plant pcl_spiral/src/core/polyline.cpp 'const char* const planted = " mm are left";'
plant pcl_spiral/src/core/polyline.cpp 'const std::string planted = "take {mm}";'
plant pcl_spiral/src/core/polyline.cpp 'const char* const planted = "the {skan} is empty";'
plant pcl_spiral/tools/terminal/scan_side.cpp 'const Diagnostic planted = "start it in {header: [G55]}";'
plant pcl_spiral/src/spiral/settings_check.cpp 'const char* const planted = "set it ({setPlanted})";'
plant pcl_spiral/src/planning/plan_regions.cpp 'const char* const planted = "set it ({setPlanted})";'
plant pcl_spiral/tools/drive/planning.cpp 'void planted() try {} catch (...) {}'
plant pcl_spiral/src/planning/plan_regions.cpp 'void planted() try {} catch (...) {}'
plant pcl_spiral/tools/terminal/scan_side.cpp 'const bool planted = status.message().find("gap") > 0;'
plant pcl_spiral/tools/terminal/scan_side.cpp 'const Diagnostic planted = surface->warnings().front();'
plant pcl_spiral/src/core/polyline.cpp 'void planted(const int& n) { const_cast<int&>(n) = 0; }'
plant pcl_spiral/src/ridge/planted.h 'class OutlineSide {};'
plant CMakeLists.txt 'add_compile_options(-march=native)'
plant pcl_spiral/CMakeLists.txt 'target_compile_options(pcl_spiral PRIVATE -ffast-math)'
plant cmake/planted.cmake 'add_compile_definitions(PCL_NO_PRECOMPILE)'
plant pcl_spiral/src/core/polyline.cpp '#pragma GCC optimize("fast-math")'
plant $headers/common/impl/progress.h '/** Of \p shares in the work. */
double percentOf(double share);'
plant $headers/common/status.h 'enum class Planted { One, Two };'
plant $headers/common/status.h 'enum class Planted {
  One, ///< the first
  Two
};'
plant examples/example_step_over.cpp "$(yes '// more' | head -n 61)"
plant examples/example_stage_by_stage.cpp "$(yes '// more' | head -n 20)"
plant pcl_spiral/doc/stage_by_stage.md '```cpp
surface->noSuchFunction();
```'
plant pcl_spiral/doc/constants_path.md '| `tie = 1.5` in `src/spiral/method_choice.cpp` | ratio | planted | planted |'
plant pcl_spiral/doc/code_map.md 'See `src/spiral/planted.cpp`.'
plant pcl_spiral/doc/limits.md "$(yes 'more' | head -n 150)"
exit $missed
