// SPDX-License-Identifier: BSD-3-Clause
#include "pass_json.h"
#include "run_options.h"
#include "settings_json.h"
#include "side_json.h"

#include "io/setting_names.h"
#include "mesh/mesh_findings.h"

#include <stdexcept>

namespace pcl_spiral {

using Json = nlohmann::ordered_json;

namespace {

Json
settingsOf(const DriveRun& run)
{
  Json settings = {{"cutter", cutterJson(run.tool.cutter)},
                   {"gouge_check", run.gouge_check},
                   {"largest", run.largest_part},
                   {"thin", run.thinning},
                   {"feed", run.feed}};
  settings.update(settingsJson(run.drive));
  settings["axis_mode"] = choiceName(run.drive.axisMode());
  settings.update(settingsJson(run.tool));
  return settings;
}

Json
rowsOf(const DriveReport& report)
{
  return {{"count", report.rows},
          {"smallest_step", report.smallest_step},
          {"largest_step", report.step_over},
          {"held_share", report.held_share},
          {"links", report.links},
          {"apart", report.rows_apart}};
}

Json
meshOf(const SurfaceMesh& mesh)
{
  const MeshReport& counts = mesh.report();
  Json found;
  for (const auto& [words, finding] : mendedFindings(counts))
    found[words] = finding.count;
  return {{"faces", counts.faces},
          {"vertices", counts.vertices},
          {"parts", counts.parts},
          {"boundary_loops", counts.loops},
          {"crease_length", counts.crease_length},
          {"noise", counts.noise},
          {"uncorrected_edges", counts.limited.count},
          {"found", found}};
}

} // namespace

std::string
driveReportJSON(const RunFiles& files, const DriveRun& run, const PassPlan& plan)
{
  if (!plan.mesh && !plan.cloud)
    throw std::invalid_argument("driveReportJSON: the plan is empty; it is one of a planner that succeeded");
  Json report = {{"program", "pcl_spiral_drive"},
                 {"scan", files.scan},
                 {"options", optionsJson(files.options)},
                 {"settings", settingsOf(run)},
                 {"step_over", plan.drive.step_over}};
  if (plan.mesh)
    report["mesh"] = meshOf(*plan.mesh);
  else {
    report["points"] = plan.cloud->size();
    report["side"] = sideJson(plan.side);
  }
  if (run.drive.kind == DriveKind::Planes)
    report["rows"] = rowsOf(plan.drive);
  for (const PlannedRegion& region : plan.regions)
    report["regions"].push_back({{"region", region.name}, {"passes", region.passes}, {"locations", region.locations}});
  report["drive_points"] = plan.drive.points;
  addPasses(files, run, plan, report);
  return jsonText(report);
}

void
writeDriveReportJSON(const std::string& file, const RunFiles& files, const DriveRun& run, const PassPlan& plan)
{
  writeText(file, driveReportJSON(files, run, plan));
}

} // namespace pcl_spiral
