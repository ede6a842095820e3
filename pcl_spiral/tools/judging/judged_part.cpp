// SPDX-License-Identifier: BSD-3-Clause
#include "judged_part.h"

#include "terminal/scan_places.h"
#include "terminal/setter_names.h"

#include "verify/ball_way.h"
#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>

using namespace pcl_spiral;

JudgedPart
readPart(const std::string& file, const ReadOptions& read, const std::optional<MeshChoice>& mesh, const ScanSide& side,
         const JudgedRegion& region)
{
  JudgedPart part;
  if (!mesh) {
    Scan scan = readCloud(file, read);
    setScanShift(scan.shift);
    const std::optional<Eigen::Vector3d> view_point = fromScan(side.view_point);
    part.side = sideOf(scan, view_point);
    part.chosen = choosePart(region.choice, file, read, region.tool_radius, {part.side, region.flip_normals, region.threads}, scan);
    part.side = sideOf(scan, view_point);
    part.cloud = scan.cloud;
    part.warnings = inOptions(scan.warnings);
    return part;
  }
  const MeshFile faces = readMesh(file, read);
  setScanShift(faces.shift);
  part.warnings = inOptions(faces.warnings);
  if (const Status status = SurfaceMesh::make(*faces.mesh, mesh->settings, part.mesh); !status.ok())
    throw FileError(file, inOptions(status.message()));
  return part;
}

std::vector<std::string>
faultsBeside(const JudgedPart& part, const pcl::PointCloud<ToolpathPoint>& path, double tool_radius, double allowed)
{
  std::vector<std::string> faults;
  if (const auto entry = deepestEntry(path, tool_radius, part.chosen.keep_outs))
    faults.push_back(textOf("the ball enters a keep-out by ", entry->depth, " mm at ", placeText(entry->place)));
  if (const auto cut = deepestPoint(path, tool_radius, part.chosen.beside); cut && cut->depth > allowed)
    faults.push_back(textOf("the ball or its shank, taken as ", shank_radii, " radii long, cuts ", cut->depth, " mm into the scan at ",
                            placeText(cut->place), ", beside the part that was chosen"));
  return faults;
}
