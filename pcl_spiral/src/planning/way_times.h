// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  When the tool is at each point of a path that became a program.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/machine/machine_program.h>

#include <pcl/point_cloud.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** When the tool is at each point of \p path, s: by the way of the contacts in the blocks that cut, pass by pass. \p begins: where the
 *  second pass and each further one begin. \p blocks were made of the path; there is at least one. \p ends: of each of them, s. Where
 *  single precision makes the way longer than that of its pass, the tool is at the end of the pass. Ascends. */
std::vector<double> timesOnWay(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<std::size_t>& begins,
                               const std::vector<ProgramBlock>& blocks, const std::vector<double>& ends);

} // namespace pcl_spiral
