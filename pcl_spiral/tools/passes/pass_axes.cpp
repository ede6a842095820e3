// SPDX-License-Identifier: BSD-3-Clause
#include "pass_axes.h"
#include "terminal/terminal.h"

#include "drive/pass_axes.h"

using namespace pcl_spiral;

void
smoothPasses(const PassJob& job, DrivePasses& passes, Diagnostics& warnings, const std::optional<double>& stand_off)
{
  PassAxisSettings settings;
  settings.smoothing_length = job.axis_smoothing;
  settings.max_rate = job.max_axis_rate;
  settings.stand_off = stand_off;
  PassAxisReport report;
  if (const Status status = smoothPassAxes(settings, passes, report); !status.ok())
    throw UsageError(status.diagnostic());
  warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
}
