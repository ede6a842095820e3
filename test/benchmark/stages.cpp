// SPDX-License-Identifier: BSD-3-Clause
// Measures the time of every stage of the library, and of PCL's normals and boundary points: stage x size x threads.
#include "library_stages.h"

#include <pcl_spiral/common/impl/thread_limit.h>

#include <exception>

using namespace pcl_spiral;
using namespace pcl_spiral::benchmarks;

namespace {

/** 1, 2, 4 and so on, and the number of processors. */
std::vector<int>
threadCounts()
{
  const int all = omp_get_num_procs();
  std::vector<int> counts;
  for (int n = 1; n < all; n *= 2)
    counts.push_back(n);
  counts.push_back(all);
  return counts;
}

void
runStage(benchmark::State& state, const Stage& stage, std::size_t points, int threads)
{
  try {
    StageInput& input = inputOf(points);
    const ThreadLimit limit(threads);
    stage.run(state, input, threads);
  }
  catch (const std::exception& error) {
    state.SkipWithError(error.what());
  }
}

/** Cases named stage/size/threads, size by size, so that each cloud is made once. */
void
registerAll(const std::vector<std::size_t>& sizes)
{
  std::vector<Stage> stages = libraryStages();
  for (const Stage& stage : pclStages())
    stages.push_back(stage);
  for (const std::size_t points : sizes)
    for (const Stage& stage : stages)
      for (const int threads : stage.parallel ? threadCounts() : std::vector<int>{1})
        benchmark::RegisterBenchmark((stage.name + ("/" + sizeName(points)) + "/" + std::to_string(threads) + "t").c_str(),
                                     [=](benchmark::State& state) { runStage(state, stage, points, threads); })
            ->UseRealTime()
            ->MeasureProcessCPUTime() // of all threads
            ->Unit(benchmark::kMillisecond);
}

} // namespace

int
main(int argc, char** argv)
{
  registerAll({10000, 86000, 200000, 500000, 1000000, 2000000, 12000000});
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
