// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The result of pcl_spiral_toolpath and its output files.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "job.h"
#include "terminal/scan_side.h"
#include <pcl_spiral/planning/impl/path_judging.h>

#include <pcl_spiral/io/output_files.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/machine/motion_time.h>
#include <pcl_spiral/machine/tool_moves.h>
#include <pcl_spiral/planning/program_planner.h>
#include <pcl_spiral/planning/spiral_plan.h>
#include <pcl_spiral/verify/stock_mesh.h>

#include <optional>
#include <string>
#include <vector>

/** What judging a path gave. */
struct Judged {
  std::optional<pcl_spiral::Verification> verification; ///< if the path was judged
  pcl_spiral::Heights heights;                          ///< the values behind it
  pcl_spiral::StockMesh left;                           ///< the surface after cutting, with --stock
};

/** The result of a run. */
struct Result {
  pcl_spiral::SpiralPlan plan;                       ///< of all regions
  Judged judged;                                     ///< of all regions
  std::vector<Judged> regions;                       ///< of each region of the plan, if there are several
  pcl_spiral::PassLinks links;                       ///< between the regions
  pcl_spiral::Diagnostics reading;                   ///< warnings of the reader
  ScanSide side;                                     ///< what decides the side of the scan
  std::optional<pcl_spiral::MachineProgram> program; ///< if a machine is given
  std::optional<pcl_spiral::MotionStudy> motion;     ///< of the program
  std::vector<pcl_spiral::ToolMoves> moves;          ///< with leads, if an output is CLDATA or has robot frames
};

/** Warnings of reading, planning and judging. */
pcl_spiral::Diagnostics warningsOf(const Result& result);

/** Writes all files of the job, or none. Reports come last: they contain the time of drawing and writing, which is
 * added to the stages of \p result. \throw pcl_spiral::FileError, Cancelled */
void writeOutputs(const Job& job, Result& result, pcl_spiral::OutputFiles& files);
