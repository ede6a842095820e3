/** \file
 *  A number of threads for the length of a scope.
 */
#pragma once

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/common/status.h>

#include <omp.h>

#include <algorithm>

namespace pcl_spiral {

/** More are never started: where the system refuses one, OpenMP ends the program. */
constexpr unsigned int most_threads = 256;

/** Ok, or a number of threads that nobody means, such as -1 turned into an unsigned number. */
inline Status
checkThreads(unsigned int threads)
{
  if (threads <= most_threads)
    return Status::success();
  return {StatusCode::InvalidArgument, textOf("the number of threads is ", threads, ": set 0 for all, or a count up to ",
                                              most_threads, " (setNumberOfThreads)")};
}

/** The number of threads of a stage. Base of those that have no other class to take it from; the name of the member is none that
 *  PCL's bases use. */
class ThreadCount {
public:
  /** Threads to use; 0, the default, means all. The output does not depend on it. */
  void setNumberOfThreads(unsigned int threads = 0) { thread_count_ = threads; }
  unsigned int getNumberOfThreads() const { return thread_count_; }

protected:
  ThreadCount() = default;
  ~ThreadCount() = default;

  unsigned int thread_count_ = 0;
};

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
