// SPDX-License-Identifier: BSD-3-Clause
#include "drive_report.h"
#include "passes/pass_report.h"

#include "io/report/run_options.h"
#include "io/report/settings_json.h"
#include "io/report/side_json.h"
#include "io/setting_names.h"
#include "mesh/mesh_findings.h"

#include <nlohmann/json.hpp>

using namespace pcl_spiral;
using Json = nlohmann::ordered_json;

namespace {

Json
settingsOf(const Job& job)
{
  Json settings = {{"cutter", cutterOf(job)},
                   {"gouge_check", !job.no_gouge_check},
                   {"largest", job.largest_part},
                   {"thin", job.thinning},
                   {"feed", job.feed}};
  settings.update(settingsJson(job.drive));
  settings["axis_mode"] = choiceName(job.drive.axisMode());
  settings.update(settingsJson(static_cast<const PassSettings&>(job)));
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
  const MeshCounts& counts = mesh.counts();
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

void
writeDriveReport(const std::string& file, const Job& job, const Result& result)
{
  Json report = {{"program", "pcl_spiral_drive"},
                 {"scan", job.scan},
                 {"options", optionsJson(job.options)},
                 {"settings", settingsOf(job)},
                 {"step_over", result.drive.step_over}};
  if (result.mesh)
    report["mesh"] = meshOf(*result.mesh);
  else {
    report["points"] = result.cloud->size();
    report["side"] = sideJson(result.side);
  }
  if (job.drive.kind == DriveKind::Planes)
    report["rows"] = rowsOf(result.drive);
  for (const PlannedRegion& region : result.regions)
    report["regions"].push_back({{"region", region.name}, {"passes", region.passes}, {"locations", region.locations}});
  report["drive_points"] = result.drive.points;
  addPasses(result, report);
  writeJSON(file, report);
}
