// SPDX-License-Identifier: BSD-3-Clause
#include "scene_builder.h"
#include <pcl_spiral/io/pass_report_writer.h>
#include <pcl_spiral/io/report_writer.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

void
addRegionOf(const SpiralPlan& plan, const Heights* judged, SceneBuilder& scene)
{
  if (plan.mesh)
    scene.addFaces(*plan.mesh->mesh, judged);
  else if (plan.surface)
    scene.addScan(*plan.surface, judged);
}

void
addPartOf(const PassPlan& plan, SceneBuilder& scene)
{
  if (plan.mesh)
    return scene.addFaces(*plan.mesh, nullptr);
  if (plan.surface)
    scene.addScan(*plan.surface, nullptr);
  for (const PlannedRegion& region : plan.regions)
    if (region.surface && region.surface != plan.surface)
      scene.addScan(*region.surface, nullptr);
}

} // namespace

std::shared_ptr<const ReportScene>
reportScene(const SpiralPlan& plan, const std::vector<Heights>& judged, const std::vector<Verification>& figures,
            const std::optional<MachineProgram>& program, const std::optional<MotionStudy>& motion)
{
  SceneBuilder scene(plan.tool.cutter, plan.tool.holder);
  const std::size_t regions = std::max<std::size_t>(1, plan.regions.size());
  ShownPath path{plan.path, {}, plan.report.pass_begins, plan.settings.feed, {}, {}};
  for (std::size_t k = 0; k < regions; ++k) {
    const Heights* const own = k < judged.size() ? &judged[k] : nullptr;
    addRegionOf(plan.regions.empty() ? plan : plan.regions[k], own, scene);
    if (own)
      path.deviation.insert(path.deviation.end(), own->deviation.begin(), own->deviation.end());
  }
  if (path.deviation.size() != plan.path->size())
    path.deviation.clear();
  for (const Verification& found : figures)
    scene.addFigures(found, plan.settings.chord_error);
  if (program)
    scene.setProgram(shownProgram(*program, motion ? &*motion : nullptr, path), path);
  else
    scene.addPath(path);
  return scene.build();
}

std::shared_ptr<const ReportScene>
reportScene(const PassPlan& plan, double feed, const std::optional<MachineProgram>& program, const std::optional<MotionStudy>& motion)
{
  SceneBuilder scene(plan.tool.cutter, plan.tool.holder);
  addPartOf(plan, scene);
  scene.setTurnWord("Pass");
  PassPath joined = joinedPasses(plan.passes);
  const ShownPath path{pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(std::move(joined.path)), joined.tips, joined.begins, feed, {}, {}};
  if (program)
    scene.setProgram(shownProgram(*program, motion ? &*motion : nullptr, path), path);
  else
    scene.addPath(path);
  return scene.build();
}

} // namespace pcl_spiral
