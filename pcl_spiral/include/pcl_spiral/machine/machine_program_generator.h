/** \file
 *  From tool poses to the moves of a machine.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/machine/impl/block_spacing.h>
#include <pcl_spiral/machine/machine_program.h>

#include <pcl/point_cloud.h>

namespace pcl_spiral {

/** How the tool comes to the path and leaves it. */
enum class LeadKind {
  Normal, ///< straight along the surface normal
  Arc     ///< a quarter circle from the normal into the direction of travel
};

/** Settings of a program. */
struct ProgramSettings {
  double feed = 1000.0; ///< at the contact, mm/min
  double ball_radius =
      0.0;                ///< of a ball cutter, mm: its centre stays as an axis is blended; 0: the tip stays
  double pole_cone = 5.0; ///< axes are blended within this angle of the pole alone, degrees
  BlockTolerance block;   ///< that the machine keeps between poses
  BlockTolerance thinning{0.0, 0.0}; ///< poses are left out within this; 0: none
  LeadKind lead = LeadKind::Normal;
  double lead_length = 2.0;   ///< mm; the radius of an arc
  double clearance = 5.0;     ///< the feed begins this far along the tool axis from the lead, mm
  double rapid_height = 50.0; ///< rapids cross this far above the highest tip, mm
};

/** Poses of a ball cutter along \p path, as one pass: over the lifts of a path of several it would cut, see ballPasses. */
ToolPoses ballPoses(const pcl::PointCloud<ToolpathPoint>& path, double ball_radius);
/** The same of each pass of \p path, as passBegins finds them. */
std::vector<ToolPoses> ballPasses(const pcl::PointCloud<ToolpathPoint>& path, double ball_radius);

/** Lays a path on a machine: angles on one branch, unwound, blended at the pole; blocks split where the
 * machine would leave the path and thinned where it would not; a finite first axis retracts, unwinds and
 * comes back at its limit; leads; the time of every block, at the feed or as slow as the slowest axis asks;
 * limits of every axis checked.
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
  void
  setMachine(const Machine& machine)
  {
    machine_ = machine;
  }
  const Machine&
  getMachine() const
  {
    return machine_;
  }

  /** Poses of any cutter, in travel order. */
  void
  setInputPoses(const ToolPoses& poses)
  {
    passes_ = {poses};
  }
  /** The same for several passes: the tool leaves the surface after each and comes down to the next. */
  void
  setInputPasses(const std::vector<ToolPoses>& passes)
  {
    passes_ = passes;
  }
  /** The poses of a ball cutter of \p ball_radius mm along the passes of \p path (ballPasses); sets the ball radius too. */
  void setInputPath(const pcl::PointCloud<ToolpathPoint>& path, double ball_radius);
  const std::vector<ToolPoses>&
  getInputPasses() const
  {
    return passes_;
  }

  void
  setSettings(const ProgramSettings& settings)
  {
    settings_ = settings;
  }
  const ProgramSettings&
  getSettings() const
  {
    return settings_;
  }

  /** \p program is empty on failure: a machine that cannot be, a setting out of range, a tool axis out of
   * reach, an axis beyond its limits. */
  void compute(MachineProgram& program);

  const Status&
  getStatus() const
  {
    return status_;
  }

private:
  Status check() const;
  Status computeProgram(MachineProgram& program) const;

  Machine machine_;
  std::vector<ToolPoses> passes_;
  ProgramSettings settings_;
  Status status_;
};

} // namespace pcl_spiral
