// SPDX-License-Identifier: BSD-3-Clause
// Rows over a triangle mesh along planes, as close as a scallop height needs and joined, and the cutter on them.
// Usage: example_mesh_sections MESH.stl
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/mesh/mesh_sections.h>

#include <cstdio>
#include <exception>

int
main(int argc, char** argv)
try {
  if (argc != 2)
    return std::fprintf(stderr, "usage: example_mesh_sections MESH.stl\n"), 2;
  const pcl_spiral::MeshFile file = pcl_spiral::readMesh(argv[1]);

  pcl_spiral::MeshSections sections;
  sections.setInputMesh(file.mesh);
  sections.setPlaneNormal({0.0, 1.0, 0.0});      // rows along x
  sections.setRows(pcl_spiral::DriveRows::Kept); // as close as the scallop height needs
  sections.setToolRadius(5.0);
  sections.setScallopHeight(0.01); // mm: radius of the ball, height of the ridges
  sections.setChordError(0.001);   // mm
  sections.setLinkRows(true);
  sections.setFacing(true); // leaves out what faces away from the tool axis
  pcl_spiral::DrivePasses passes;
  sections.compute(passes);
  if (!sections.getStatus().ok())
    return std::fprintf(stderr, "%s\n", sections.getStatus().message().c_str()), 1;
  const pcl_spiral::SectionReport& report = sections.getReport();
  std::printf("%zu rows, %.4g to %.4g mm apart, in %zu passes: %zu contacts, %.1f mm\n", report.rows, report.smallest_step,
              report.step_over, report.passes, report.points, report.length);

  pcl_spiral::CutterLocation<pcl::PointXYZ> location; // lifts the ball where it would touch another part of the mesh
  location.setInputMesh(sections.getSurfaceMesh());
  location.setCutter(pcl_spiral::CutterShape::ball(5.0));
  location.setDrivePasses(passes);
  pcl_spiral::ToolLocations locations;
  location.compute(locations);
  if (!location.getStatus().ok())
    return std::fprintf(stderr, "%s\n", location.getStatus().message().c_str()), 1;
  std::printf("%zu locations, %zu of them lifted\n", locations.size(), location.getReport().count(pcl_spiral::LocationState::Lifted));
  return 0;
}
catch (const std::exception& error) {
  return std::fprintf(stderr, "example_mesh_sections: %s\n", error.what()), 1;
}
