// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_part.h"

#include "passes/scan_surface.h"

#include "mesh/mesh_findings.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>

#include <Eigen/Geometry>

#include <algorithm>

using namespace pcl_spiral;

namespace {

/** A part smaller than the cutter is probably in another unit. */
void
requireLargerThanCutter(const Job& job, const SurfaceMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    box.extend(mesh.position(v));
  if (box.diagonal().norm() < job.cutter.radius)
    throw FileError(job.scan, Diagnostic("the mesh, from ", Place(box.min()), " to ", Place(box.max()),
                                         ", is smaller than the "
                                         "cutter's radius of ",
                                         job.cutter.radius,
                                         " mm: is it in another unit? Give the unit, such as --units m, "
                                         "or a smaller --tool-radius"));
}

} // namespace

void
readMeshPart(const Job& job, Result& result)
{
  const MeshFile file = readMesh(job.scan, job.read);
  setScanFrame(file.shift, job.read);
  result.scan.warnings = file.warnings;
  require(job.scan, SurfaceMesh::make(*file.mesh, job.mesh_settings, result.mesh));
  requireLargerThanCutter(job, *result.mesh);
  const MeshCounts& counts = result.mesh->counts();
  if (const Diagnostic found = findingsText(counts); !found.empty())
    result.warnings.push_back(Diagnostic("the mesh: ", found));
  if (counts.creases.count > 0)
    result.warnings.push_back(Diagnostic("the mesh has ", counts.crease_length, " mm of creases (edges bent by more than ",
                                         job.mesh_settings.crease_angle, " degrees), the first at ", Place(counts.creases.place),
                                         ": they stay sharp; if the part is round there, increase --crease-angle"));
}

std::vector<ToolLocations>
standAtContacts(const Job& job, const DrivePasses& passes)
{
  const CutterProfile cutter(job.cutter);
  std::vector<ToolLocations> located;
  for (const DrivePass& pass : passes) {
    located.emplace_back();
    const auto add = [&](const DrivePoint& p) {
      ToolLocation location;
      location.axis = p.axis.normalized();
      location.tip = cutter.locate(p.position, p.normal, location.axis).tip;
      location.contact = p.position;
      location.normal = p.normal;
      location.state = LocationState::Reached;
      location.basis = LocationBasis::AskedContact;
      located.back().push_back(location);
    };
    std::for_each(pass.points.begin(), pass.points.end(), add);
    if (pass.closed)
      add(pass.points.front());
  }
  return located;
}
