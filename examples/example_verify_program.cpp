// SPDX-License-Identifier: BSD-3-Clause
// Reads a program back from its text, moves a ball as the control would, judges what it leaves on the scan, and writes what was found.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/stock_writer.h>
#include <pcl_spiral/io/verification_writer.h>
#include <pcl_spiral/planning/path_verifier.h>

#include <cstdlib>
#include <iostream>

int
main(int argc, char** argv)
try {
  if (argc != 6) {
    std::cerr << "usage: " << argv[0] << " SCAN PROGRAM MACHINE_FILE TOOL_RADIUS SCALLOP_HEIGHT\n";
    return 2;
  }
  const pcl_spiral::Scan scan = pcl_spiral::readCloud(argv[1]);
  pcl_spiral::PathVerifier<pcl::PointXYZ> verifier;
  verifier.setInputCloud(scan.cloud);
  verifier.setInputProgram(pcl_spiral::readProgram(argv[2], pcl_spiral::readMachine(argv[3])));
  verifier.setCutter(pcl_spiral::CutterShape::ball(std::atof(argv[4]))); // mm
  verifier.setScallopHeight(std::atof(argv[5]));                         // mm
  pcl_spiral::Limits limits;
  limits.gouge = 0.02; // mm
  verifier.setLimits(limits);
  pcl_spiral::Verification found;
  verifier.compute(found);
  if (!verifier.getStatus().ok()) {
    std::cerr << verifier.getStatus().message() << '\n';
    return 1;
  }
  for (const pcl_spiral::Diagnostics& said : {warningsOf(found), found.broken})
    for (const pcl_spiral::Diagnostic& one : said)
      std::cerr << one << '\n';
  std::cout << found.program->blocks << " moves in " << found.program->passes << " passes, highest ridge "
            << found.removal.scallop.max.value << " mm, deepest gouge " << found.removal.gouge.value << " mm\n";
  found.path = argv[2];
  pcl_spiral::VerificationRun run;
  run.scan = argv[1];
  run.cutter = verifier.getCutter();
  run.scallop_height = verifier.getScallopHeight();
  run.limits = limits;
  pcl_spiral::writeVerificationJSON("verified.json", run, {found});
  pcl_spiral::writeStock("left.ply", stockMesh(*verifier.getReferenceSurface(), verifier.getHeights().stock));
  return found.broken.empty() ? 0 : 1;
}
catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
