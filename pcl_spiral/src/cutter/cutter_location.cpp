// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cutter/cutter_location.h>

namespace pcl_spiral {

Status
checkDrivePoints(const DrivePoints& drive)
{
  if (drive.empty())
    return {StatusCode::InvalidInput, "there are no drive points; call {setDrivePoints} or {setDrivePath}"};
  for (std::size_t i = 0; i < drive.size(); ++i) {
    if (!drive[i].position.allFinite() || !drive[i].axis.allFinite() || !drive[i].normal.allFinite())
      return {StatusCode::InvalidInput, Diagnostic("drive point ", i, ", its axis or its normal is not finite; remove it")};
    if (!(drive[i].axis.norm() > 1e-6))
      return {StatusCode::InvalidInput,
              Diagnostic("drive point ", i, " at ", Place(drive[i].position), " has no tool axis; set one, from the tip to the shank")};
  }
  return Status::success();
}

template class CutterLocation<pcl::PointXYZ>;
template class CutterLocation<pcl::PointXYZRGB>;
template class CutterLocation<pcl::PointNormal>;

} // namespace pcl_spiral
