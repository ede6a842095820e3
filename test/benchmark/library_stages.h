// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The timed stages.
 */
#pragma once

#include "stage_input.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace pcl_spiral::benchmarks {

/** A stage: it makes its input, measures its time on \p threads threads and reports its number of points and bytes. */
struct Stage {
  const char* name;
  void (*run)(benchmark::State& state, StageInput& input, int threads);
  bool parallel = true; ///< false: the same for any number of threads, so it runs only on one
};

/** The stages of the library, in the order of a run. */
std::vector<Stage> libraryStages();

/** PCL's normals and boundary points of the same cloud, in random and in spatial order. */
std::vector<Stage> pclStages();

/** Reports the size of one iteration: items and bytes per second. */
void count(benchmark::State& state, std::size_t items, std::size_t bytes);

} // namespace pcl_spiral::benchmarks
