// SPDX-License-Identifier: BSD-3-Clause
#include "way_check.h"

#include "judging/judged_part.h"

#include <pcl_spiral/common/impl/message.h>

#include "verify/ball_way.h"
#include "verify/things_in_the_way.h"
#include <pcl_spiral/verify/impl/false_echoes.h>

#include <algorithm>

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

/** The remedy of less tilt, if the path has a tilt and \p isFree holds for the upright tool. */
template <typename IsFree>
std::string
lessTilt(const Job& job, const Result& result, IsFree isFree)
{
  const SpiralSettings& s = job.settings;
  if (s.fixed_axis || (s.tilt_angle == 0.0 && s.lead_angle == 0.0) || !isFree(upright(*result.path)))
    return "";
  const char* option = s.lead_angle == 0.0 ? "--tilt" : s.tilt_angle == 0.0 ? "--lead" : "--tilt, --lead";
  return textOf(", or tilt the tool less (", option, "): upright, it hits nothing");
}

/** What the ball and its shank must not cut, with those \p beside the part of the points that were left out by their place. */
std::vector<Eigen::Vector3f>
standing(const Result& result, std::vector<Eigen::Vector3f> beside)
{
  for (std::size_t i = 0; result.surface && !result.mesh && i < result.surface->leftOut().why.size(); ++i)
    if (result.surface->leftOut().why[i] == LeftOut::OtherPart)
      beside.push_back(result.surface->leftOut().positions[i]);
  if (result.surface)
    for (const Eigen::Vector3f& point : result.surface->riddenPoints())
      beside.push_back(point);
  return beside;
}

/** What may help where a polygon would cover too much. */
std::string
otherRemedies(const Job& job, const std::vector<ThingInTheWay>& things)
{
  std::string text;
  if (std::any_of(things.begin(), things.end(), [](const ThingInTheWay& thing) { return thing.around; }))
    text = ". What is all round the path is often the table: crop the scan inside the rim of the part (--crop)";
  if (job.regions.several())
    text += ". A keep-out holds for all regions: if another region stands there, give each region a run of its own";
  return text;
}

/** Refuses what is in the way beside the part, and warns of single points there. */
void
checkBeside(const Job& job, double allowed, Result& result)
{
  constexpr double link = 3.0; // spacings
  const auto inTheWay = [&](const pcl::PointCloud<ToolpathPoint>& path, const std::vector<Eigen::Vector3f>& beside) {
    return thingsInTheWay(path, job.settings.tool_radius, beside, allowed, link * result.report.spacing);
  };
  std::vector<Eigen::Vector3f> beside = standing(result, result.part.beside);
  std::vector<ThingInTheWay> things = inTheWay(*result.path, beside);
  if (things.empty())
    return;
  if (!result.part.beside.empty()) {
    beside = standing(result, withoutEchoes(result.part.beside, *result.whole_scan));
    const Eigen::Vector3d deepest = things.front().place;
    things = inTheWay(*result.path, beside);
    if (things.empty()) {
      result.report.warnings.push_back(textOf("the ball or its shank cuts into the scan at ", placeText(deepest),
                                              ", beside what is cut: only single points off the surface are there, usually "
                                              "false echoes"));
      return;
    }
  }
  const auto isFree = [&](const pcl::PointCloud<ToolpathPoint>& path) { return inTheWay(path, beside).empty(); };
  throw FileError(job.scan, textOf("the ball or its shank, taken as ", shank_radii, " radii long, would cut ", things.front().depth,
                                   " mm into the scan at ", placeText(things.front().place), ", beside what is cut. ", thingsText(things),
                                   ": keep out of each with a polygon that covers it (--keep-out)", lessTilt(job, result, isFree),
                                   otherRemedies(job, things)));
}

} // namespace

void
checkWay(const Job& job, Result& result)
{
  constexpr double deviations = 5.0;         // of the noise: no point is farther from the surface
  constexpr double more = 2.0, least = 0.25; // times the depth, spacings: farther away, the outline is another one
  constexpr double beyond = 1.5;             // spacings: how far a path may run beyond the last points
  const double radius = job.settings.tool_radius, allowed = job.settings.chord_error + deviations * result.report.noise;
  if (const auto entry = deepestEntry(*result.path, ballCentres(*result.path, radius), radius, result.part.keep_outs))
    throw EntersKeepOut(job.scan,
                        textOf("the ball enters a keep-out by ", entry->depth, " mm at ", placeText(entry->place),
                               ": enlarge the polygon there by that much (--keep-out)"),
                        std::max(more * entry->depth, least * result.report.spacing), entry->depth > beyond * result.report.spacing);
  const auto isFree = [&](const pcl::PointCloud<ToolpathPoint>& path) {
    const auto cut = deepestPoint(path, radius, result.part.kept_out);
    return !cut || cut->depth <= allowed;
  };
  if (!isFree(*result.path)) {
    const BallEntry cut = *deepestPoint(*result.path, radius, result.part.kept_out);
    throw FileError(job.scan, textOf("the shank, taken as ", shank_radii, " radii long, would cut ", cut.depth,
                                     " mm into what stands in a keep-out, at ", placeText(cut.place),
                                     ": enlarge the polygon there by that much (--keep-out)", lessTilt(job, result, isFree)));
  }
  checkBeside(job, allowed, result);
}

void
checkRawScan(const Job& job, Result& result)
{
  if (job.raw_scan.empty())
    return;
  constexpr double deviations = 5.0; // of the noise, as above
  const RawScanFigures raw = rawScanFigures(job.raw_scan, job.read, *result.surface);
  result.report.warnings.push_back(smoothingText(raw, job.raw_scan));
  JudgeSettings settings;
  settings.cutter = CutterShape::ball(job.settings.tool_radius);
  const double allowed = job.limits.gouge.value_or(job.settings.chord_error + deviations * result.report.noise);
  const std::string fault = faultInRaw(raw, result.path, settings, allowed);
  if (fault.empty())
    return;
  if (job.verify)
    throw FileError(job.scan, "the path was made, but " + fault);
  result.report.warnings.push_back(fault);
}
