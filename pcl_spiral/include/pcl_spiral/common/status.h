// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The result of a computation, which every class of pcl_spiral keeps.
 */
#pragma once

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

/** Result of the last compute: a code, and a message with the fault, the place and the remedy. */
class Status {
public:
  Status() = default;
  Status(StatusCode code, std::string message) : code_(code), message_(std::move(message)) {}

  static Status success() { return Status(StatusCode::Ok, "done"); }

  bool ok() const { return code_ == StatusCode::Ok; }
  StatusCode code() const { return code_; }
  /** The fault, the place and value, and the remedy; one or more sentences. */
  const std::string& message() const { return message_; }

private:
  StatusCode code_ = StatusCode::NotComputed;
  std::string message_ = "compute has not been called";
};

} // namespace pcl_spiral
