// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  CLDATA and robot frames: paths with their leads, for other machines.
 */
#pragma once

#include "program_job.h"

#include <pcl_spiral/io/path_exchange.h>

#include <optional>
#include <string>
#include <vector>

/** What such a file contains. */
struct ExchangePath {
  std::string title;
  pcl_spiral::AptCutter cutter;
  std::vector<pcl_spiral::ToolMoves> moves; ///< of the passes, with their leads
};

/** Prints by how much the x of the robot frames of \p moves turns, if one of \p outputs has robot frames. */
void printFrames(const ProgramJob& job, const std::vector<pcl_spiral::ToolMoves>& moves, const std::vector<std::string>& outputs);

/** Writes \p file for \p output; CLDATA has the moves of \p program if there is one. \throw pcl_spiral::FileError */
void writeExchange(const ProgramJob& job, const ExchangePath& path, const std::optional<pcl_spiral::MachineProgram>& program,
                   const std::string& output, const std::string& file);
