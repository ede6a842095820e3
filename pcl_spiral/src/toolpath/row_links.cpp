#include <pcl_spiral/toolpath/row_links.h>

#include <pcl_spiral/core/polyline.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

std::size_t
stepsOf(double length, double spacing)
{
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length / spacing - 1e-9)));
}

/** The places of \p line but its ends, on the surface; none where one is not. */
std::optional<DrivePoints>
between(const Polyline& line, const PlaceOnSurface& on_surface)
{
  DrivePoints points;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const std::optional<DrivePoint> point = on_surface(line[i]);
    if (!point)
      return std::nullopt;
    points.push_back(*point);
  }
  return points;
}

/** What joins two places; none where nothing may. */
std::optional<DrivePoints>
linkOf(const Vector3d& from, const Vector3d& to, const LinkLimits& limits, const PlaceOnSurface& on_surface)
{
  const double straight = (to - from).norm();
  if (!(straight <= limits.longest))
    return std::nullopt;
  const auto looked = between(resampled({from, to}, stepsOf(straight, limits.look) + 1), on_surface);
  if (!looked)
    return std::nullopt;
  Polyline way{from};
  for (const DrivePoint& point : *looked)
    way.push_back(point.position);
  way.push_back(to);
  if (!(length(way) <= limits.longest)) // led off by another sheet
    return std::nullopt;
  return between(resampled(way, stepsOf(length(way), limits.spacing) + 1), on_surface);
}

} // namespace

RowLinks
linkRows(DrivePasses& passes, const LinkLimits& limits, const PlaceOnSurface& on_surface)
{
  RowLinks links;
  DrivePasses joined;
  for (DrivePass& pass : passes) {
    std::optional<DrivePoints> link;
    if (!joined.empty() && !joined.back().closed && !pass.closed)
      link = linkOf(joined.back().points.back().position, pass.points.front().position, limits, on_surface);
    if (!link) {
      links.not_made += joined.empty() ? 0 : 1;
      joined.push_back(std::move(pass));
      continue;
    }
    ++links.made;
    DrivePoints& points = joined.back().points;
    points.insert(points.end(), link->begin(), link->end());
    points.insert(points.end(), pass.points.begin(), pass.points.end());
  }
  passes = std::move(joined);
  return links;
}

} // namespace pcl_spiral
