// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/io/motion_text.h>

#include "common/formatted_text.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double worth = 0.01; ///< share of the time that is worth naming

double
shareOf(const MotionStudy& study, double seconds)
{
  return study.time.seconds > 0.0 ? seconds / study.time.seconds : 0.0;
}

} // namespace

const char*
nameOf(MotionChange change)
{
  switch (change) {
  case MotionChange::Feed:
    return "feed";
  case MotionChange::Acceleration:
    return "acceleration";
  case MotionChange::Tolerance:
    return "tolerance";
  case MotionChange::RotaryBlend:
    return "rotary_blend";
  case MotionChange::ChordError:
    return "chord_error";
  case MotionChange::AxisSmoothing:
    return "axis_smoothing";
  case MotionChange::LongerBlocks:
    break;
  }
  return "longer_blocks";
}

const char*
wordsOf(MotionChange change)
{
  switch (change) {
  case MotionChange::Feed:
    return "feed 1.5 times as high";
  case MotionChange::Acceleration:
    return "twice the acceleration of every axis";
  case MotionChange::Tolerance:
    return "twice the tolerance of smoothing";
  case MotionChange::RotaryBlend:
    return "a control that rounds corners of rotary moves";
  case MotionChange::ChordError:
    return "twice the chord error";
  case MotionChange::AxisSmoothing:
    return "smoother tool axes";
  case MotionChange::LongerBlocks:
    break;
  }
  return "longer blocks, within the chord error";
}

std::string
lossesText(const MotionStudy& study)
{
  const MotionLosses& l = study.losses;
  const auto percent = [&](double seconds) { return std::round(100.0 * shareOf(study, seconds)) + 0.0; }; // no -0
  return formatted("%.0f %% at the feed, %.0f %% corners, %.0f %% rotary axes, %.0f %% short blocks, %.0f %% start and stop",
                   percent(l.at_feed), percent(l.corners), percent(l.rotary), percent(l.short_blocks), percent(l.ramps));
}

std::string
durationText(double seconds)
{
  const auto minutes = static_cast<long>(seconds / 60.0 + 0.5);
  return seconds < 60.0     ? formatted("%.1f s", seconds)
         : seconds < 3600.0 ? formatted("%.1f min", seconds / 60.0)
                            : formatted("%ld h %02ld min", minutes / 60, minutes % 60);
}

std::string
motionText(const MotionStudy& study)
{
  return durationText(study.time.seconds) + " on " + study.control.name + (study.usual_axes ? " with usual accelerations: " : ": ") +
         lossesText(study);
}

std::string
gainText(const MotionStudy& study)
{
  if (study.gains.empty() || shareOf(study, study.gains.front().seconds) < worth)
    return "no change that was tried gains 1 %";
  const MotionGain& most = study.gains.front();
  return formatted("%s: %.0f %% less time", wordsOf(most.change), 100.0 * shareOf(study, most.seconds));
}

} // namespace pcl_spiral
