// SPDX-License-Identifier: BSD-3-Clause
// Rows of a ball over a ridge that is found in a scan about a few rough points: from the scan to a program in about 25 calls.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/planning/program_planner.h>
#include <pcl_spiral/planning/ridge_planner.h>

#include <iostream>

int
main(int argc, char** argv)
try {
  if (argc != 4) {
    std::cerr << "usage: " << argv[0] << " SCAN ROUGH_POINTS PROGRAM\n";
    return 2;
  }
  const pcl_spiral::Scan scan = pcl_spiral::readCloud(argv[1]), rough = pcl_spiral::readCloud(argv[2]);
  pcl_spiral::Polyline places; // in their order along the ridge; some mm off will do
  for (const pcl::PointXYZ& p : *rough.cloud)
    places.push_back(p.getVector3fMap().cast<double>());

  pcl_spiral::RidgePlanner<pcl::PointXYZ> planner;
  planner.setInputCloud(scan.cloud);
  planner.setRoughPoints(places);
  planner.setHalfWidth(10.0); // mm, to either side of the crest
  pcl_spiral::RidgeRowSettings rows;
  rows.step_over = 1.0; // mm
  planner.setRowSettings(rows);
  pcl_spiral::PassSettings tool;
  tool.cutter = pcl_spiral::CutterShape::ball(6.0); // mm
  planner.setPassSettings(tool);
  planner.compute();
  if (!planner.getStatus().ok()) {
    std::cerr << planner.getStatus().message() << '\n';
    return 1;
  }

  pcl_spiral::ProgramPlanner programs;
  programs.setInputPlan(planner.getPlan());
  programs.setMachine(pcl_spiral::xyzacTrunnion());
  pcl_spiral::MachineProgram program;
  programs.compute(program);
  if (!programs.getStatus().ok()) {
    std::cerr << programs.getStatus().message() << '\n';
    return 1;
  }
  for (const pcl_spiral::Diagnostics& warnings : {planner.getPlan().warnings, programs.getWarnings()})
    for (const pcl_spiral::Diagnostic& warning : warnings)
      std::cerr << warning << '\n';
  pcl_spiral::writeLinuxCNC(argv[3], program, {});
  std::cout << planner.getPlan().passes.size() << " rows, " << planner.getPlan().poseCount() << " locations; the scan is "
            << planner.getPlan().found->misfit << " mm rms off the ridge\n";
  return 0;
}
catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
