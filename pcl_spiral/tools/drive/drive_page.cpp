// SPDX-License-Identifier: BSD-3-Clause
#include "drive_page.h"
#include "job_check.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"
#include "terminal/vocabulary.h"

#include "io/report/cutter_text.h"
#include "io/report/html_page.h"
#include "io/report/verification_html.h"
#include "io/setting_names.h"
#include "mesh/mesh_findings.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/surface/impl/side_text.h>

using namespace pcl_spiral;

namespace {

void
addPath(HtmlPage& page, const Job& job, const Result& result)
{
  const DriveReport& d = result.drive;
  const LocationFigures& f = result.locations;
  page.addHeading("Toolpath");
  HtmlRows rows{{"Drive path", choiceName(job.drive.kind)},
                {"Passes", std::to_string(result.passes.size())},
                {"Length of the tip's path", formatted("%.3f m", result.length / 1000.0)},
                {"Machining time at the feed", formatted("%.1f min at %g mm/min", result.length / job.feed, job.feed)},
                {"Locations", formatted("%zu, %zu of them added between others", result.poseCount(), result.bisection.inserted)},
                {"Largest error of a move", formatted("%.3g mm", result.bisection.largest_error)}};
  for (const PlannedRegion& region : result.regions)
    rows.push_back({region.name, formatted("%zu passes, %zu locations", region.passes, region.locations)});
  if (job.drive.kind == DriveKind::Planes)
    rows.push_back({"Rows", formatted("%zu, %.4g to %.4g mm apart", d.rows, d.smallest_step, d.step_over)});
  else if (job.drive.kind != DriveKind::Curve)
    rows.push_back({"Step-over", formatted("%.4g mm", d.step_over)});
  for (std::size_t i = 0; i < location_states; ++i)
    if (f.states[i] > 0)
      rows.push_back({formatted("Locations: %s", nameOf(static_cast<LocationState>(i))), std::to_string(f.states[i])});
  if (const LeftOutLocations& left = result.left_out; left.count() > 0)
    rows.push_back({"Locations left out because of keep-outs and the scan beside the part", std::to_string(left.count())});
  if (f.collisions > 0)
    rows.push_back({"Collisions of shank or holder", formatted("%zu, up to %.4g mm deep", f.collisions, f.deepest_collision)});
  if (result.program)
    rows.push_back({"Machine", formatted("%s, %zu blocks, %.1f min", result.program->machine.name.c_str(), result.program->blocks.size(),
                                         result.program->report.minutes)});
  page.addTable(rows, false);
}

void
addPart(HtmlPage& page, const Result& result)
{
  page.addHeading(result.mesh ? "Mesh" : "Scanned surface");
  HtmlRows rows;
  if (result.mesh) {
    rows.push_back({"Faces, vertices", formatted("%zu, %zu", result.mesh->faceCount(), result.mesh->vertexCount())});
    if (const Diagnostic found = findingsText(result.mesh->counts()); !found.empty())
      rows.push_back({"Found in it", inWords(found)});
  }
  else {
    rows.push_back({"Points", std::to_string(result.cloud->size())});
    rows.push_back({"Side of the cutter", inWords(sideText(result.side))});
  }
  if (const auto& column = result.drive.column)
    rows.push_back({"Column", formatted("radius %.4g to %.4g mm, covered over %.0f\u00b0", column->least_radius, column->largest_radius,
                                        column->covered_angle)});
  page.addTable(rows, false);
}

void
addSettings(HtmlPage& page, const Job& job)
{
  page.addHeading("Settings");
  std::string outputs;
  for (const std::string& output : filesOf(job))
    outputs += (outputs.empty() ? "" : ", ") + output;
  HtmlRows rows{{"Part", job.scan}, {"Written", outputs}, {"Cutter", cutterText(job.cutter)}};
  if (!scanShift().isZero())
    rows.push_back({"Shift of map coordinates", shiftText()});
  if (job.drive.scallop_height > 0.0)
    rows.push_back({"Scallop height h", formatted("%g mm", job.drive.scallop_height)});
  rows.insert(rows.end(), {{"Rows", choiceName(job.drive.rows)},
                           {"Spacing of drive points", formatted("%g mm", job.drive.point_spacing)},
                           {"Tool axes", choiceName(job.drive.axisMode())},
                           {"Tolerance of moves", formatted("%g mm", job.tolerance)}});
  page.addTable(rows, false);
}

void
addTimes(HtmlPage& page, const Result& result)
{
  page.addHeading("Time");
  HtmlRows rows;
  for (const StageCost& stage : result.stages)
    rows.push_back({stage.name, formatted("%.2f s", stage.seconds)});
  page.addTable(rows, false);
}

} // namespace

void
writeDrivePage(const std::string& file, const std::string& title, const Job& job, const Result& result,
               const std::vector<ReportPicture>& pictures)
{
  HtmlPage page(title,
                Diagnostic("Passes over a ", result.mesh ? "mesh" : "scanned surface", "; cutter of ", cutterText(job.cutter)).text());
  page.addPart("Path and surface");
  for (const ReportPicture& picture : pictures)
    page.addPicture(picture);
  addPath(page, job, result);
  addPart(page, result);
  page.addPart("Run");
  addWarnings(page, textsOf(result.warnings, programWords()));
  addSettings(page, job);
  addTimes(page, result);
  page.addHeading("Made by");
  page.addCode(job.command);
  page.write(file, madeBy("pcl_spiral_drive"));
}
