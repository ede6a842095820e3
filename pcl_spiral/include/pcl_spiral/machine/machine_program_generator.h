// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Makes the moves of a machine from tool poses.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/setting.h>
#include <pcl_spiral/machine/machine_program.h>

#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <optional>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** How the tool comes to the path and leaves it. */
enum class LeadKind {
  Normal, ///< straight along the surface normal
  Arc     ///< a quarter circle from the normal to the direction of travel
};

/** Settings of a program. */
struct ProgramSettings {
  double feed = 1000.0;              ///< at the contact, mm/min
  double plunge_feed = 0.0;          ///< of the tip down to the lead, mm/min; 0: the feed
  double lead_feed = 0.0;            ///< of the tip along the leads and off the surface, mm/min; 0: the feed
  double link_feed = 0.0;            ///< of links between passes, mm/min; 0: the feed
  double ball_radius = 0.0;          ///< of a ball cutter, mm: its centre stays while an axis is blended; 0: that of the path, else none
  double pole_cone = 5.0;            ///< axes are blended only within this angle of the pole, degrees; elsewhere blocks are slower
  BlockTolerance block;              ///< kept by the machine between poses
  BlockTolerance thinning{0.0, 0.0}; ///< poses are left out within this tolerance; 0: none
  LeadKind lead = LeadKind::Normal;  ///< how the tool comes and leaves
  double lead_length = 2.0;          ///< mm; for an arc its radius
  double clearance = 5.0;            ///< the feed begins this far along the tool axis from the lead, mm
  double stay_down = 0.0;            ///< links between passes up to this length stay near the surface, mm; 0: the tool retracts
  double rapid_height = 50.0;        ///< rapids cross at this height above the highest tip, mm
  Eigen::AlignedBox3d clear_box;     ///< and above this box, of what stands beside the path; empty: there is none
};

/** All of one value, but for the feed and the ball radius, which come with the path. */
std::vector<Setting> settingTable(ProgramSettings& settings);

/** Poses of a ball cutter along \p path, as one pass. On a path of several passes the lifts would cut: see ballPasses. */
ToolPoses ballPoses(const pcl::PointCloud<ToolpathPoint>& path, double ball_radius);
/** The same for each pass of \p path, as passBegins finds them. */
std::vector<ToolPoses> ballPasses(const pcl::PointCloud<ToolpathPoint>& path, double ball_radius);

/** Makes a program for a machine from a path. Angles are on one branch, unwound, and blended at the pole.
 *  Blocks are split where the machine would leave the path, and thinned where it would not. A first axis
 *  with limits retracts, unwinds and comes back at its limit. Leads are added. Every block gets its time,
 *  at the feed of the contact, but with the tip and the centre of the ball at no more than twice the feed, and as slow as the
 *  slowest axis needs. The limits of every axis are checked.
 *
 *  \code
 *  MachineProgramGenerator generator;
 *  generator.setMachine(machine);
 *  generator.setInputPath(path, 10.0); // ball radius
 *  MachineProgram program;
 *  generator.compute(program);         // empty on failure
 *  if (!generator.getStatus().ok()) ...
 *  \endcode */
class MachineProgramGenerator {
public:
  void setMachine(const Machine& machine) { machine_ = machine; } ///< The machine of the program.
  const Machine& getMachine() const { return machine_; }          ///< The value of setMachine.

  /** Poses of any cutter, in travel order. */
  void setInputPoses(const ToolPoses& poses) { setInputPasses({poses}); }
  /** The same for several passes: the tool leaves the surface after each pass and comes down to the next. */
  void setInputPasses(std::vector<ToolPoses> passes)
  {
    passes_ = std::move(passes);
    path_radius_.reset();
  }
  /** Poses of a ball cutter of \p ball_radius mm along the passes of \p path (ballPasses). This radius counts; one in the settings must
   *  be the same, or 0. */
  void setInputPath(const pcl::PointCloud<ToolpathPoint>& path, double ball_radius);
  const std::vector<ToolPoses>& getInputPasses() const { return passes_; } ///< The value of setInputPasses.

  /** Passes, counted from 0, before which the tool retracts although stay_down allows a link: those where LeadCheck finds the link in the
   *  way of something. None by default. */
  void setRetractedPasses(const std::vector<std::size_t>& passes) { retracted_ = passes; }
  const std::vector<std::size_t>& getRetractedPasses() const { return retracted_; } ///< The value of setRetractedPasses.

  void setSettings(const ProgramSettings& settings) { settings_ = settings; } ///< Feed, leads, tolerances; see ProgramSettings.
  const ProgramSettings& getSettings() const { return settings_; }            ///< The value of setSettings.

  /** Computes the program. \p program is empty on failure: an invalid machine, a
   *  setting out of range, a tool axis out of reach, an axis beyond its limits. */
  void compute(MachineProgram& program);

  /** If true, compute prints nothing to the console when it fails; false by default. The status is the same. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; } ///< The value of setQuiet.

  const Status& getStatus() const { return status_; } ///< Result of the last compute.

private:
  Status check(const ProgramSettings& settings) const;
  Status computeProgram(const ProgramSettings& settings, MachineProgram& program) const;

  Machine machine_;
  std::vector<ToolPoses> passes_;
  std::optional<double> path_radius_; ///< of setInputPath
  std::vector<std::size_t> retracted_;
  ProgramSettings settings_;
  bool quiet_ = false;
  Status status_;
};

} // namespace pcl_spiral
