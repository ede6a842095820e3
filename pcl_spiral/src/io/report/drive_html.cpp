// SPDX-License-Identifier: BSD-3-Clause
#include "html_page.h"
#include "moved_places.h"
#include "pass_html.h"
#include "scene_html.h"
#include "verification_html.h"

#include "io/setting_names.h"
#include "mesh/mesh_findings.h"
#include <pcl_spiral/io/pass_report_writer.h>
#include <pcl_spiral/surface/impl/side_text.h>

#include <stdexcept>

namespace pcl_spiral {
namespace {

void
addPath(HtmlPage& page, const DriveRun& run, const PassPlan& result)
{
  const DriveReport& d = result.drive;
  const LocationReport& f = result.locations;
  page.addHeading("Toolpath");
  HtmlRows rows{{"Drive path", choiceName(run.drive.kind)},
                {"Passes", std::to_string(result.passes.size())},
                {"Length of the tip's path", formatted("%.3f m", result.length / 1000.0)},
                {"Machining time at the feed", formatted("%.1f min at %g mm/min", result.length / run.feed, run.feed)},
                {"Locations", formatted("%zu, %zu of them added between others", result.poseCount(), result.bisection.inserted)},
                {"Largest error of a move", formatted("%.3g mm", result.bisection.largest_error)}};
  for (const PlannedRegion& region : result.regions)
    rows.push_back({region.name, formatted("%zu passes, %zu locations", region.passes, region.locations)});
  if (run.drive.kind == DriveKind::Planes)
    rows.push_back({"Rows", formatted("%zu, %.4g to %.4g mm apart", d.rows, d.smallest_step, d.step_over)});
  else if (run.drive.kind != DriveKind::Curve)
    rows.push_back({"Step-over", formatted("%.4g mm", d.step_over)});
  for (std::size_t i = 0; i < location_states; ++i)
    if (f.states[i] > 0)
      rows.push_back({formatted("Locations: %s", nameOf(static_cast<LocationState>(i))), std::to_string(f.states[i])});
  if (const LeftOutLocations& left = result.left_out; left.count() > 0)
    rows.push_back({"Locations left out because of keep-outs and the scan beside the part", std::to_string(left.count())});
  if (f.collisions > 0)
    rows.push_back({"Collisions of shank or holder", formatted("%zu, up to %.4g mm deep", f.collisions, f.deepest_collision)});
  for (const auto& row : programRows(run))
    rows.push_back(row);
  page.addTable(rows, false);
}

void
addPart(HtmlPage& page, const Vocabulary& words, const PassPlan& result)
{
  page.addHeading(result.mesh ? "Mesh" : "Scanned surface");
  HtmlRows rows;
  if (result.mesh) {
    rows.push_back({"Faces, vertices", formatted("%zu, %zu", result.mesh->faceCount(), result.mesh->vertexCount())});
    if (const Diagnostic found = findingsText(result.mesh->report()); !found.empty())
      rows.push_back({"Found in it", found.text(words)});
  }
  else {
    rows.push_back({"Points", std::to_string(result.cloud->size())});
    rows.push_back({"Side of the cutter", sideText(result.side).text(words)});
  }
  if (const auto& column = result.drive.column)
    rows.push_back({"Column", formatted("radius %.4g to %.4g mm, covered over %.0f\u00b0", column->least_radius, column->largest_radius,
                                        column->covered_angle)});
  page.addTable(rows, false);
}

void
addSettings(HtmlPage& page, const RunFiles& files, const DriveRun& run)
{
  page.addHeading("Settings");
  std::string outputs;
  for (const std::string& output : files.outputs)
    outputs += (outputs.empty() ? "" : ", ") + output;
  HtmlRows rows{{"Part", files.scan}, {"Written", outputs}, {"Cutter", cutterText(run.tool.cutter)}};
  if (const Eigen::Vector3d& s = files.shift; !s.isZero())
    rows.push_back({"Shift of map coordinates", formatted("%.0f, %.0f, %.0f mm", s.x(), s.y(), s.z())});
  if (run.drive.scallop_height > 0.0)
    rows.push_back({"Scallop height h", formatted("%g mm", run.drive.scallop_height)});
  rows.insert(rows.end(), {{"Rows", choiceName(run.drive.rows)},
                           {"Spacing of drive points", formatted("%g mm", run.drive.point_spacing)},
                           {"Tool axes", choiceName(run.drive.axisMode())},
                           {"Tolerance of moves", formatted("%g mm", run.tool.tolerance)}});
  page.addTable(rows, false);
}

} // namespace

void
writeDriveReportHTML(const std::string& file, const ReportPage& page, const RunFiles& files, const DriveRun& run, const PassPlan& plan,
                     const std::vector<ReportPicture>& pictures)
{
  if (!plan.mesh && !plan.cloud)
    throw std::invalid_argument("writeDriveReportHTML: the plan is empty; it is one of a planner that succeeded");
  const Vocabulary words = movedBy(files.shift, files.words);
  HtmlPage html(page.title,
                Diagnostic("Passes over a ", plan.mesh ? "mesh" : "scanned surface", "; cutter of ", cutterText(run.tool.cutter)).text());
  addPassVerdict(html, plan);
  addScene(run.scene.get(), html);
  addWarnings(html, passWarnings(files, plan));
  for (const ReportPicture& picture : pictures)
    html.addPicture(picture);
  html.addPart("Path and surface");
  addPath(html, run, plan);
  addPart(html, words, plan);
  html.addPart("Run");
  addSettings(html, files, run);
  addPassTimes(html, plan);
  html.write(file, page);
}

} // namespace pcl_spiral
