// SPDX-License-Identifier: BSD-3-Clause
#include "way_check.h"

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/io/file_error.h>

#include "verify/ball_way.h"
#include "verify/things_in_the_way.h"

using namespace pcl_spiral;

namespace {

/** The path with the tool upright on the surface. */
pcl::PointCloud<ToolpathPoint>
upright(const pcl::PointCloud<ToolpathPoint>& path)
{
  pcl::PointCloud<ToolpathPoint> other = path;
  for (ToolpathPoint& p : other)
    p.getAxisVector3fMap() = p.getNormalVector3fMap();
  return other;
}

} // namespace

void
checkWay(const Job& job, const Result& result)
{
  constexpr double deviations = 5.0; // of the noise: no point is farther from the surface
  const double radius = job.settings.tool_radius, allowed = job.settings.chord_error + deviations * result.report.noise;
  if (const auto entry = deepestEntry(*result.path, ballCentres(*result.path, radius), radius, result.part.keep_outs))
    throw FileError(job.scan, textOf("the ball enters a keep-out by ", entry->depth, " mm at ", placeText(entry->place),
                                     ": enlarge the polygon there by that much (--keep-out)"));
  if (const auto cut = deepestPoint(*result.path, radius, result.part.kept_out); cut && cut->depth > allowed)
    throw FileError(job.scan, textOf("the shank, taken as ", shank_radii, " radii long, would cut ", cut->depth,
                                     " mm into what stands in a keep-out, at ", placeText(cut->place),
                                     ": enlarge the polygon there by that much (--keep-out), or tilt the tool less (--tilt)"));
  std::vector<Eigen::Vector3f> beside = result.part.beside;
  for (std::size_t i = 0; result.surface && !result.mesh && i < result.surface->leftOut().why.size(); ++i)
    if (result.surface->leftOut().why[i] == LeftOut::OtherPart)
      beside.push_back(result.surface->leftOut().positions[i]);
  if (result.surface)
    for (const Eigen::Vector3f& point : result.surface->riddenPoints())
      beside.push_back(point);
  constexpr double link = 3.0; // spacings
  const std::vector<ThingInTheWay> things = thingsInTheWay(*result.path, radius, beside, allowed, link * result.report.spacing);
  if (things.empty())
    return;
  const bool only_shank =
      job.settings.tilt_angle > 0.0 && thingsInTheWay(upright(*result.path), radius, beside, allowed, link * result.report.spacing).empty();
  const std::string text = textOf("the ball or its shank, taken as ", shank_radii, " radii long, would cut ", things.front().depth,
                                  " mm into the scan at ", placeText(things.front().place), ", beside the part that was chosen. ",
                                  thingsText(things), ": keep out of each with a polygon that covers it (--keep-out)",
                                  only_shank ? ", or tilt the tool less (--tilt): upright, it hits nothing" : "");
  throw FileError(job.scan, withFilePlaces(text, job.read));
}
