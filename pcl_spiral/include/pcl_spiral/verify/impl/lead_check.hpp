// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/verify/lead_check.h>

namespace pcl_spiral {

template <typename PointT>
void
LeadCheck<PointT>::compute(const MachineProgram& program)
{
  this->report("LeadCheck", [&]() -> Status {
    for (const Status& status : {this->checkCloud(), this->checkTool()})
      if (!status.ok())
        return status;
    const CutterProfile cutter(this->getCutter());
    const HolderProfile holder = this->holderProfile();
    return this->findAmongPoints([&](const PointBlocks& points, LeadReport& figures) {
      return findLeadCollisions(points, cutter, holder, program, this->getTolerance(), this->progress(), figures);
    });
  });
}

} // namespace pcl_spiral
