// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which passes of a path or a program belong to which region of a scan.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/planning/impl/path_judge.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** A pass belongs to the region whose points are nearest to most of its places. */
class RegionPasses {
public:
  /** \p parts: each with its reference. */
  explicit RegionPasses(const std::vector<JudgedPart>& parts);

  /** Points of the passes of \p path over \p region, in order. */
  std::vector<std::size_t> pointsOf(std::size_t region, const pcl::PointCloud<ToolpathPoint>& path) const;

  /** Blocks of the feed moves of \p program over \p region, each run with the block before it. */
  std::vector<std::size_t> blocksOf(std::size_t region, const MachineProgram& program) const;

private:
  std::size_t regionOf(const std::vector<Eigen::Vector3d>& places) const;

  std::vector<std::unique_ptr<PointBlocks>> points_;
};

} // namespace pcl_spiral
