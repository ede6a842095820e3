// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which passes of a path or a program belong to which region of the scan.
 */
#pragma once

#include "judging/judged_part.h"

#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/search/impl/point_blocks.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <cstddef>
#include <memory>
#include <vector>

/** A pass belongs to the region whose points are nearest to most of its places. */
class RegionPasses {
public:
  /** The surface of each region. */
  explicit RegionPasses(const std::vector<std::shared_ptr<const pcl_spiral::ReferenceSurface>>& references);

  /** The region of most of these places. */
  std::size_t regionOf(const std::vector<Eigen::Vector3d>& places) const;

  /** The passes of \p region, in order. */
  pcl_spiral::ToolpathFile of(std::size_t region, const pcl_spiral::ToolpathFile& file) const;

  /** Blocks of the feed moves of \p program that belong to \p region, each run with the block before it. */
  std::vector<std::size_t> of(std::size_t region, const pcl_spiral::MachineProgram& program) const;

private:
  std::vector<std::unique_ptr<pcl_spiral::PointBlocks>> points_;
};

/** The passes of a file that are judged. */
struct JudgedPasses {
  const RegionPasses* all = nullptr; ///< null: there is one region, and all passes are judged
  std::size_t region = 0;
};
