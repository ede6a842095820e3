// SPDX-License-Identifier: BSD-3-Clause
#include "judged_part.h"

#include "terminal/scan_places.h"

#include "planning/plan_regions.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>

using namespace pcl_spiral;

namespace {

JudgedPart
meshPart(const std::string& file, const ReadOptions& read, const MeshChoice& mesh)
{
  JudgedPart part;
  const MeshFile faces = readMesh(file, read);
  setScanFrame(faces.shift, read);
  part.warnings = faces.warnings;
  if (const Status status = SurfaceMesh::make(*faces.mesh, mesh.settings, part.mesh); !status.ok())
    throw FileError(file, status.diagnostic());
  return part;
}

/** One region of the scan; \p scan was read with \p warnings. */
JudgedPart
regionOf(const std::string& file, const ReadOptions& read, const NamedRegion& region, const std::optional<Eigen::Vector3d>& view_point,
         const JudgedRegion& asked, Scan scan)
{
  JudgedPart part;
  part.region = region.name;
  part.whole = scan.cloud;
  scan.warnings.clear();
  part.side = sideOf(scan, view_point);
  part.chosen = choosePart(region.part, file, read, asked.tool, part.side, asked.flip_normals, asked.threads, scan);
  part.side = sideOf(scan, view_point);
  part.cloud = scan.cloud;
  part.warnings = ofRegion(region.name, scan.warnings);
  return part;
}

} // namespace

std::vector<JudgedPart>
readParts(const std::string& file, const ReadOptions& read, const std::optional<MeshChoice>& mesh,
          const std::optional<Eigen::Vector3d>& asked_view_point, const JudgedRegion& asked)
{
  if (mesh)
    return {meshPart(file, read, *mesh)};
  const Scan scan = readCloud(file, read);
  setScanFrame(scan.shift, read);
  const std::optional<Eigen::Vector3d> view_point = fromScan(asked_view_point);
  std::vector<JudgedPart> parts;
  for (const NamedRegion& region : regionsOf(asked.choice, asked.regions, read))
    parts.push_back(inRegion(region.name, [&] { return regionOf(file, read, region, view_point, asked, scan); }));
  Diagnostics& warnings = parts.front().warnings;
  const Diagnostics& reading = scan.warnings;
  warnings.insert(warnings.begin(), reading.begin(), reading.end());
  return parts;
}
