// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings for one run of pcl_spiral_verify.
 */
#pragma once

#include "judging/judge_options.h"
#include "report/picture_files.h"
#include "terminal/region_choice.h"
#include <pcl_spiral/planning/impl/path_judging.h>

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/verify/verification.h>

#include <ostream>
#include <string>
#include <vector>

/** The user's settings for one run. */
struct VerifyJob {
  std::string command; ///< the call as typed
  std::string scan;
  std::string raw_scan; ///< before it was smoothed; empty: not given
  std::vector<std::string> paths;
  std::vector<std::string> outputs; ///< .json .html .png .vtp
  std::vector<std::string> stock;   ///< files for the surface after cutting: .ply .stl
  pcl_spiral::ReadOptions read;
  std::optional<MeshChoice> mesh;             ///< absent: the first file is a scan
  PartOptions part;                           ///< of the scan
  RegionChoice regions;                       ///< of the scan
  std::string machine_file;                   ///< of programs; empty: none
  std::optional<pcl_spiral::Dialect> dialect; ///< of .nc programs; absent: found from their words
  pcl_spiral::JudgeSettings settings;
  pcl_spiral::Limits limits;
  bool quiet = false;
  bool help = false;
  bool version = false;
};

/** \throw UsageError */
VerifyJob parseVerifyCommandLine(int argc, const char* const* argv);

/** The pictures of an output NAME.png, itself first. */
const std::vector<PictureName>& verifyPictures();

/** Every file that the job writes: the outputs, with the pictures beside each NAME.png, then those of the stock. */
std::vector<std::string> filesOf(const VerifyJob& job);

void printVerifyHelp(std::ostream& out);
