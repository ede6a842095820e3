// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Links between passes that would come too near to the scan.
 */
#pragma once

#include <pcl_spiral/verify/lead_check.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Finds the links of \p program (BlockSection::Link) on which the tool of \p check would come nearer than \p room mm to a point, and puts
 *  the passes to which they lead into \p passes, in order. Every point counts, also a single one. \return the status of \p check */
Status findBlockedLinks(LeadCheck<pcl::PointXYZ> check, const MachineProgram& program, double room, std::vector<std::size_t>& passes);

} // namespace pcl_spiral
