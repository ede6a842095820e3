// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Wrong calls, progress, cancelling and times on a terminal.
 */
#pragma once

#include <stdexcept>
#include <string>

/** A call that cannot be meant; the message names the option, the value and the remedy. */
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** The user has ended the run. */
class Cancelled : public std::runtime_error {
public:
  Cancelled() : std::runtime_error("cancelled; no output has been written") {}
};

/** From here on ctrl-C, a request to end and a closed terminal (SIGINT, SIGTERM, SIGHUP) only set what cancelled tells,
 * and a file grown past the limit of the shell (SIGXFSZ) is an error of writing. */
void catchSignals();

bool cancelled();

/** A bar on stderr, where that is a terminal; nothing where it is piped. */
class ProgressBar {
public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();

  /** Draw, and tell whether to go on. */
  bool update(double share, const std::string& stage);
  /** Take the bar away. */
  void clear();

private:
  bool shown_;
  int last_percent_ = -1;
  std::string last_stage_;
};

/** "pcl_spiral_verify 0.1.0, 2025-03-01 14:05 UTC" */
std::string madeBy(const std::string& program);

/** "12.3 s", "4.5 min", "3 h 20 min" */
std::string duration(double seconds);
