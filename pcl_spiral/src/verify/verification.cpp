// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/verification.h>

#include <algorithm>

namespace pcl_spiral {

std::vector<Setting>
settingTable(Limits& l)
{
  return {
      Setting("max_gouge", "Limits::gouge", "limit on gouges", "largest depth of gouges", "0.01", l.gouge).in("mm", NumberRange::from(0.0)),
      Setting("max_scallop", "Limits::scallop", "limit on the scallop", "largest height of ridges and of stock at the rim", "0.06",
              l.scallop)
          .in("mm", NumberRange::from(0.0)),
      Setting("max_deviation", "Limits::deviation", "limit on the deviation", "largest distance of the contacts from the surface", "0.02",
              l.deviation)
          .in("mm", NumberRange::from(0.0)),
      Setting("max_uncut", "Limits::uncut", "limit on uncut points", "largest share of the points of the surface that are not cut", "0.5",
              l.uncut)
          .in("percent", NumberRange::from(0.0)),
  };
}

std::string
nameOf(const Verification& verification)
{
  return verification.path + (verification.region.empty() ? "" : ", ") + verification.region;
}

double
uncutPercent(const RemovalReport& removal)
{
  const std::size_t samples = removal.stock.samples + removal.rim.samples;
  const std::size_t uncut = removal.stock.uncut + removal.rim.uncut;
  return samples > 0 ? 100.0 * static_cast<double>(uncut) / static_cast<double>(samples) : 100.0;
}

const PlacedValue&
firstUncut(const RemovalReport& removal)
{
  return removal.stock.uncut > 0 ? removal.stock.first_uncut : removal.rim.first_uncut;
}

const PlacedValue&
highestScallop(const RemovalReport& removal)
{
  return removal.scallop.samples > 0 ? removal.scallop.max : removal.stock.max;
}

Diagnostics
warningsOf(const Verification& verification)
{
  Diagnostics warnings;
  if (verification.program)
    warnings = verification.program->warnings;
  for (const Diagnostics* some : {&verification.deviation.warnings, &verification.removal.warnings})
    for (const Diagnostic& warning : *some)
      if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
        warnings.push_back(warning);
  return warnings;
}

} // namespace pcl_spiral
