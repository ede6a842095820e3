// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reports of passes, as JSON and as a readable page.
 */
#pragma once

#include <pcl_spiral/io/report_page.h>
#include <pcl_spiral/io/report_writer.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/planning/ridge_plan.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What a report of passes says beside their plan and the files of the run. Lengths in mm. */
struct PassRun {
  PassSettings tool;                                  ///< of the planner
  double feed = 1000.0;                               ///< mm/min
  std::optional<MachineProgram> program;              ///< absent: none was made
  std::optional<MotionStudy> motion;                  ///< of the program; absent: its time is not known
  std::shared_ptr<const ReportScene> scene = nullptr; ///< in 3-D, for the page; null: pictures alone
};

/** Passes of DrivePlanner, with what it was told. */
struct DriveRun : PassRun {
  DriveSettings drive;       ///< of the planner
  bool gouge_check = true;   ///< DrivePlanner::setGougeCheck
  bool largest_part = false; ///< SurfaceSettings::largest_part
  double thinning = 0.0;     ///< SurfaceSettings::thinning
};

/** Rows of RidgePlanner, with what it was told. */
struct RidgeRun : PassRun {
  std::string rail;        ///< file of the measured rail; empty: both lines were found in the scan
  std::string generator;   ///< the same of the generator
  RidgeSettings ridge;     ///< of measured lines
  RidgeRowSettings rows;   ///< of the planner
  Polyline rough_points;   ///< RidgePlanner::setRoughPoints
  double half_width = 0.0; ///< RidgePlanner::setHalfWidth
  bool closed = false;     ///< RidgePlanner::setClosed
};

/** \p plan in 3-D, for PassRun::scene: its part, and the tool along its passes at \p feed mm/min, or along \p program in the times of
 *  \p motion. */
std::shared_ptr<const ReportScene> reportScene(const PassPlan& plan, double feed, const std::optional<MachineProgram>& program = {},
                                               const std::optional<MotionStudy>& motion = {});

/** Settings, counts, states of locations, collisions, times and warnings of a drive path. \throw FileError; std::invalid_argument for
 *  an empty plan */
void writeDriveReportJSON(const std::string& file, const RunFiles& files, const DriveRun& run, const PassPlan& plan);
/** The same as a text. \throw std::invalid_argument for an empty plan */
std::string driveReportJSON(const RunFiles& files, const DriveRun& run, const PassPlan& plan);

/** The same as one HTML file that needs no other, with \p pictures. \throw FileError; std::invalid_argument for
 *  an empty plan */
void writeDriveReportHTML(const std::string& file, const ReportPage& page, const RunFiles& files, const DriveRun& run, const PassPlan& plan,
                          const std::vector<ReportPicture>& pictures);

/** Settings, both lines, rows, locations, times and warnings of rows over a ridge. \throw FileError; std::invalid_argument for
 *  an empty plan */
void writeRidgeReportJSON(const std::string& file, const RunFiles& files, const RidgeRun& run, const PassPlan& plan,
                          const RidgePlanReport& figures);
/** The same as a text. \throw std::invalid_argument for an empty plan */
std::string ridgeReportJSON(const RunFiles& files, const RidgeRun& run, const PassPlan& plan, const RidgePlanReport& figures);

/** The same as one HTML file that needs no other, with \p pictures. \throw FileError; std::invalid_argument for an empty plan */
void writeRidgeReportHTML(const std::string& file, const ReportPage& page, const RunFiles& files, const RidgeRun& run, const PassPlan& plan,
                          const RidgePlanReport& figures, const std::vector<ReportPicture>& pictures);

} // namespace pcl_spiral
