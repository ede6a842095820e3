// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/tight_places.h>

#include "common/stoppable_loop.h"
#include "path_feet.h"
#include "place_groups.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double edge = 1.0;   // spacings: fewer than two points are on a right angle of an arc of this radius
constexpr double margin = 0.9; // of the tightest radius: between the points that were looked at, a place may be tighter

/** Radius of the ball that a remedy names: a little below \p tightest, two digits. */
double
remedyRadius(double tightest)
{
  const double unit = std::pow(10.0, std::floor(std::log10(margin * tightest)) - 1.0);
  return unit * std::floor(margin * tightest / unit);
}

/** The remedy by a ball that fits into a hollow of the radius \p tightest. It need not give a path. */
Diagnostic
smallerTool(double tightest, bool of_scan)
{
  return Diagnostic(", or use a smaller tool ({setToolRadius}): a radius of ", Proposed("setToolRadius", remedyRadius(tightest)),
                    " {mm} or less is needed", of_scan ? " {on the scan}" : "");
}

/** Why no ball is named where a hollow is tighter than the points are apart: its radius is that of the fit. */
Diagnostic
edgeText(double spacing)
{
  return Diagnostic(". No smaller tool is named, as an inner edge, tighter than the ", spacing,
                    " {mm} between the points, has no radius {on the scan}");
}

/** The smallest radius of a hollow at the points of \p surface, at most \p radius. */
double
tightestOf(const Surface& surface, double radius)
{
  Polyline points;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < surface.size(); begin += report_chunk) {
    points.clear();
    for (std::size_t i = begin; i < std::min(surface.size(), begin + report_chunk); ++i)
      points.push_back(surface.position(i));
    pathFeet(surface, points, feet);
    for (const SurfaceFoot& foot : feet)
      if (foot.valid && foot.curvature2 < -1.0 / radius)
        radius = -1.0 / foot.curvature2;
  }
  return radius;
}

} // namespace

std::optional<double>
fittingBall(double tightest, double spacing)
{
  return tightest < edge * spacing ? std::nullopt : std::optional<double>(remedyRadius(tightest));
}

void
TightPlaces::add(const SurfaceFoot& foot)
{
  if (!foot.valid || foot.curvature2 > -1.0 / tool_radius_)
    return;
  const double radius = -1.0 / foot.curvature2;
  if (feet_.empty() || radius < radius_) {
    radius_ = radius;
    place_ = foot.position;
  }
  feet_.push_back(foot.position);
}

void
TightPlaces::add(const std::vector<RadialLine>& lines)
{
  for (const RadialLine& line : lines)
    for (const SurfaceFoot& foot : line.feet)
      add(foot);
}

std::size_t
TightPlaces::count() const
{
  std::size_t places = 0;
  placeGroups(feet_, 0.5 * tool_radius_, places);
  return places;
}

Status
TightPlaces::refusal(const Diagnostic& what, const Surface* surface) const
{
  const std::size_t places = count();
  const double tightest = surface ? tightestOf(*surface, radius_) : radius_;
  return {StatusCode::Failed,
          Diagnostic("the surface is hollow with radius ", radius_, " {mm} at ", Place(place_), ", tighter than the tool radius ",
                     tool_radius_, " {mm}: the cutter would gouge; let the ball ride over such places ({setTightHandling})",
                     surface && !fittingBall(tightest, surface->spacing()) ? edgeText(surface->spacing())
                                                                           : smallerTool(tightest, surface != nullptr),
                     ". This is the tightest of ", feet_.size(), " ", what, " that are too tight, in ", places,
                     places == 1 ? " place" : " separate places")};
}

Status
checkLinesFit(const std::vector<RadialLine>& lines, const Surface& surface, double tool_radius)
{
  TightPlaces tight(tool_radius);
  tight.add(lines);
  return tight.empty() ? Status::success() : tight.refusal("points of the radial lines", &surface);
}

} // namespace pcl_spiral
