// SPDX-License-Identifier: BSD-3-Clause
#include "motion_report.h"

#include <pcl_spiral/io/motion_text.h>

#include <cmath>

namespace pcl_spiral {

nlohmann::ordered_json
motionJson(const MotionStudy& study)
{
  if (!study.status.ok())
    return {};
  const MotionLosses& l = study.losses;
  nlohmann::ordered_json gains = nlohmann::ordered_json::array();
  for (const MotionGain& gain : study.gains)
    gains.push_back({{"change", nameOf(gain.change)}, {"seconds", gain.seconds}});
  return {{"control", study.control.name},
          {"tolerance", study.tolerance},
          {"usual_accelerations", study.usual_axes},
          {"seconds", study.time.seconds},
          {"losses",
           {{"at_feed", l.at_feed}, {"ramps", l.ramps}, {"corners", l.corners}, {"short_blocks", l.short_blocks}, {"rotary", l.rotary}}},
          {"gains", gains}};
}

HtmlRows
motionRows(const MotionStudy& study)
{
  if (!study.status.ok())
    return {};
  HtmlRows rows{{formatted("Machining time on %s", study.control.name),
                 durationText(study.time.seconds) +
                     (study.usual_axes ? ", with usual accelerations for axes that have none in the machine file" : "")},
                {"Where it goes", lossesText(study)}};
  for (const MotionGain& gain : study.gains)
    rows.push_back(
        {formatted("With %s", wordsOf(gain.change)), durationText(std::abs(gain.seconds)) + (gain.seconds < 0.0 ? " more" : " less")});
  return rows;
}

} // namespace pcl_spiral
