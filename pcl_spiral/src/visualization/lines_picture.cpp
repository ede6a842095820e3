// SPDX-License-Identifier: BSD-3-Clause
#include "boundary_layer.h"
#include "canvas.h"
#include "keep_out_layer.h"

namespace pcl_spiral {

void
SpiralPictures::writeLines(const std::string& file) const
{
  Canvas canvas(*surface_);
  const auto colors = heightColors(*surface_);
  std::vector<LegendEntry> legend = addBoundaries(canvas, scene_.report, colors);
  addKeepOuts(canvas, scene_, legend);
  canvas.addAxes();
  canvas.addLegend(legend);
  canvas.addColorBar("height, mm", colors);
  canvas.addTitle(boundariesTitle(scene_), partInWords(scene_));
  canvas.save(file);
}

} // namespace pcl_spiral
