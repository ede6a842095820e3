// SPDX-License-Identifier: BSD-3-Clause
#include "html_page.h"
#include "moved_places.h"
#include "pass_html.h"
#include "scene_html.h"
#include "verification_html.h"

#include <pcl_spiral/io/pass_report_writer.h>

#include <stdexcept>

namespace pcl_spiral {
namespace {

std::string
toolText(const PassRun& run)
{
  return run.tool.cutter.radius > 0.0 ? "cutter of " + cutterText(run.tool.cutter) : std::string("a beam");
}

HtmlRows
rowRows(const RidgePlanReport& figures, const PassPlan& plan)
{
  const RidgeReport& r = figures.ridge->report();
  HtmlRows rows{
      {"Rows", formatted("%zu, at most %.4g mm apart, %zu points", figures.rows.rows, figures.rows.largest_step, figures.rows.points)},
      {"Length of the tip's path", formatted("%.3f m", plan.length / 1000.0)},
      {"Rail", formatted("%zu points, %.1f mm%s", r.rail_points, r.rail_length, r.closed ? ", a ring" : "")},
      {"Generator", formatted("%zu points, %.2f mm", r.generator_points, r.generator_length)},
      {"Angle that its chord keeps", formatted("%.2f\u00b0", r.chord_angle)},
      {"Largest slope of the rail", formatted("%.1f\u00b0", r.largest_slope)}};
  if (figures.found)
    rows.push_back({"Points of the scan off the ridge",
                    formatted("%.3g mm rms, %.3g mm at most", figures.found->misfit, figures.found->largest_misfit)});
  return rows;
}

} // namespace

void
writeRidgeReportHTML(const std::string& file, const ReportPage& page, const RunFiles& files, const RidgeRun& run, const PassPlan& plan,
                     const RidgePlanReport& figures, const std::vector<ReportPicture>& pictures)
{
  if (!figures.ridge)
    throw std::invalid_argument("writeRidgeReportHTML: the plan has no ridge; it is one of a planner that succeeded");
  HtmlPage html(page.title, "Rows over a ridge; " + toolText(run));
  addPassVerdict(html, plan);
  addScene(run.scene.get(), html);
  addWarnings(html, passWarnings(files, plan));
  for (const ReportPicture& picture : pictures)
    html.addPicture(picture);
  html.addPart("Rows");
  html.addTable(rowRows(figures, plan), false);
  addPassProgram(html, run);
  html.addPart("Run");
  addPassTimes(html, plan);
  html.write(file, page);
}

} // namespace pcl_spiral
