// SPDX-License-Identifier: BSD-3-Clause
// Rows of a bull-nose cutter beside a clamp, with their program for a trunnion: leads and links are clear of all that was scanned.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/polygon_reader.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/planning/drive_planner.h>
#include <pcl_spiral/planning/program_planner.h>

#include <iostream>

int
main(int argc, char** argv)
try {
  if (argc != 4) {
    std::cerr << "usage: " << argv[0] << " SCAN CLAMP PROGRAM\n";
    return 2;
  }
  const pcl_spiral::Scan scan = pcl_spiral::readCloud(argv[1]);

  pcl_spiral::DrivePlanner<pcl::PointXYZ> planner;
  planner.setInputCloud(scan.cloud); // all of it: what is not the part is an obstacle
  planner.setInputNormals(scan.normals);
  if (scan.view_point)
    planner.setViewPoint(*scan.view_point);
  planner.addKeepOut(pcl_spiral::readPolygon(argv[2]));
  planner.setCutter(pcl_spiral::CutterShape::bullNose(6.0, 1.5)); // mm
  planner.setStepOver(2.0);                                       // mm
  planner.compute();
  if (!planner.getStatus().ok()) {
    std::cerr << planner.getStatus().message() << '\n';
    return 1;
  }

  pcl_spiral::ProgramPlanner programs;
  programs.setInputPlan(planner.getPlan());
  programs.setMachine(pcl_spiral::xyzacTrunnion());
  pcl_spiral::ProgramSettings settings;
  settings.feed = 1500.0; // mm/min
  programs.setSettings(settings);
  pcl_spiral::MachineProgram program;
  programs.compute(program);
  if (!programs.getStatus().ok()) {
    std::cerr << programs.getStatus().message() << '\n';
    return 1;
  }
  for (const pcl_spiral::Diagnostics& warnings : {planner.getWarnings(), programs.getWarnings()})
    for (const pcl_spiral::Diagnostic& warning : warnings)
      std::cerr << warning << '\n';
  pcl_spiral::ProgramHeader header;
  header.title = argv[1];
  header.spindle_speed = 8000.0; // rev/min
  pcl_spiral::writeLinuxCNC(argv[3], program, header);
  std::cout << planner.getPlan().passes.size() << " passes, " << planner.getPlan().left_out.count()
            << " locations left out beside the clamp, " << program.blocks.size() << " blocks\n";
  return 0;
}
catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
