// SPDX-License-Identifier: BSD-3-Clause
#include "judged_scan.h"

#include "terminal/failure.h"
#include "terminal/scan_places.h"

#include <pcl_spiral/io/mesh_reader.h>

using namespace pcl_spiral;

namespace {

void
readFaces(const std::string& file, const JudgeOptions& options, JudgedScan& judged)
{
  const MeshFile faces = readMesh(file, options.read);
  setScanFrame(faces.shift, options.read);
  judged.warnings = faces.warnings;
  if (const Status status = SurfaceMesh::make(*faces.mesh, options.mesh_settings, judged.input.settings.mesh); !status.ok())
    throw FileError(file, status.diagnostic());
}

} // namespace

JudgedScan
readJudged(const JudgeOptions& options)
{
  const std::string& file = options.files.front();
  JudgedScan judged;
  JudgedInput& input = judged.input;
  input.settings = options.settings;
  input.surface.threads = options.settings.threads;
  if (options.mesh) {
    readFaces(file, options, judged);
    return judged;
  }
  const Scan scan = readCloud(file, options.read);
  setScanFrame(scan.shift, options.read);
  judged.warnings = scan.warnings;
  judged.side = sideOf(scan, fromScan(options.settings.view_point));
  input.cloud = scan.cloud;
  input.normals = judged.side.normals;
  input.surface.view_point = input.settings.view_point = judged.side.view_point;
  input.surface.trust_normals = false; // they come from a file: normals without a common side are not used, with a warning
  input.surface.flip_normals = options.settings.flip_normals;
  input.choice = choiceOf(options.part, options.read);
  input.regions = planRegions(regionsOf(options.part, options.regions, options.read), options.read);
  return judged;
}
