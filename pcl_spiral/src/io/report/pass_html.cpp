// SPDX-License-Identifier: BSD-3-Clause
#include "pass_html.h"

#include "motion_report.h"
#include "moved_places.h"

namespace pcl_spiral {

void
addPassVerdict(HtmlPage& page, const PassPlan& plan)
{
  const LocationReport& f = plan.locations;
  std::vector<std::string> grounds;
  if (f.collisions > 0)
    grounds.push_back(formatted("shank or holder collide at %zu locations, up to %.4g mm deep", f.collisions, f.deepest_collision));
  if (plan.left_out.count() > 0)
    grounds.push_back(formatted("%zu locations are left out because of keep-outs and the scan beside the part", plan.left_out.count()));
  if (plan.tool.cutter.radius > 0.0) // a beam leaves nothing to measure
    grounds.push_back("pcl_spiral_verify checks deviation, scallop and gouge against the part");
  page.addStatement(f.collisions > 0 ? Tone::Bad : Tone::Neutral, "Not judged", grounds);
}

std::vector<std::string>
passWarnings(const RunFiles& files, const PassPlan& plan)
{
  Diagnostics warnings = files.warnings;
  warnings.insert(warnings.end(), plan.warnings.begin(), plan.warnings.end());
  return textsOf(warnings, movedBy(files.shift, files.words));
}

HtmlRows
programRows(const PassRun& run)
{
  HtmlRows rows;
  if (run.program)
    rows.push_back({"Machine", formatted("%s, %zu blocks, %.1f min", run.program->machine.name.c_str(), run.program->blocks.size(),
                                         run.program->report.minutes)});
  if (run.motion)
    for (const auto& row : motionRows(*run.motion))
      rows.push_back(row);
  return rows;
}

void
addPassProgram(HtmlPage& page, const PassRun& run)
{
  if (!run.program)
    return;
  page.addHeading("Program");
  page.addTable(programRows(run), false);
}

void
addPassTimes(HtmlPage& page, const PassPlan& result)
{
  page.addHeading("Time");
  HtmlRows rows;
  for (const StageCost& stage : result.stages)
    rows.push_back({stage.name, formatted("%.2f s", stage.seconds)});
  page.addTable(rows, false);
}

} // namespace pcl_spiral
