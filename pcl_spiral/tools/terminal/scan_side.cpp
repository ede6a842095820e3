// SPDX-License-Identifier: BSD-3-Clause
#include "scan_side.h"
#include "scan_places.h"
#include "vocabulary.h"

#include "graph/side_limits.h"
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
  Diagnostic text = sideText(found);
  if (found.vote == SideVote::GivenNormals)
    text += " (normals of the file; --view-point overrides them)";
  if (found.vote == SideVote::ViewPoint && !asked.from_option)
    text += " (VIEWPOINT of the file; --view-point overrides it)";
  return "side            " + inWords(text);
}

Diagnostics
viewPointWarnings(const ScanSide& asked, const OuterSide& found)
{
  const bool is_default = asked.view_point && inScan(*asked.view_point).isZero(1e-6);
  if (found.vote != SideVote::ViewPoint || asked.from_option || !is_default || found.flipped || found.z_cosine > -clear_z)
    return {};
  return {
      "the cloud is organised and its VIEWPOINT is 0 0 0, so the path is on the side that a camera there sees, which faces away from +z: "
      "give --flip-normals if the cutter must come from +z, or --view-point X,Y,Z"};
}
