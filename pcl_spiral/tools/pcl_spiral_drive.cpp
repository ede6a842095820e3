// SPDX-License-Identifier: BSD-3-Clause
// From a scan to gouge-free locations of any cutter along a drive path: planes, helix, rings, curve, offsets.
#include "drive/command_line.h"
#include "drive/job_check.h"
#include "drive/outputs.h"
#include "drive/planning.h"
#include "passes/pass_main.h"

int
main(int argc, char** argv)
{
  return passMain("pcl_spiral_drive", argc, argv, parseCommandLine, printHelp);
}
