// SPDX-License-Identifier: BSD-3-Clause
#include "things_in_the_way.h"

#include "ball_way.h"

#include <pcl_spiral/cleaning/impl/point_groups.h>
#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <limits>

namespace pcl_spiral {
namespace {

/** Points no lower than those that would be cut, and how deep each would be. */
struct HighPoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<double> depths;
};

/** Those of \p points; up is along the mean tool axis, and \p link below the lowest point that is cut is still as high. */
HighPoints
highPoints(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<Eigen::Vector3f>& points, const std::vector<double>& depths,
           double allowed, double link)
{
  Eigen::Vector3f up = Eigen::Vector3f::Zero();
  for (const ToolpathPoint& p : path)
    up += p.getAxisVector3fMap();
  up.normalize();
  float lowest = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (depths[i] > allowed)
      lowest = std::min(lowest, up.dot(points[i]) - static_cast<float>(link));
  HighPoints high;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (up.dot(points[i]) >= lowest) {
      high.points.push_back(points[i]);
      high.depths.push_back(depths[i]);
    }
  return high;
}

/** Whether at least half of \p path is over or under \p box. */
bool
covers(const Eigen::AlignedBox3d& box, const pcl::PointCloud<ToolpathPoint>& path)
{
  const Eigen::AlignedBox2d plan(box.min().head<2>(), box.max().head<2>());
  const auto inside = std::count_if(path.begin(), path.end(),
                                    [&](const ToolpathPoint& p) { return plan.contains(Eigen::Vector2d(double(p.x), double(p.y))); });
  return 2 * static_cast<std::size_t>(inside) >= path.size();
}

} // namespace

std::vector<ThingInTheWay>
thingsInTheWay(const pcl::PointCloud<ToolpathPoint>& path, double radius, const std::vector<Eigen::Vector3f>& points, double allowed,
               double link)
{
  const std::vector<double> depths = depthsInWay(path, radius, points);
  if (std::none_of(depths.begin(), depths.end(), [&](double depth) { return depth > allowed; }))
    return {};
  const HighPoints high = highPoints(path, points, depths, allowed, link);
  std::vector<ThingInTheWay> groups;
  std::vector<Eigen::AlignedBox3d> cut; // of the points of each that would be cut
  const std::vector<std::uint32_t> group = pointGroups(high.points, link);
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (group[i] == groups.size()) {
      groups.emplace_back();
      cut.emplace_back();
    }
    ThingInTheWay& thing = groups[group[i]];
    const Eigen::Vector3d place = high.points[i].cast<double>();
    thing.box.extend(place);
    if (high.depths[i] > 0.0)
      cut[group[i]].extend(place);
    if (high.depths[i] > thing.depth) {
      thing.depth = high.depths[i];
      thing.place = place;
    }
  }
  std::vector<ThingInTheWay> things;
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (groups[g].depth > allowed) {
      things.push_back(groups[g]);
      things.back().around = covers(groups[g].box, path);
      if (things.back().around)
        things.back().box = cut[g];
      const Eigen::Vector3d aside(link / 3.0, link / 3.0, 0.0);
      things.back().box = Eigen::AlignedBox3d(things.back().box.min() - aside, things.back().box.max() + aside);
    }
  std::stable_sort(things.begin(), things.end(), [](const ThingInTheWay& a, const ThingInTheWay& b) { return a.depth > b.depth; });
  return things;
}

Diagnostic
thingsText(const std::vector<ThingInTheWay>& things, bool to_keep_out)
{
  constexpr std::size_t most_named = 4;
  Diagnostic list = Diagnostic(things.size(), things.size() == 1 ? " thing stands in the way: " : " things stand in the way: ");
  for (std::size_t i = 0; i < std::min(things.size(), most_named); ++i) {
    const Eigen::Vector3d size = things[i].box.sizes();
    const Extents extents{things[i].box.min(), things[i].box.max()};
    list += Diagnostic(i > 0 ? "; " : "", to_keep_out ? Diagnostic(Proposed("addKeepOut", extents)) : Diagnostic(extents), ", ", size.x(),
                       " by ", size.y(), " {mm}");
  }
  if (things.size() > most_named)
    list += Diagnostic("; and ", things.size() - most_named, " more");
  return list;
}

} // namespace pcl_spiral
