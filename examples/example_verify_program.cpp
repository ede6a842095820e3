// SPDX-License-Identifier: BSD-3-Clause
// Reads a program back from its text, moves the cutter as the control would, and judges what it leaves on the scan.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/planning/path_verifier.h>

#include <iostream>

int
main(int argc, char** argv)
try {
  if (argc != 4) {
    std::cerr << "usage: " << argv[0] << " SCAN PROGRAM MACHINE_FILE\n";
    return 2;
  }
  const pcl_spiral::Scan scan = pcl_spiral::readCloud(argv[1]);
  pcl_spiral::PathVerifier<pcl::PointXYZ> verifier;
  verifier.setInputCloud(scan.cloud);
  verifier.setInputProgram(pcl_spiral::readProgram(argv[2], pcl_spiral::readMachine(argv[3])));
  verifier.setCutter(pcl_spiral::CutterShape::ball(6.0)); // mm
  verifier.setScallopHeight(0.05);                        // mm
  pcl_spiral::Limits limits;
  limits.gouge = 0.02; // mm
  verifier.setLimits(limits);
  pcl_spiral::Verification found;
  verifier.compute(found);
  if (!verifier.getStatus().ok()) {
    std::cerr << verifier.getStatus().message() << '\n';
    return 1;
  }
  for (const pcl_spiral::Diagnostic& broken : found.broken)
    std::cerr << broken << '\n';
  std::cout << found.program->blocks << " moves in " << found.program->passes << " passes, highest ridge "
            << found.removal.scallop.max.value << " mm, deepest gouge " << found.removal.gouge.value << " mm\n";
  return found.broken.empty() ? 0 : 1;
}
catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
