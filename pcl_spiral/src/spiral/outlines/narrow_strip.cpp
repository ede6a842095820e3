// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_strip.h"

#include <pcl_spiral/common/impl/message.h>

namespace pcl_spiral {

Status
refuseNarrowStrip(const std::vector<BoundaryLoop>& outlines, std::size_t of, double spacing)
{
  constexpr double narrowest = 5.0; // spacings
  double width = narrowest * spacing;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  bool found = false;
  for (std::size_t o = 0; o < outlines.size(); ++o)
    for (const Eigen::Vector3d& p : o == of ? Polyline() : outlines[o].curve)
      for (const Eigen::Vector3d& q : outlines[of].curve)
        if (const double distance = (p - q).norm(); distance < width) {
          width = distance;
          place = 0.5 * (p + q);
          found = true;
        }
  if (!found)
    return Status::success();
  return {StatusCode::Failed,
          textOf("the surface between two outlines is only ", width, " mm wide at ", placeText(place), ", too narrow for points ", spacing,
                 " mm apart: scan it again, more densely, or keep the cutter out of there with a polygon that covers "
                 "the strip (addKeepOut)")};
}

} // namespace pcl_spiral
