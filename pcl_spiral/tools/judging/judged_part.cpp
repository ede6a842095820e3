// SPDX-License-Identifier: BSD-3-Clause
#include "judged_part.h"

#include "terminal/scan_places.h"
#include "terminal/setter_names.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>

using namespace pcl_spiral;

JudgedPart
readPart(const std::string& file, const ReadOptions& read, const std::optional<MeshChoice>& mesh, const ScanSide& side)
{
  JudgedPart part;
  if (!mesh) {
    const Scan scan = readCloud(file, read);
    setScanShift(scan.shift);
    part.cloud = scan.cloud;
    part.side = sideOf(scan, fromScan(side.view_point));
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
