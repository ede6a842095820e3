// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The report of a run, as JSON and as a readable page.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "run_options.h"
#include "verification_writer.h"
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/planning/spiral_plan.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** A mesh; its samples are the points of a run. */
struct RunMesh {
  MeshCounts counts;
  double sample_spacing = 0.0; ///< mm
};

/** The input and output files of a run. */
struct RunFiles {
  std::string scan;
  LengthUnit unit = LengthUnit::Millimetre;         ///< of the numbers in the scan
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< subtracted from the scan, in its unit
  std::vector<std::string> outputs;
  Diagnostics warnings;                            ///< from reading
  std::optional<RunMesh> mesh;                     ///< if the points are samples of a mesh
  RunOptions options = {};                         ///< of the program, as they were given
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< of map coordinates, mm, see Scan::shift; places are in the coordinates of the scan
  Vocabulary words = {};                           ///< of what the run says
  std::vector<PlanAttempt> attempts = {};          ///< of a run of one region
};

/** One of several regions of a run. */
struct RegionReport {
  std::string name;
  SpiralReport report;
  std::optional<Verification> verification; ///< absent: not judged
  std::vector<ReportPicture> judged;        ///< pictures of its verification
  std::vector<PlanAttempt> attempts = {};   ///< to plan it
};

/** Input, settings, loops, counts, time and memory of each stage and warnings of a run, and the figures of the path if it was
 * judged (null: not judged). Of several \p regions, \p report is of all together, and each is judged on its own. Units: mm, degrees,
 * seconds, MB (10^6 bytes; see MemoryUse). \throw FileError */
void writeReportJSON(const std::string& file, const RunFiles& files, const SpiralSettings& settings, const SpiralReport& report,
                     const Verification* verification = nullptr, const std::vector<RegionReport>& regions = {});

/** The same as one HTML file that needs no other file, with \p pictures of the path and the pictures \p judged of its verification.
 *  \throw FileError */
void writeReportHTML(const std::string& file, const ReportPage& page, const RunFiles& files, const SpiralSettings& settings,
                     const SpiralReport& report, const std::vector<ReportPicture>& pictures, const Verification* verification = nullptr,
                     const std::vector<ReportPicture>& judged = {}, const std::vector<RegionReport>& regions = {});

} // namespace pcl_spiral
