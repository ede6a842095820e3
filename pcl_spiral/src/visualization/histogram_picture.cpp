#include "histogram_chart.h"

#include <stdexcept>

namespace pcl_spiral {

void
VerificationPictures::writeHistogram(const std::string& file) const
{
  if (!hasHistogram(scene_))
    throw std::logic_error("a histogram needs heights of ridges and the limit they are judged by");
  Sheet sheet;
  addHistogram(sheet.view(), PageSize(), scene_);
  const Title title = histogramTitle(scene_);
  sheet.addTitle(title.first, title.second);
  sheet.save(file);
}

} // namespace pcl_spiral
