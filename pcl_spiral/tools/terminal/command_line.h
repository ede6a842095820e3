// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Sets options from the command line and a job file.
 */
#pragma once

#include "file_names.h"
#include "option_table.h"

#include <ostream>
#include <string>
#include <vector>

/** Sets the options of \p table from the command line; words without a name are the options \p files in that order. The file of
 *  --config is read as a job file; the command line has priority. \return what was set, without --config. \throw UsageError,
 *  pcl_spiral::FileError (job file) */
NamedValues setOptions(const OptionTable& table, int argc, const char* const* argv, const std::vector<std::string>& files = {"scan"});

/** A job from the command line: its options by \p table, then the rest by \p complete, unless it only asks for help or version. */
template <typename Job, typename Complete>
Job
parseJob(int argc, const char* const* argv, OptionTable (*table)(Job&), Complete complete, const std::vector<std::string>& files = {"scan"})
{
  Job job;
  job.command = commandLine(argc, argv);
  job.options = setOptions(table(job), argc, argv, files);
  for (const auto& option : job.options)
    job.given.insert(option.first);
  if (!job.help && !job.version)
    complete(job);
  return job;
}

void printOptions(std::ostream& out, const OptionTable& table);
