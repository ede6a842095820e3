// SPDX-License-Identifier: BSD-3-Clause
// Makes gouge-free locations of any cutter along a drive path over a scan: planes, helix, rings, curve, offsets.
#include "drive/command_line.h"
#include "drive/job_check.h"
#include "drive/outputs.h"
#include "drive/planning.h"
#include "passes/pass_program.h"
#include "program/machining_main.h"

int
main(int argc, char** argv)
{
  return machiningMain("pcl_spiral_drive", argc, argv, parseCommandLine, printHelp);
}
