// SPDX-License-Identifier: BSD-3-Clause
#include "verification_html.h"

#include "io/setting_names.h"
#include "mesh/mesh_findings.h"
#include "motion_report.h"
#include "moved_places.h"
#include "scene_html.h"
#include <pcl_spiral/io/report_writer.h>

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/surface/impl/side_text.h>

#include <algorithm>
#include <cctype>

namespace pcl_spiral {
namespace {

std::string
place(const Eigen::Vector3d& p)
{
  return formatted("%.3f, %.3f, %.3f mm", p.x(), p.y(), p.z());
}

/** Figures of a path at constant scallop height. */
HtmlRows
scallopRows(const SpiralReport& r)
{
  return {{"Loops", formatted("%zu: %zu in the spiral, %zu joined to it by bridges", r.scallop_loops, r.chain_loops, r.bridges)},
          {"Fingers", std::to_string(r.fingers)},
          {"Travelled against the requested sense", formatted("%.0f %%", 100.0 * r.reversed_share)},
          {"Passes", r.pass_begins.empty()
                         ? std::string("1")
                         : formatted("%zu, %.3f m of lifts between them", r.pass_begins.size() + 1, 0.001 * r.lift_length)},
          {"Radius of the sharpest turns", formatted("%.2f step-overs", r.turn_radius)}};
}

/** What the ball does not reach, the highest places first. */
HtmlRows
tightRows(const SpiralReport& r)
{
  constexpr std::size_t most = 12;
  HtmlRows rows;
  for (std::size_t i = 0; i < std::min(most, r.tight_places.size()); ++i) {
    const TightPlace& tight = r.tight_places[i];
    const std::string stays = formatted("%.4g mm stay, on %.4g mm\u00b2; ", tight.height, tight.area);
    rows.push_back(
        tight.under_cluster
            ? std::vector<std::string>{"Under a cluster of points", stays + "the ball rides over it; at " + place(tight.place)}
            : std::vector<std::string>{"Not reached by the ball",
                                       stays + formatted("a ball of radius %.4g mm reaches it; at ", tight.radius) + place(tight.place)});
  }
  if (r.tight_places.size() > most)
    rows.push_back({"Other places not reached", std::to_string(r.tight_places.size() - most)});
  if (r.lifted_length > 0.0)
    rows.push_back({"Path off the surface there", formatted("%.1f mm, by up to %.4g mm", r.lifted_length, r.largest_lift)});
  return rows;
}

void
addPath(HtmlPage& page, const SpiralReport& r, const SpiralSettings& s)
{
  page.addHeading("Toolpath");
  HtmlRows rows{{"Turns", std::to_string(r.turns)},
                {"Points", std::to_string(r.path_points)},
                {"Length", formatted("%.3f m", r.path_length / 1000.0)},
                {"Machining time at the feed", durationText(60.0 * r.path_length / s.feed) + formatted(" at %g mm/min", s.feed)},
                {"Method", choiceName(r.method)},
                {"Longest linear move", formatted("%.4g mm", r.largest_gap)},
                {"Largest change of the axis in one move", formatted("%.3g\u00b0", r.largest_axis_change)}};
  if (r.efficiency > 0.0)
    rows.push_back({"Efficiency: least possible length / path length", formatted("%.3f", r.efficiency)});
  if (!r.closest_place.isZero())
    rows.push_back({"Neighbouring turns are closest", formatted("%.4g mm apart, at ", r.smallest_step_over) + place(r.closest_place)});
  if (r.method == SpiralMethod::ConstantScallop)
    for (const auto& row : scallopRows(r))
      rows.push_back(row);
  else
    rows.insert(rows.end(), {{"Step-over", formatted("%.4g to %.4g mm", r.smallest_step_over, r.largest_step_over)},
                             {"Radial lines", formatted("%zu, %s", r.radial_lines.size(), r.harmonic_lines ? "harmonic" : "geodesic")}});
  if (r.gap_points > 0)
    rows.push_back({"Over gaps of the scan, bridged: estimated", formatted("%zu points, %.1f mm", r.gap_points, r.gap_length)});
  for (const auto& row : tightRows(r))
    rows.push_back(row);
  if (r.boundaries == 1 && r.method != SpiralMethod::ConstantScallop)
    rows.push_back({"Centre", place(r.centre)});
  if (r.deviating_points > 0)
    rows.push_back({formatted("Axis more than %g\u00b0 off the tilt asked for, to turn smoothly", s.axis_deviation),
                    formatted("%zu points, by up to %.3g\u00b0", r.deviating_points, r.largest_axis_deviation)});
  page.addTable(rows, false);
}

HtmlRows
meshRows(const RunMesh& mesh, const Vocabulary& words)
{
  const MeshReport& c = mesh.counts;
  HtmlRows rows{{"Mesh", formatted("%zu faces, %zu vertices, %zu boundaries", c.faces, c.vertices, c.loops)}};
  if (const Diagnostic found = findingsText(c); !found.empty())
    rows.push_back({"Found in it", found.text(words)});
  if (c.creases.count > 0)
    rows.push_back({"Creases", formatted("%.1f mm, %zu edges", c.crease_length, c.creases.count)});
  return rows;
}

void
addSurface(HtmlPage& page, const RunFiles& files, const std::optional<RunMesh>& mesh, const SpiralReport& r)
{
  page.addHeading(mesh ? "Surface" : "Scanned surface");
  HtmlRows rows = mesh ? meshRows(*mesh, files.words) : HtmlRows();
  rows.push_back({mesh ? "Samples of its curved surface" : "Points", formatted("%zu, %zu of them used", r.input_points, r.used_points)});
  const auto dropped = [&](std::size_t count, const char* why) {
    if (count > 0)
      rows.push_back({std::string("Left out: ") + why, std::to_string(count)});
  };
  dropped(r.nonfinite_points, "not finite");
  dropped(r.duplicate_points, "repeated");
  dropped(r.outlier_points, "outliers");
  dropped(r.surplus_points, "surplus along scan lines or beside sparser parts");
  dropped(r.left_out_points, "in other parts");
  rows.push_back({"Point spacing, median", formatted("%.4g mm", r.spacing)});
  rows.push_back({mesh ? "Samples off the local fits, standard deviation" : "Noise of a single point, standard deviation",
                  formatted("%.2g mm", r.noise)});
  rows.push_back({"Side of the cutter", sideText(r.side).text(files.words)});
  for (const BoundaryLoop& loop : r.loops) {
    const char* const name = loop.type == LoopType::Outer   ? "Outer rim"
                             : loop.type == LoopType::Inner ? "Inner loop"
                             : mesh                         ? "Narrow hole, bridged"
                                                            : "Gap in the scan, bridged";
    rows.push_back({name, formatted("%.1f mm long, %zu corners", loop.length, loop.corners.size())});
  }
  for (const HoleReport& hole : r.holes)
    rows.push_back({hole.handling == HoleHandling::Around ? "Hole, the path runs round it" : "Hole or gap, the path runs over it",
                    formatted("%.1f mm wide, at ", hole.width) + place(hole.place)});
  page.addTable(rows, false);
}

/** The value with its unit, or what it stands for. */
std::string
shown(const Setting& setting)
{
  const std::string value = textOf(setting);
  if (!setting.zero.empty() && (value.empty() || value == "0"))
    return setting.zero;
  return value.empty() ? "none" : setting.unit.empty() ? value : value + " " + setting.unit;
}

/** Whether another setting does not switch \p setting off. */
bool
isUsed(const Setting& setting, const SpiralSettings& settings)
{
  for (const char* of_lean : {"tilt", "lead", "max_axis_rate", "axis_smoothing", "axis_deviation"})
    if (settings.fixed_axis && setting.name == of_lean)
      return false;
  return setting.name != "outlier_deviations" || settings.outlier_neighbours > 0;
}

void
addSettings(HtmlPage& page, const RunFiles& files, SpiralSettings settings)
{
  page.addHeading("Settings");
  std::string outputs;
  for (const std::string& output : files.outputs)
    outputs += (outputs.empty() ? "" : ", ") + output;
  HtmlRows rows{{"Scan", files.scan},
                {"Unit of the scan", choiceName(files.unit)},
                {"Origin subtracted from the scan", files.origin.isZero() ? "none" : place(files.origin)},
                {"Shift of map coordinates", files.shift.isZero() ? "none"
                                                                  : place(files.shift) + " subtracted; added again in .csv .ply .vtp and "
                                                                                         "in this report, not in pictures, .pcd and "
                                                                                         "files for machines"},
                {"Written", outputs}};
  for (const Setting& setting : settingTable(settings)) {
    if (!isUsed(setting, settings))
      continue;
    std::string words = setting.words;
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    rows.push_back({words, shown(setting)});
  }
  page.addTable(rows, false);
}

/** Empty if it is not known. */
std::string
megabytesText(std::size_t bytes)
{
  return bytes > 0 ? formatted("%.0f MB", 1e-6 * static_cast<double>(bytes)) : "";
}

void
addTimes(HtmlPage& page, const SpiralReport& report, const Verification* verification)
{
  page.addHeading("Time and memory");
  HtmlRows rows{{"stage", "time", "memory at its end", "peak memory so far"}};
  double total = verification ? verification->seconds : 0.0;
  for (const StageCost& stage : report.stages) {
    rows.push_back(
        {stage.name, formatted("%.2f s", stage.seconds), megabytesText(stage.memory.resident), megabytesText(stage.memory.peak)});
    total += stage.seconds;
  }
  if (verification)
    for (const auto& row : judgingTimes(*verification))
      rows.push_back(row);
  rows.push_back({"all stages", formatted("%.2f s", total)});
  page.addTable(rows, true);
}

/** What judges a path of the page. */
VerificationRun
judgingOf(const RunFiles& files, const RunReport& report)
{
  const SpiralSettings& settings = report.settings;
  VerificationRun run{files.scan, files.unit, CutterShape::ball(settings.tool_radius), settings.scallop_height, settings.chord_error,
                      {},         {}};
  run.words = files.words;
  if (report.mesh)
    run.mesh.emplace();
  return run;
}

/** The path, or its regions if there are several. */
std::vector<const PathReport*>
judgedParts(const RunReport& run)
{
  std::vector<const PathReport*> parts;
  if (run.verification)
    parts.push_back(&run);
  for (const PathReport& region : run.regions)
    if (region.verification)
      parts.push_back(&region);
  return parts;
}

/** Warnings of reading, planning and judging, each once. */
Diagnostics
allWarnings(const RunFiles& files, const RunReport& run)
{
  Diagnostics warnings = files.warnings;
  warnings.insert(warnings.end(), run.report.warnings.begin(), run.report.warnings.end());
  for (const PathReport* part : judgedParts(run))
    for (const Diagnostic& warning : warningsOf(*part->verification))
      if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
        warnings.push_back(warning);
  return warnings;
}

/** What is looked at first. */
void
addVerdicts(HtmlPage& page, const RunFiles& files, const RunReport& run)
{
  const std::vector<const PathReport*> judged = judgedParts(run);
  for (const PathReport* part : judged)
    addVerdict(page, judgingOf(files, run), *part->verification, judged.size() > 1 ? part->name : std::string());
  if (judged.empty())
    page.addStatement(Tone::Neutral, "Not judged",
                      {formatted("pcl_spiral_verify checks deviation, scallop and gouge against the %s", run.mesh ? "mesh" : "scan")});
}

void
addPictures(HtmlPage& page, const RunReport& run)
{
  for (const ReportPicture& picture : run.judged)
    page.addPicture(picture);
  for (const PathReport& region : run.regions) {
    if (!region.judged.empty())
      page.addHeading(region.name);
    for (const ReportPicture& picture : region.judged)
      page.addPicture(picture);
  }
  if (!run.regions.empty() && !run.pictures.empty())
    page.addHeading("All regions");
  for (const ReportPicture& picture : run.pictures)
    page.addPicture(picture);
}

void
addRegion(HtmlPage& page, const RunFiles& files, const RunReport& run, const PathReport& region)
{
  page.addPart(region.name);
  if (region.verification)
    addFigures(page, judgingOf(files, run), *region.verification);
  addPath(page, region.report, run.settings);
  addSurface(page, files, run.mesh, region.report);
}

} // namespace

void
writeReportHTML(const std::string& file, const ReportPage& page, const RunFiles& of_run, const RunReport& given)
{
  RunFiles files = of_run;
  files.words = movedBy(files.shift, files.words);
  const RunReport run = movedBy(files.shift, given);
  const SpiralSettings& settings = run.settings;
  const SpiralReport& report = run.report;
  HtmlPage html(page.title, formatted("Spiral toolpath over a %s; ball cutter, radius %g mm, scallop %g mm",
                                      run.mesh ? "mesh" : "scanned surface", settings.tool_radius, settings.scallop_height));
  addVerdicts(html, files, run);
  addScene(run.scene.get(), html);
  addWarnings(html, textsOf(allWarnings(files, run), files.words));
  addPictures(html, run);
  for (const PathReport& region : run.regions)
    addRegion(html, files, run, region);
  html.addPart(run.regions.empty() ? "Path and surface" : "All regions");
  if (run.verification)
    addFigures(html, judgingOf(files, run), *run.verification);
  addPath(html, report, settings);
  if (run.motion) {
    html.addHeading("Program");
    html.addTable(motionRows(*run.motion), false);
  }
  if (run.regions.empty())
    addSurface(html, files, run.mesh, report);
  html.addPart("Run");
  addSettings(html, files, settings);
  addTimes(html, report, run.verification ? &*run.verification : nullptr);
  html.write(file, page);
}

} // namespace pcl_spiral
