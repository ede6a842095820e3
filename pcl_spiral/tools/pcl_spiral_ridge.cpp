// SPDX-License-Identifier: BSD-3-Clause
// From two measured lines of a ridge, or a scan of it, to rows of a beam or a cutter over it.
#include "passes/pass_main.h"
#include "ridge/command_line.h"
#include "ridge/job_check.h"
#include "ridge/outputs.h"
#include "ridge/planning.h"

int
main(int argc, char** argv)
{
  return passMain("pcl_spiral_ridge", argc, argv, parseCommandLine, printHelp);
}
