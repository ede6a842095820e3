/** \file
 *  A number of threads for the length of a scope.
 */
#pragma once

#include <omp.h>

#include <algorithm>

namespace pcl_spiral {

/** More are never started: where the system refuses one, OpenMP ends the program. */
constexpr unsigned int most_threads = 256;

/** Parallel loops started in this thread use a number of threads while the object lives; 0 means all processors, as in PCL
 *  (omp_get_num_procs). */
class ThreadLimit {
public:
  explicit ThreadLimit(unsigned int threads) : before_(omp_get_max_threads())
  {
    const auto processors = static_cast<unsigned int>(omp_get_num_procs());
    omp_set_num_threads(static_cast<int>(std::min(threads > 0 ? threads : processors, most_threads)));
  }
  ~ThreadLimit() { omp_set_num_threads(before_); }
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
  int before_;
};

} // namespace pcl_spiral
