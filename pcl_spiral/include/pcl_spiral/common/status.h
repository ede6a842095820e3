// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Result, progress and cost of a computation.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace pcl_spiral {

/** Why a computation ended. */
enum class StatusCode {
  Ok,              ///< done
  NotComputed,     ///< compute has not been called yet
  InvalidArgument, ///< a setting is missing, out of range, contradicts another, or does not fit the cloud
  InvalidInput,    ///< the cloud cannot be used (empty, too few points, closed, several parts ...)
  Failed,          ///< the computation met a problem that it cannot solve on this surface
  Cancelled        ///< the progress callback asked to stop
};

/** Result of the last compute: a code, and a diagnostic with the fault, the place and the remedy. */
class Status {
public:
  Status() = default; ///< Not computed.
  /** A result with what is said of it. */
  Status(StatusCode code, Diagnostic diagnostic) : code_(code), diagnostic_(std::move(diagnostic)) {}
  /** The same in words of the code. */
  Status(StatusCode code, const char* words) : Status(code, Diagnostic(words)) {}
  /** The same in a text from outside, in which nothing is a field. */
  Status(StatusCode code, const std::string& text) : Status(code, Diagnostic(text)) {}

  static Status success() { return Status(StatusCode::Ok, "done"); } ///< Done.
  /** The status while a computation runs, and after an exception has left it. */
  static Status unfinished()
  {
    return Status(StatusCode::Failed, "compute did not end: an exception left it, as one that the progress callback throws; catch it there "
                                      "and return false to cancel");
  }

  bool ok() const { return code_ == StatusCode::Ok; } ///< Whether the computation succeeded.
  StatusCode code() const { return code_; }           ///< Why it ended.
  /** The fault, the place and value, and the remedy, as data. */
  const Diagnostic& diagnostic() const { return diagnostic_; }
  /** The text of diagnostic(), in the words of C++; one or more sentences. */
  const std::string& message() const { return diagnostic_.text(); }

private:
  StatusCode code_ = StatusCode::NotComputed;
  Diagnostic diagnostic_ = "compute has not been called";
};

/** Called with the share done, 0 to 1, and the name of the stage. Return false to cancel. Called from one thread only. */
using ProgressCallback = std::function<bool(double share, const std::string& stage)>;

/** Memory of this process, bytes, as Linux reports it in /proc/self/status, to about 1 MB; 0 if not known. */
struct MemoryUse {
  std::size_t resident = 0; ///< in main memory now (VmRSS): of the process itself and of the library pages it used
  std::size_t peak = 0;     ///< the maximum since the process began (VmHWM)
};

/** Wall time of one stage, and the memory of the whole process at its end. If the peak is above that of the stage before, this
 *  stage raised it. */
struct StageCost {
  std::string name;     ///< of the stage
  double seconds = 0.0; ///< wall time
  MemoryUse memory;     ///< of the process at the end of the stage
};

} // namespace pcl_spiral
