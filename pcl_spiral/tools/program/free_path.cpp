// SPDX-License-Identifier: BSD-3-Clause
#include "free_path.h"

#include "terminal/terminal.h"

#include <pcl_spiral/io/file_error.h>

using namespace pcl_spiral;

namespace {

template <typename Way>
void
requireFree(const PathCheck& asked, const Way& way, Diagnostics& warnings)
{
  ProgressBar bar(asked.quiet);
  ToolWay looked_at = asked;
  looked_at.progress = [&bar](double share, const std::string& stage) { return bar.update(share, stage); };
  const Status status = checkToolWay(looked_at, way, warnings);
  bar.clear();
  if (status.code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (!status.ok())
    throw FileError(asked.file, status.diagnostic());
}

} // namespace

void
requireFreePath(const PathCheck& check, const std::vector<ToolPoses>& passes, Diagnostics& warnings)
{
  requireFree(check, passes, warnings);
}

void
requireFreePath(const PathCheck& check, const MachineProgram& program, Diagnostics& warnings)
{
  requireFree(check, program, warnings);
}
