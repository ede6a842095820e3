// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings for one run of pcl_spiral_toolpath.
 */
#pragma once

#include "program/program_job.h"
#include "terminal/program_run.h"
#include "terminal/region_choice.h"
#include "terminal/scan_places.h"
#include <pcl_spiral/verify/verification.h>

#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/planning/impl/spiral_planning.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <string>
#include <vector>

/** The user's settings for one run. */
struct Job : ProgramRun {
  std::string scan;
  std::string raw_scan; ///< before it was smoothed; empty: not given
  std::vector<std::string> outputs;
  std::string reach;              ///< file for the map of the largest balls that reach the points; empty: none
  std::vector<std::string> stock; ///< files for the surface after cutting; with verify
  pcl_spiral::ReadOptions read = readFindingOrigin();
  pcl_spiral::SpiralSettings settings;
  PartOptions part;          ///< of the scan; with several regions that of the present one
  RegionChoice regions;      ///< of the scan
  double flank_length = 0.0; ///< mm, between the centre of the ball and the holder
  std::vector<pcl_spiral::ToolSegment> holder;
  double holder_clearance = 0.0; ///< mm
  ProgramJob program;
  bool ball_closing = false;                               ///< the scan is closed by the ball along the tool axis
  int remedy_tries = pcl_spiral::PlanInput().remedy_tries; ///< see pcl_spiral::remedyTries
  bool mesh = false;                                       ///< the scan is a mesh, and its faces are used
  double sample_spacing = 0.0;                             ///< of the samples of the mesh, mm; 0: found from the mesh
  bool verify = false;                                     ///< check the path against the scan or the mesh
  pcl_spiral::Limits limits;                               ///< of the check
};
