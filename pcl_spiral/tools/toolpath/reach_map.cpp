// SPDX-License-Identifier: BSD-3-Clause
#include "reach_map.h"

#include "terminal/scan_places.h"

#include "common/formatted_text.h"
#include "io/byte_file.h"
#include <pcl_spiral/surface/impl/ball_reach.h>

#include <algorithm>
#include <vector>

using namespace pcl_spiral;

namespace {

constexpr double largest = 4.0;     // tool radii
constexpr double noise_share = 0.1; // of the chord error, as for the path

std::string
headOf(const std::string& extension, std::size_t points)
{
  if (extension == ".csv")
    return "x,y,z,radius\n";
  if (extension == ".ply")
    return formatted("ply\nformat ascii 1.0\nelement vertex %zu\nproperty double x\nproperty double y\nproperty double z\n"
                     "property float radius\nend_header\n",
                     points);
  return formatted("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z radius\nSIZE 8 8 8 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH %zu\nHEIGHT 1\n"
                   "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS %zu\nDATA ascii\n",
                   points, points);
}

/** Adds the points of \p surface. */
void
addSurface(const Job& job, const Surface& surface, ReachMap& map)
{
  const std::size_t first = map.radii.size();
  map.radii.resize(first + surface.size(), static_cast<float>(map.largest));
  const double tolerance = reachTolerance(surface.fit(), noise_share * job.settings.chord_error);
  for (const double radius : {map.largest, job.settings.tool_radius}) { // grooves of a few spacings are found by balls not much larger
    const BallReach reach(surface.graph(), surface.fit(), radius, tolerance);
    for (const UnreachedPoint& point : reach.unreached())
      map.radii[first + point.index] = std::min(map.radii[first + point.index], point.reach);
  }
  for (std::size_t i = 0; i < surface.size(); ++i)
    map.places.push_back(surface.position(i));
}

} // namespace

ReachMap
reachMapOf(const Job& job, const Result& result)
{
  ReachMap map;
  map.largest = largest * job.settings.tool_radius;
  for (const SpiralPlan& region : result.plan.regions)
    addSurface(job, *region.surface, map);
  if (result.plan.regions.empty())
    addSurface(job, *result.plan.surface, map);
  return map;
}

void
writeReachMap(const ReachMap& map, const std::string& extension, const std::string& file)
{
  const char* const row = extension == ".csv" ? "%.6f,%.6f,%.6f,%.4f\n" : "%.6f %.6f %.6f %.4f\n";
  ByteFile out(file);
  out.write(headOf(extension, map.radii.size()));
  for (std::size_t i = 0; i < map.radii.size(); ++i) {
    const Eigen::Vector3d place = inScan(map.places[i]);
    out.write(formatted(row, place.x(), place.y(), place.z(), map.radii[i]));
  }
  out.close();
}
