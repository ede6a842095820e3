// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a plan to a machine program, or to moves of a robot, whose tool is clear of the scan on its leads and links.
 */
#pragma once

#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/machine/tool_moves.h>
#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/planning/spiral_plan.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** The ways of the tool between passes. */
struct PassLinks {
  double height = 0.0; ///< of the highest tip on them, along the direction of the first rotary axis, mm
};

/** The links of \p program on which the tool goes up, over, and down again. */
PassLinks linksOf(const MachineProgram& program);

/** Makes the program of a plan, as pcl_spiral_toolpath, pcl_spiral_drive and pcl_spiral_ridge do: MachineProgramGenerator, with a link near
 *  the surface only where it is free (ProgramSettings::stay_down), then the checks of leads (LeadCheck) and of shank and holder as the
 *  machine moves them (HolderCheck). Rapids of a spiral over a part cross above everything in the scan. A beam is checked for places where
 *  it nearly stops.
 *  \code
 *  ProgramPlanner planner;
 *  planner.setInputPlan(spiral.getPlan());
 *  planner.setMachine(xyzacTrunnion());
 *  MachineProgram program;
 *  planner.compute(program);              // empty on failure
 *  if (!planner.getStatus().ok()) ...
 *  \endcode */
class ProgramPlanner {
public:
  /** The plan of a spiral; its feed and ball radius count. */
  void setInputPlan(const SpiralPlan& plan);
  /** The plan of passes; the feed is that of setSettings. */
  void setInputPlan(const PassPlan& plan);

  /** The machine of the program. Must be set for one; moves and links need none. */
  void setMachine(const Machine& machine) { machine_ = machine; }
  const Machine& getMachine() const { return machine_; } ///< The value of setMachine.
  /** Leads, links, heights and tolerances. The ball radius is that of the plan, and for a spiral the feed, too; rapids cross above
   *  clear_box and above the box of the plan (SpiralPlan::clearBox, PassPlan::clearBox). Without points of what stands around no link
   *  stays near the surface. */
  void setSettings(const ProgramSettings& settings) { settings_ = settings; }
  const ProgramSettings& getSettings() const { return settings_; } ///< The value of setSettings.
  /** If false, leads are not looked at, as for moves of a plan whose program was checked; true by default. */
  void setCheckLeads(bool check) { check_leads_ = check; }
  bool getCheckLeads() const { return check_leads_; } ///< The value of setCheckLeads.
  /** If true, compute prints nothing to the console when it fails; false by default. The status is the same. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; } ///< The value of setQuiet.
  /** Called with the share done, of leads and then of the holder; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Makes the program. \p program is empty on failure: as MachineProgramGenerator, or the tool would touch the scan and that is not
   *  accepted (LedTool::accepted). */
  void compute(MachineProgram& program);
  /** Makes moves with leads for CLDATA and robots (ledPasses), with the leads checked. \p moves is empty on failure. */
  void compute(std::vector<ToolMoves>& moves);

  /** Looks at the ways between passes alone, as a program for xyzacTrunnion would make them: for a path file, whose tool is lifted by what
   *  reads it. \p links is empty on failure. */
  void compute(PassLinks& links);

  const Status& getStatus() const { return status_; }          ///< Result of the last compute.
  const Diagnostics& getWarnings() const { return warnings_; } ///< Warnings of the last compute.
  /** Whether the last compute failed in MachineProgramGenerator: on the machine, which cannot make the moves, or on the settings. */
  bool isMachineFault() const { return machine_fault_; }

private:
  /** What a plan gives. */
  struct Planned {
    std::vector<ToolPoses> passes;
    pcl::PointCloud<pcl::PointXYZ>::ConstPtr whole;  ///< everything in the scan; null: leads are not checked
    pcl::PointCloud<pcl::PointXYZ>::ConstPtr points; ///< what holder and shank must not touch; null: the mesh
    SurfaceMesh::ConstPtr mesh;
    Diagnostic remedy; ///< against collisions of the holder
    LedTool tool;
    bool check_holder = false; ///< not at contacts that nobody checked
    double ball_radius = 0.0;  ///< 0: no ball
    double feed = 0.0;         ///< mm/min; 0: that of the settings
    Eigen::AlignedBox3d clear_box;
  };

  Status run(MachineProgram& program);
  Status run(std::vector<ToolMoves>& moves);
  Status run(PassLinks& links);
  template <typename Made>
  void computeBy(Made& made);
  Status make(MachineProgram& program);
  Status makeLinked(const std::vector<std::size_t>& retracted, MachineProgram& program);
  Status checkLeads(const MachineProgram& program);
  ProgramSettings usedSettings() const;

  Planned planned_;
  Machine machine_;
  ProgramSettings settings_;
  ProgressCallback progress_;
  Status status_;
  Diagnostics warnings_;
  bool machine_fault_ = false, check_leads_ = true, quiet_ = false;
};

} // namespace pcl_spiral
