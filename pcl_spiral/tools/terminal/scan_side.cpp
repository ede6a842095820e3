// SPDX-License-Identifier: BSD-3-Clause
#include "scan_side.h"

#include <pcl_spiral/surface/impl/side_text.h>

using namespace pcl_spiral;

ScanSide
sideOf(const Scan& scan, const std::optional<Eigen::Vector3d>& view_point)
{
  if (view_point)
    return {nullptr, view_point, true};
  return {scan.normals, scan.view_point, false};
}

std::string
sideLine(const ScanSide& asked, const OuterSide& found)
{
  std::string text = sideText(found);
  if (found.vote == SideVote::GivenNormals)
    text += " (normals of the file; --view-point overrides them)";
  if (found.vote == SideVote::ViewPoint && !asked.from_option)
    text += " (VIEWPOINT of the file; --view-point overrides it)";
  return "side            " + text;
}
