// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings for one run of pcl_spiral_verify.
 */
#pragma once

#include "judging/filed_path.h"
#include "judging/judge_options.h"
#include "report/picture_files.h"

#include <pcl_spiral/verify/verification.h>

#include <ostream>
#include <string>
#include <vector>

/** The user's settings for one run. */
struct VerifyJob : JudgeOptions, ProgramReading {
  std::string raw_scan;             ///< before it was smoothed; empty: not given
  std::vector<std::string> paths;   ///< those of the files
  std::vector<std::string> outputs; ///< .json .html .png .vtp .glb .gltf .pvd
  std::vector<std::string> stock;   ///< files for the surface after cutting: .ply .stl
  pcl_spiral::Limits limits;

  const std::string& scan() const { return files.front(); } ///< The scan or the mesh.
};

/** \throw UsageError */
VerifyJob parseVerifyCommandLine(int argc, const char* const* argv);

/** The pictures of an output NAME.png, itself first. */
const std::vector<PictureName>& verifyPictures();

/** The files of one output: itself, with the pictures beside a NAME.png and the moments beside a NAME.pvd. */
std::vector<std::string> filesOf(const std::string& output);

/** Every file that the job writes: the outputs, with the pictures beside each NAME.png, then those of the stock. */
std::vector<std::string> filesOf(const VerifyJob& job);

void printVerifyHelp(std::ostream& out);
