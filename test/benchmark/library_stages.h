// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The stages that are timed.
 */
#pragma once

#include "stage_input.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace pcl_spiral::benchmarks {

/** A stage: it makes its input, times itself on \p threads threads and says how many points and bytes it took. */
struct Stage {
  const char* name;
  void (*run)(benchmark::State& state, StageInput& input, int threads);
  bool parallel = true; ///< false: the same for any number of threads, so run on one alone
};

/** Those of the library, in the order of a run. */
std::vector<Stage> libraryStages();

/** PCL's normals and boundary points of the same cloud, in random and in spatial order. */
std::vector<Stage> pclStages();

/** Say what one iteration took: items and bytes per second. */
void count(benchmark::State& state, std::size_t items, std::size_t bytes);

} // namespace pcl_spiral::benchmarks
