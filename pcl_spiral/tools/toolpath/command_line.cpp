// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "job_check.h"
#include "option_table.h"
#include "terminal/command_line.h"
#include "terminal/vocabulary.h"

Job
parseCommandLine(int argc, const char* const* argv)
{
  return parseJob<Job>(argc, argv, optionTable, checkJob);
}

std::vector<std::string>
ownOptions()
{
  Job job;
  return namesOf(optionTable(job));
}

void
printHelp(std::ostream& out)
{
  Job job;
  out << "Makes one continuous spiral toolpath over a scanned surface or a mesh, for a ball cutter.\n\n"
         "  pcl_spiral_toolpath SCAN -o OUT... --tool-radius R --scallop H [options]\n\n"
         "  pcl_spiral_toolpath part.pcd --tool-radius 10 --scallop 0.05 -o part.csv -o part.vtp -o "
         "part.png\n\n"
         "Lengths are in millimetres, angles in degrees. Exit code: 0 on success, 1 if the data or a file "
         "fails,\n"
         "2 if the command line is wrong or an option does not fit the scan. On 1 and 2 no output is written or changed.\n";
  printOptions(out, optionTable(job));
}
