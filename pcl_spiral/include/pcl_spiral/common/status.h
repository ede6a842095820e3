/** \file
 *  The outcome of a computation, kept by every class of pcl_spiral.
 */
#pragma once

#include <string>
#include <utility>

namespace pcl_spiral {

/** Why a computation ended as it did. */
enum class StatusCode {
  Ok,              ///< done
  NotComputed,     ///< compute has not been called yet
  InvalidArgument, ///< a setting is missing, out of range, contradicts another, or does not fit the cloud
  InvalidInput,    ///< the cloud cannot be worked on (empty, too few points, closed, several parts ...)
  Failed,          ///< the computation met something it cannot solve on this surface
  Cancelled        ///< the progress callback asked to stop
};

/** Outcome of the last compute: a code, and a message that names what was wrong, where, and what to do. */
class Status {
public:
  Status() = default;
  Status(StatusCode code, std::string message) : code_(code), message_(std::move(message)) {}

  static Status
  success()
  {
    return Status(StatusCode::Ok, "done");
  }

  bool
  ok() const
  {
    return code_ == StatusCode::Ok;
  }
  StatusCode
  code() const
  {
    return code_;
  }
  /** What went wrong, the place and value, and the remedy; one or more sentences. */
  const std::string&
  message() const
  {
    return message_;
  }

private:
  StatusCode code_ = StatusCode::NotComputed;
  std::string message_ = "compute has not been called";
};

} // namespace pcl_spiral
