// SPDX-License-Identifier: BSD-3-Clause
// Makes toolpath files from a scan or a mesh: the main program.
#include "program/machining_main.h"
#include "toolpath/command_line.h"
#include "toolpath/console.h"
#include "toolpath/job_check.h"
#include "toolpath/outputs.h"
#include "toolpath/path_judging.h"
#include "toolpath/path_program.h"
#include "toolpath/planning.h"

int
main(int argc, char** argv)
{
  return machiningMain("pcl_spiral_toolpath", argc, argv, parseCommandLine, printHelp);
}
