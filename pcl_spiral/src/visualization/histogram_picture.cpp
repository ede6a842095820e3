// SPDX-License-Identifier: BSD-3-Clause
#include "histogram_chart.h"

#include <stdexcept>

namespace pcl_spiral {

void
VerificationPictures::writeHistogram(const std::string& file) const
{
  if (scene_.ridges.empty() || !(scene_.removal_figures.limit > 0.0))
    throw std::logic_error("a histogram needs ridge heights and their limit; call it after a verification with a tool radius");
  Sheet sheet;
  if (hasHistogram(scene_))
    addHistogram(sheet.view(), PageSize(), scene_);
  else
    addCentredText(sheet.view(), "no ridge was measured: no ridge is farther than a step-over from the rim",
                   {0.5 * Sheet::width, 0.5 * Sheet::height}, 26);
  const Title title = histogramTitle(scene_);
  sheet.addTitle(title.first, title.second);
  sheet.save(file);
}

} // namespace pcl_spiral
