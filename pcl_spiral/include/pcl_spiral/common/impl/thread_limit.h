// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Sets the number of threads within a scope.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/setting.h>

#include <omp.h>

#include <algorithm>

namespace pcl_spiral {

/** Largest number of threads ever started: if the system refuses a thread, OpenMP ends the program. */
constexpr unsigned int most_threads = 256;

/** Ok, or an error for a number of threads that nobody means, such as -1 converted to an unsigned number. */
inline Status
checkThreads(unsigned int threads)
{
  if (threads <= most_threads)
    return Status::success();
  return {StatusCode::InvalidArgument,
          Diagnostic("the number of threads is ", threads, ": set 0 for all, or a count up to ", most_threads, " ({setNumberOfThreads})")};
}

/** A number of threads among the settings of a table. */
inline Setting
threadsSetting(unsigned int& threads)
{
  return Setting("threads", "setNumberOfThreads", "number of threads", "number of threads; the result does not depend on it", "4", threads)
      .in("", NumberRange::from(0.0).upTo(most_threads))
      .zeroFor("all");
}

/** The number of threads of a stage. Base of classes that have no other base with this setter. The base classes of PCL do not use
 *  the name of the member. */
class ThreadCount {
public:
  /** Threads to use; 0, the default, means all. The output does not depend on it. */
  void setNumberOfThreads(unsigned int threads = 0) { thread_count_ = threads; }
  unsigned int getNumberOfThreads() const { return thread_count_; } ///< The value of setNumberOfThreads.

protected:
  ThreadCount() = default;
  ~ThreadCount() = default;

  unsigned int thread_count_ = 0; ///< of setNumberOfThreads
};

/** While the object lives, parallel loops started in this thread use this number of threads; 0 means all processors, as in PCL
 *  (omp_get_num_procs). */
class ThreadLimit {
public:
  /** \p threads to use; 0: all. */
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
