// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <pcl_spiral/common/impl/thread_limit.h>

bool
isGiven(const ProgramRun& run, const std::string& option)
{
  return run.given.count(option) > 0;
}

Option
configOption(ProgramRun& run)
{
  return textOption(
      "config", "FILE",
      "job file in YAML with these option names, or the .json report of a run, which is then made again; the command line has "
      "priority: --config job.yaml",
      run.config_file);
}

OptionGroup
runOptions(ProgramRun& run, unsigned int& threads)
{
  OptionGroup group{"Run", {}};
  addSettings(group, {pcl_spiral::threadsSetting(threads)});
  addOptions(group, {switchOption("quiet", "print only errors", run.quiet), switchOption("help", "print this text", run.help),
                     switchOption("version", "print the version", run.version)});
  return group;
}
