/** \file
 *  What one run of pcl_spiral_verify is asked to do.
 */
#pragma once

#include "judging/figures_table.h"
#include "judging/judge.h"

#include <pcl_spiral/io/cloud_reader.h>

#include <ostream>
#include <string>
#include <vector>

/** A run as the user described it. */
struct VerifyJob {
  std::string scan;
  std::vector<std::string> paths;
  std::vector<std::string> outputs; ///< .json and .png
  pcl_spiral::ReadOptions read;
  JudgeSettings settings;
  Limits limits;
  bool quiet = false;
  bool help = false;
  bool version = false;
};

/** \throw UsageError */
VerifyJob parseVerifyCommandLine(int argc, const char* const* argv);

/** Every file the job makes: the outputs, and beside each picture NAME.png its NAME_stock.png and NAME_histogram.png. */
std::vector<std::string> filesOf(const VerifyJob& job);

/** .png of part.png */
std::string extensionOf(const std::string& file);

void printVerifyHelp(std::ostream& out);
