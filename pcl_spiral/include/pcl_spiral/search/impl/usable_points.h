// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The points of a PCL cloud that a computation can work on.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/search/impl/point_selection.h>

#include <pcl/common/point_tests.h>
#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Ok, or an error for the first of \p indices (may be null) that is outside a cloud of \p size points. */
inline Status
checkIndices(const pcl::Indices* indices, std::size_t size)
{
  if (indices)
    for (const auto index : *indices)
      if (static_cast<std::size_t>(index) >= size)
        return {StatusCode::InvalidInput, Diagnostic("index ", index, " is outside the cloud of ", size, " points")};
  return Status::success();
}

/** Points selected from a cloud: positions, and the index of each in the cloud. */
struct UsablePoints {
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> source;
  std::size_t asked_for = 0;  ///< in the whole cloud or its indices
  std::size_t nonfinite = 0;  ///< of those, left out: NaN, infinite, or marker values beyond 1e12
  std::size_t duplicates = 0; ///< of those, left out: another point stands at the same place

  /** Keep only the points of ascending \p kept; returns how many are dropped. */
  std::size_t keep(const std::vector<std::uint32_t>& kept)
  {
    const std::size_t dropped = source.size() - kept.size();
    if (dropped == 0)
      return 0;
    for (std::size_t i = 0; i < kept.size(); ++i) { // ascending: never overwrites what is still to be read
      positions[i] = positions[kept[i]];
      source[i] = source[kept[i]];
    }
    positions.resize(kept.size());
    source.resize(kept.size());
    positions.shrink_to_fit();
    source.shrink_to_fit();
    return dropped;
  }
};

/** Coordinates beyond this, mm, are not on a part: some scanners write 1e20 or the largest number for "nothing". */
constexpr float farthest_coordinate = 1e12f;

/** The finite points of \p cloud, or of those in \p indices (null: all), in their order. Of points at the same place only the
 *  first is kept. Indices must be inside the cloud. */
template <typename PointT>
UsablePoints
usablePoints(const pcl::PointCloud<PointT>& cloud, const pcl::Indices* indices)
{
  UsablePoints usable;
  usable.asked_for = indices ? indices->size() : cloud.size();
  usable.positions.reserve(usable.asked_for);
  usable.source.reserve(usable.asked_for);
  for (std::size_t k = 0; k < usable.asked_for; ++k) {
    const std::size_t i = indices ? static_cast<std::size_t>((*indices)[k]) : k;
    if (!pcl::isXYZFinite(cloud[i]) || cloud[i].getVector3fMap().cwiseAbs().maxCoeff() > farthest_coordinate)
      continue;
    usable.positions.push_back(cloud[i].getVector3fMap());
    usable.source.push_back(static_cast<std::uint32_t>(i));
  }
  usable.nonfinite = usable.asked_for - usable.source.size();
  usable.duplicates = usable.keep(distinctPoints(usable.positions));
  return usable;
}

/** Normals of the points in \p source; zero for those that are not finite. */
template <typename PointNT>
std::vector<Eigen::Vector3f>
normalsOf(const pcl::PointCloud<PointNT>& normals, const std::vector<std::uint32_t>& source)
{
  std::vector<Eigen::Vector3f> result;
  result.reserve(source.size());
  for (const std::uint32_t i : source) {
    const Eigen::Vector3f n = normals[i].getNormalVector3fMap();
    result.push_back(n.allFinite() ? n : Eigen::Vector3f(Eigen::Vector3f::Zero()));
  }
  return result;
}

} // namespace pcl_spiral
