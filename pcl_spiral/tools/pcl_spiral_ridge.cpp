// SPDX-License-Identifier: BSD-3-Clause
// Makes rows of a beam or a cutter over a ridge from two measured lines of it, or from a scan.
#include "passes/pass_program.h"
#include "program/machining_main.h"
#include "ridge/command_line.h"
#include "ridge/job_check.h"
#include "ridge/outputs.h"
#include "ridge/planning.h"

int
main(int argc, char** argv)
{
  return machiningMain("pcl_spiral_ridge", argc, argv, parseCommandLine, printHelp);
}
