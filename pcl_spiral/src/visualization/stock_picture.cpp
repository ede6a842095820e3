// SPDX-License-Identifier: BSD-3-Clause
#include "canvas.h"
#include "verification_map.h"

#include <algorithm>
#include <stdexcept>

namespace pcl_spiral {

void
VerificationPictures::writeStock(const std::string& file) const
{
  const VerificationScene& scene = scene_;
  const pcl::PointCloud<ToolpathPoint>& path = *scene.part.path;
  if (scene.stock.empty())
    throw std::logic_error("a picture of the stock needs the stock of each reference point");
  const StockScale scale(scene);
  const std::vector<float> heights = scale.heights(scene);
  Canvas canvas(*surface_);
  const ValueStyle style = scale.style();
  canvas.add(surfaceActor(surface_->mesh, surface_color));
  const double radius = discRadius(*surface_, heights.size());
  addPointMap(canvas, DepthMap(*surface_, canvas), *scene.part.cloud, heights,
              std::clamp(radius / canvas.projection().mm_per_pixel, 1.0, 6.0), style);
  canvas.addAxes();
  canvas.addColorBar("stock left, mm", scale.colors());
  std::vector<LegendEntry> legend = scale.legend(heights);
  const double across = insetWidth(*surface_, path);
  for (const WorstStock& worst : worstStock(scene.removal_figures)) {
    const Eigen::Vector3d& place = worst.value.position;
    legend.push_back(worst.legend(canvas.addCircle(place)));
    addPointInset(canvas, worst.slot, *surface_,
                  {place, pathPoint(path, worst.value.index).getNormalVector3fMap().cast<double>(), across, worst.name}, *scene.part.cloud,
                  heights, radius, style, path);
  }
  canvas.addLegend(legend);
  const Title title = stockTitle(scene);
  canvas.addTitle(title.first, title.second);
  canvas.save(file);
}

} // namespace pcl_spiral
