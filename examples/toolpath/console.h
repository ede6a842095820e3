/** \file
 *  Progress, cancelling and the summary on a terminal.
 */
#pragma once

#include "job.h"

#include <pcl_spiral/common/progress.h>
#include <pcl_spiral/toolpath/spiral_report.h>

#include <string>

/** From here on ctrl-C and a request to end (SIGINT, SIGTERM) only set what cancelled tells. */
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

/** What was made, for people. */
void printSummary(const Job& job, const pcl_spiral::SpiralReport& report, double seconds);
