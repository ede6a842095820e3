// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The report of a run, as JSON and as a readable page.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/report_page.h>
#include <pcl_spiral/machine/motion_time.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/planning/spiral_plan.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/verify/verification.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

struct Heights;

/** A mesh; its samples are the points of a run. */
struct RunMesh {
  MeshReport counts;           ///< of the mesh as given
  double sample_spacing = 0.0; ///< mm
};

/** What a report says of a run beside its path. */
struct RunFiles {
  std::string scan;                                 ///< its file, or that of the mesh
  LengthUnit unit = LengthUnit::Millimetre;         ///< of the numbers in the scan
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< subtracted from the scan, in its unit
  std::vector<std::string> outputs;                 ///< files of the run
  Diagnostics warnings;                             ///< from reading
  RunOptions options = {};                          ///< of a program, as they were given
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< of map coordinates, mm, see Scan::shift: added to all places
  Vocabulary words = {};                            ///< of what the run says
};

/** What was found of the path over a part, or over one of its regions. */
struct PathReport {
  std::string name;                         ///< of the region; empty: the whole part
  SpiralReport report;                      ///< of planning
  std::optional<Verification> verification; ///< absent: not judged
  std::vector<ReportPicture> judged = {};   ///< pictures of its verification
  std::vector<PlanAttempt> attempts = {};   ///< to plan it
};

/** A path with its settings. */
struct RunReport : PathReport {
  SpiralSettings settings;                  ///< as used
  std::optional<MotionStudy> motion;        ///< of the program, if one was made
  std::optional<RunMesh> mesh;              ///< if the points are samples of a mesh
  std::vector<ReportPicture> pictures;      ///< of the path
  std::vector<PathReport> regions;          ///< if there are several; what is above is then of all together, and each is judged on its own
  std::shared_ptr<const ReportScene> scene; ///< in 3-D, see reportScene; null: pictures alone
};

/** What \p plan says. \p judged: of its path, or of each of its regions; empty: not judged.
 *  \code
 *  RunFiles files;
 *  files.scan = "part.pcd";
 *  const RunReport report = reportOf(planner.getPlan(), {found}); // a SpiralPlanner, and what PathVerifier found
 *  writeReportJSON("part.json", files, report);
 *  writeReportHTML("part.html", {"part.pcd", "", ""}, files, report);
 *  \endcode */
RunReport reportOf(const SpiralPlan& plan, const std::vector<Verification>& judged = {});

/** \p plan in 3-D, for RunReport::scene: its part, if the plan has its surface (SpiralPlanner::setKeepSurface) or a mesh; the tool along
 *  its path, or along \p program in the times of \p motion. \p judged and \p figures: what PathVerifier found of it, or of each of its
 *  regions; empty: not judged. */
std::shared_ptr<const ReportScene> reportScene(const SpiralPlan& plan, const std::vector<Heights>& judged = {},
                                               const std::vector<Verification>& figures = {},
                                               const std::optional<MachineProgram>& program = {},
                                               const std::optional<MotionStudy>& motion = {});

/** Input, settings, loops, counts, time and memory of each stage and warnings of a run, and the figures of the path if it was judged; no
 *  pictures. Units: mm, degrees, seconds, MB (10^6 bytes; see MemoryUse). \throw FileError */
void writeReportJSON(const std::string& file, const RunFiles& files, const RunReport& report);
/** The same as a text. */
std::string reportJSON(const RunFiles& files, const RunReport& report);

/** The same as one HTML file that needs no other file, with the pictures. \throw FileError */
void writeReportHTML(const std::string& file, const ReportPage& page, const RunFiles& files, const RunReport& report);

} // namespace pcl_spiral
