// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_strip.h"

#include <pcl_spiral/cleaning/impl/point_groups.h>
#include <pcl_spiral/common/impl/message.h>

#include <Eigen/Geometry>

namespace pcl_spiral {
namespace {

/** The strip of surface between an outline and the others. */
struct NarrowStrip {
  double width = 0.0;    ///< least, mm
  Eigen::Vector3d place; ///< in the middle there
  Eigen::AlignedBox3d box;
};

/** The strip narrower than \p width about its narrowest place; \p found: whether there is one. */
NarrowStrip
narrowestStrip(const std::vector<BoundaryLoop>& outlines, std::size_t of, double width, bool& found)
{
  NarrowStrip strip;
  strip.width = width;
  std::vector<Eigen::Vector3f> sides; // places on both sides, in pairs
  std::size_t narrowest = 0;
  for (std::size_t o = 0; o < outlines.size(); ++o)
    for (const Eigen::Vector3d& p : o == of ? Polyline() : outlines[o].curve)
      for (const Eigen::Vector3d& q : outlines[of].curve) {
        const double distance = (p - q).norm();
        if (distance >= width)
          continue;
        if (distance < strip.width) {
          strip.width = distance;
          strip.place = 0.5 * (p + q);
          narrowest = sides.size();
        }
        sides.insert(sides.end(), {p.cast<float>(), q.cast<float>()});
      }
  found = !sides.empty();
  const std::vector<std::uint32_t> group = pointGroups(sides, width);
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (group[i] == group[narrowest])
      strip.box.extend(sides[i].cast<double>());
  return strip;
}

} // namespace

Status
refuseNarrowStrip(const std::vector<BoundaryLoop>& outlines, std::size_t of, double spacing)
{
  constexpr double narrowest = 5.0; // spacings
  bool found = false;
  const NarrowStrip strip = narrowestStrip(outlines, of, narrowest * spacing, found);
  if (!found)
    return Status::success();
  return {StatusCode::Failed,
          textOf("the surface between two outlines is only ", strip.width, " mm wide at ", placeText(strip.place),
                 ", too narrow for points ", spacing,
                 " mm apart: scan it again, more densely, keep the cutter out of there with a polygon that covers the narrow strip, from ",
                 placeText(strip.box.min()), " to ", placeText(strip.box.max()), " (addKeepOut), or choose the radial method (setMethod)")};
}

} // namespace pcl_spiral
