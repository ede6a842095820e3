// SPDX-License-Identifier: BSD-3-Clause
#include "row_links.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** The way from a pass to the next; empty where they are not joined. */
using Way = Polyline;

/** The line divided into equal steps no longer than \p spacing. */
Way
divided(const Way& line, double spacing)
{
  const double steps = std::max(1.0, std::ceil(length(line) / spacing - 1e-9));
  return resampled(line, static_cast<std::size_t>(steps) + 1);
}

/** Straight from each pass to the next, where they are near and open. */
std::vector<Way>
straightWays(const DrivePasses& passes, const LinkLimits& limits)
{
  std::vector<Way> ways(passes.size());
  for (std::size_t k = 0; k + 1 < passes.size(); ++k) {
    const DrivePass &pass = passes[k], &next = passes[k + 1];
    if (pass.closed || next.closed || pass.points.empty() || next.points.empty())
      continue;
    const Vector3d &from = pass.points.back().position, &to = next.points.front().position;
    if ((to - from).norm() <= limits.longest)
      ways[k] = divided({from, to}, limits.look);
  }
  return ways;
}

/** Put the ways on the surface, except for their ends; empty those that leave it. \p points: those between the ends
 * of each. */
void
putOn(const PlacesOnSurface& on_surface, std::vector<Way>& ways, std::vector<DrivePoints>& points)
{
  Polyline places;
  for (const Way& way : ways)
    for (std::size_t i = 1; i + 1 < way.size(); ++i)
      places.push_back(way[i]);
  const std::vector<std::optional<DrivePoint>> found = on_surface(places);
  points.assign(ways.size(), {});
  std::size_t next = 0;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    bool whole = true;
    for (std::size_t i = 1; i + 1 < ways[k].size(); ++i, ++next) {
      whole = whole && found[next];
      if (!whole)
        continue;
      points[k].push_back(*found[next]);
      ways[k][i] = found[next]->position;
    }
    if (!whole)
      ways[k].clear();
  }
}

} // namespace

RowLinks
linkRows(DrivePasses& passes, const LinkLimits& limits, const PlacesOnSurface& on_surface)
{
  std::vector<Way> ways = straightWays(passes, limits);
  std::vector<DrivePoints> between;
  putOn(on_surface, ways, between);
  for (Way& way : ways)
    if (length(way) <= limits.longest)
      way = way.empty() ? way : divided(way, limits.spacing);
    else
      way.clear(); // led away by another sheet
  putOn(on_surface, ways, between);
  RowLinks links;
  DrivePasses joined;
  for (std::size_t k = 0; k < passes.size(); ++k) {
    if (k == 0 || ways[k - 1].empty()) {
      links.not_made += k > 0 ? 1 : 0;
      joined.push_back(std::move(passes[k]));
      continue;
    }
    ++links.made;
    DrivePoints& points = joined.back().points;
    points.insert(points.end(), between[k - 1].begin(), between[k - 1].end());
    points.insert(points.end(), passes[k].points.begin(), passes[k].points.end());
  }
  passes = std::move(joined);
  return links;
}

RowLinks
linkRows(DrivePasses& passes, const LinkLimits& limits, const PlaceOnSurface& on_surface)
{
  return linkRows(passes, limits, [&on_surface](const Polyline& places) {
    std::vector<std::optional<DrivePoint>> points;
    for (const Vector3d& place : places)
      points.push_back(on_surface(place));
    return points;
  });
}

} // namespace pcl_spiral
