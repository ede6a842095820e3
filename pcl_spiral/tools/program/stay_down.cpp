// SPDX-License-Identifier: BSD-3-Clause
#include "stay_down.h"
#include "terminal/terminal.h"

#include "verify/blocked_links.h"
#include <pcl_spiral/io/file_error.h>

using namespace pcl_spiral;

MachineProgram
linkedProgram(const ProgramJob& job, const std::function<MachineProgram(const std::vector<std::size_t>& retracted)>& make,
              const std::string& scan_name, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const LedTool& tool)
{
  MachineProgram program = make({});
  if (program.report.links == 0)
    return program;
  std::vector<std::size_t> blocked;
  const Status status = findBlockedLinks(leadCheckOf(scan, tool), program, 0.5 * job.settings.lead_length, blocked);
  if (status.code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (!status.ok())
    throw FileError(scan_name, status.diagnostic());
  return blocked.empty() ? program : make(blocked);
}
