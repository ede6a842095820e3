// SPDX-License-Identifier: BSD-3-Clause
#include "reach_map.h"

#include "terminal/file_names.h"
#include "terminal/scan_places.h"

#include "common/formatted_text.h"
#include "io/byte_file.h"
#include <pcl_spiral/surface/impl/ball_reach.h>

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

/** Of each point of \p surface. */
std::vector<float>
reachOf(const Job& job, const Surface& surface)
{
  const double radius = largest * job.settings.tool_radius;
  const BallReach reach(surface.graph(), surface.fit(), radius, reachTolerance(surface.fit(), noise_share * job.settings.chord_error));
  std::vector<float> radii(surface.size(), static_cast<float>(radius));
  for (const UnreachedPoint& point : reach.unreached())
    radii[point.index] = point.reach;
  return radii;
}

} // namespace

void
writeReachMap(const Job& job, const Result& result, const std::string& file)
{
  std::vector<Surface::ConstPtr> surfaces;
  for (const Result& region : result.regions)
    surfaces.push_back(region.surface);
  if (surfaces.empty())
    surfaces.push_back(result.surface);
  std::size_t points = 0;
  for (const Surface::ConstPtr& surface : surfaces)
    points += surface->size();
  const std::string extension = extensionOf(job.reach);
  const char* const row = extension == ".csv" ? "%.6f,%.6f,%.6f,%.4f\n" : "%.6f %.6f %.6f %.4f\n";
  ByteFile out(file);
  out.write(headOf(extension, points));
  for (const Surface::ConstPtr& surface : surfaces) {
    const std::vector<float> radii = reachOf(job, *surface);
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const Eigen::Vector3d place = inScan(surface->position(i));
      out.write(formatted(row, place.x(), place.y(), place.z(), radii[i]));
    }
  }
  out.close();
}
