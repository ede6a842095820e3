// SPDX-License-Identifier: BSD-3-Clause
#include "region_overlap.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>

#include <Eigen/Core>

#include <cstddef>
#include <map>

using namespace pcl_spiral;

void
requireApart(const std::string& scan, const std::vector<RegionPoints>& regions)
{
  std::map<std::array<float, 3>, std::size_t> owners;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    std::map<std::size_t, std::size_t> shared;
    std::array<float, 3> place{};
    for (const auto& point : regions[k].points) {
      const std::size_t owner = owners.emplace(point, k).first->second;
      if (owner != k && shared[owner]++ == 0)
        place = point;
    }
    for (const auto& [owner, count] : shared)
      throw FileError(scan, Diagnostic(regions[owner].name, " and ", regions[k].name, " have ", count, " points in common, one at ",
                                       Place(Eigen::Vector3d(place[0], place[1], place[2])),
                                       ": they would be cut twice; leave one of the two out, or make the polygons smaller"));
  }
}
