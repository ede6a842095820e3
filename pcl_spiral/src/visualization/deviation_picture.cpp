// SPDX-License-Identifier: BSD-3-Clause
#include "canvas.h"
#include "verification_map.h"

#include <stdexcept>

namespace pcl_spiral {

void
VerificationPictures::writeDeviation(const std::string& file) const
{
  const pcl::PointCloud<ToolpathPoint>& path = *scene_.part.path;
  if (scene_.deviation.empty())
    throw std::logic_error("a picture of deviations needs the deviation of each path point");
  Canvas canvas(*surface_);
  const DeviationScale scale(scene_.deviation_figures);
  const ValueStyle style = scale.style();
  canvas.add(surfaceActor(surface_->mesh, surface_color));
  addPathMap(canvas, DepthMap(*surface_, canvas), *surface_, path, scene_.deviation, style);
  canvas.addAxes();
  const ToolpathPoint& worst = pathPoint(path, scene_.deviation_figures.max.index);
  const Eigen::Vector3d place = worst.getVector3fMap().cast<double>();
  const bool hidden = canvas.addCircle(place);
  canvas.addColorBar("deviation of the path, mm", scale.colors());
  canvas.addLegend(scale.legend(scene_, hidden));
  addPathInset(canvas, 1, *surface_, {place, worst.getNormalVector3fMap().cast<double>(), insetWidth(*surface_, path), "the largest"}, path,
               scene_.deviation, style);
  const Title title = deviationTitle(scene_);
  canvas.addTitle(title.first, title.second);
  canvas.save(file);
}

} // namespace pcl_spiral
