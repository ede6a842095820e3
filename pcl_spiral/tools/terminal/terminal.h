// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Usage errors, progress, cancelling and times on a terminal.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <stdexcept>
#include <string>
#include <utility>

/** A wrong command line; the message names the option, the value and the remedy. */
class UsageError : public std::runtime_error {
public:
  explicit UsageError(pcl_spiral::Diagnostic said) : std::runtime_error(said.text()), diagnostic_(std::move(said)) {}

  const pcl_spiral::Diagnostic& diagnostic() const { return diagnostic_; } ///< What what() says, as data.

private:
  pcl_spiral::Diagnostic diagnostic_;
};

/** The user has cancelled the run. */
class Cancelled : public std::runtime_error {
public:
  Cancelled() : std::runtime_error("cancelled; no output has been written") {}
};

/** From now on ctrl-C, a request to end and a closed terminal (SIGINT, SIGTERM, SIGHUP) only set what cancelled returns,
 * and a file beyond the size limit of the shell (SIGXFSZ) is a write error. */
void catchSignals();

bool cancelled();

/** A progress bar on stderr if that is a terminal; nothing if it is piped. */
class ProgressBar {
public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();

  /** Draws the bar. \return whether to go on */
  bool update(double share, const std::string& stage);
  /** Removes the bar. */
  void clear();

private:
  bool shown_;
  int last_percent_ = -1;
  std::string last_stage_;
};

/** "pcl_spiral_verify 0.2.0, 2025-03-01 14:05 UTC" */
std::string madeBy(const std::string& program);
