// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Cutter locations on passes: made, checked, and turned into passes of poses.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/planning/pass_plan.h>

#include <vector>

namespace pcl_spiral {

/** Sets the part of a stage: the mesh, or the scan's points and the surface through them. */
template <typename Stage>
void
setPart(const PassPlan& plan, const SurfaceSettings& settings, Stage& stage)
{
  stage.setNumberOfThreads(settings.threads);
  if (plan.mesh) {
    stage.setInputMesh(plan.mesh);
    return;
  }
  stage.setInputCloud(plan.cloud);
  stage.setInputSurface(plan.surface); // null: the stage reports what is wrong
  stage.setLargestPart(settings.largest_part && !settings.part_at);
  stage.setThinning(settings.thinning);
}

/** The tool of \p settings on passes whose locations are known. */
LedTool toolOf(const PassSettings& settings, const PassPlan& plan);

/** Puts the cutter on the part of \p plan along \p passes. Fails as CutterLocation. */
Status locateCutter(const PassSettings& settings, const SurfaceSettings& surface, const DrivePasses& passes,
                    const ProgressCallback& progress, PassPlan& plan, std::vector<ToolLocations>& located);

/** The cutter at the given contacts, without a check for gouges. */
std::vector<ToolLocations> standAtContacts(const PassSettings& settings, const DrivePasses& passes);

/** Takes the locations as passes of \p plan, without those that are off the part. Failed with the place if shank or holder are in the part
 *  at a location or on the way between them, unless that is accepted, or if the scan goes on above the end of the tool, and nothing says
 *  how long the tool is or from where it comes; with the text \p none if no pass is left. */
Status takeChecked(const PassSettings& settings, const std::vector<ToolLocations>& located, const Diagnostic& none, PassPlan& plan);

/** Adds the warnings about locations. */
void warnOfLocations(const PassSettings& settings, PassPlan& plan);

} // namespace pcl_spiral
