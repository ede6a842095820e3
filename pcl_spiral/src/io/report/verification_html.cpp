// SPDX-License-Identifier: BSD-3-Clause
#include "verification_html.h"

#include "io/cutter_text.h"
#include "io/setting_names.h"
#include "motion_report.h"
#include "moved_places.h"
#include "scene_html.h"
#include "verify/figure_text.h"
#include "verify/limit_verdicts.h"
#include "verify/verification_figures.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

using Row = std::vector<std::string>;

const FigureWriting on_page{true, "\u00b0"};

/** The figures of the page from top to bottom. */
constexpr const char* shown_figures[] = {"deviation/max",
                                         "deviation/p99",
                                         "deviation/rms",
                                         "deviation/turn_wobble_rms",
                                         "deviation/turn_wobble_max",
                                         "deviation/beyond_rim_max",
                                         "deviation/gap_max",
                                         "deviation/crease_max",
                                         "deviation/lift_max",
                                         "deviation/unmeasured",
                                         "deviation/normal_max",
                                         "deviation/normal_p99",
                                         "deviation/opposed_normals",
                                         "deviation/inward_axes",
                                         "material/scallop/p50",
                                         "material/scallop/p99",
                                         "material/scallop/p99.9",
                                         "material/scallop/share_above_limit",
                                         "material/highest",
                                         "material/rim_band/max",
                                         "material/gouge",
                                         "material/rim_gouge",
                                         "material/face_gouge",
                                         "material/face_depth",
                                         "material/crease_band/max",
                                         "material/crease_gouge",
                                         "material/unreached/max",
                                         "material/uncut",
                                         "motion/length",
                                         "motion/lifts",
                                         "material/least_length",
                                         "material/efficiency",
                                         "motion/largest_gap",
                                         "motion/largest_turn",
                                         "motion/largest_axis_change",
                                         "program/blocks",
                                         "program/passes",
                                         "program/other_moves",
                                         "program/colliding_moves"};

std::string
limitText(const Figure& figure)
{
  if (!figure.limit)
    return "";
  const FigureLimit& limit = *figure.limit;
  return formatted("%.4g%s, %s", limit.most, unitSuffix(figure, on_page).c_str(), limit.holds() ? "held" : "BROKEN");
}

/** Name, value, limit, place, and path point or line of a figure. Without a place the limit follows the value. */
Row
figureRow(const Figure& figure, const FigureTable& table)
{
  const std::string limit = limitText(figure);
  const std::string name = filled(figure.name, table, on_page);
  const std::string reading = figure.reading.empty() ? "{" + figure.key + "}" : figure.reading;
  const std::string value = figure.known ? filled(reading, table, on_page) : figure.if_none;
  if (!figure.known || !figure.place)
    return {name, limit.empty() ? value : value + "; limit " + limit, "", "", ""};
  const Eigen::Vector3d& at = figure.place->position;
  return {figure.kind == FigureKind::Placed ? name : name + ", and the first", value, limit,
          formatted("%.3f, %.3f, %.3f", at.x(), at.y(), at.z()), std::to_string(figure.place->index)};
}

HtmlRows
figureRows(const FigureTable& table, bool by_line)
{
  HtmlRows rows{{"Figure", "Value", "Limit", "At x, y, z (mm)", by_line ? "Line" : "Path point"}};
  for (const char* key : shown_figures)
    if (const Figure& figure = table.at(key); figure.known || !figure.if_none.empty())
      rows.push_back(figureRow(figure, table));
  return rows;
}

/** Whether the limits hold, in words. */
std::string
verdictText(const VerificationRun& run, Verdict verdict)
{
  switch (verdict) {
  case Verdict::Broken:
    return "Limits are broken";
  case Verdict::Unproven:
    return run.mesh ? "No limit was found broken, but these samples cannot show that all limits are kept"
                    : "No limit was found broken, but this scan cannot show that all limits are kept";
  case Verdict::Kept:
    return "All stated limits hold";
  case Verdict::NoLimits:
    break;
  }
  return run.mesh ? "Judged by the mesh; no limits were stated" : "Judged by the scan; no limits were stated";
}

Tone
toneOf(Verdict verdict)
{
  return verdict == Verdict::Broken     ? Tone::Bad
         : verdict == Verdict::Unproven ? Tone::Unproven
         : verdict == Verdict::Kept     ? Tone::Good
                                        : Tone::Neutral;
}

/** Whether the surface that a value is measured against is known well enough to show that value. */
Row
shownRow(const char* name, const std::optional<double>& value, const DeviationReport& d)
{
  if (!value || !(*value > 0.0))
    return {};
  const double least = leastShown(d);
  return {formatted("%s %.4g mm", name, *value),
          *value >= least ? (d.by_mesh ? "shown" : "shown by this scan")
          : d.by_mesh     ? formatted("NOT shown: below %.2g mm, three times the distance between the mesh and the surface fitted to its "
                                          "samples; sample more closely",
                                      least)
                          : formatted("NOT shown by this scan: below %.2g mm, three times its surface's noise", least)};
}

void
addNoise(HtmlPage& page, const VerificationRun& run, const DeviationReport& d)
{
  page.addHeading(d.by_mesh ? "What the samples of the mesh can show" : "What the scan can show");
  HtmlRows rows{{d.by_mesh ? "Samples judged by" : "Scan points judged by", std::to_string(d.reference_points)}};
  if (!d.by_mesh)
    rows.push_back({"Noise of a single point, standard deviation", formatted("%.2g mm", d.noise)});
  rows.push_back({d.by_mesh ? "Distance of the mesh from the surface fitted to them, rms" : "Noise of the surface fitted to the points",
                  formatted("%.2g mm", d.fit_noise)});
  for (const Row& row : {shownRow("Scallop asked for, h", run.scallop_height, d), shownRow("Chord error asked for, e", run.chord_error, d),
                         shownRow("Limit on the deviation", run.limits.deviation, d),
                         shownRow("Limit on the scallop", run.limits.scallop, d), shownRow("Limit on the gouge", run.limits.gouge, d)})
    if (!row.empty())
      rows.push_back(row);
  page.addTable(rows, false);
}

void
addMesh(HtmlRows& rows, const JudgedMesh& mesh)
{
  const MeshReport& counts = mesh.counts;
  rows.push_back({"Faces judged", formatted("%zu of %zu%s", mesh.judged_faces, counts.faces, counts.closed ? ", closed" : "")});
  rows.push_back({"Rims", std::to_string(counts.loops)});
  rows.push_back({formatted("Creases, edges bent by more than %g\u00b0", mesh.settings.crease_angle),
                  formatted("%zu edges, %.1f mm", counts.creases.count, counts.crease_length)});
  rows.push_back({"Samples of the curved surface", formatted("every %.3g mm", mesh.sample_spacing)});
}

} // namespace

void
addVerdict(HtmlPage& page, const VerificationRun& run, const Verification& v, const std::string& name)
{
  Row grounds = textsOf(v.broken, run.words);
  for (const std::string& unproven : textsOf(v.unproven, run.words))
    grounds.push_back(unproven);
  grounds.push_back(filled("largest deviation {deviation/max}; scallop 99.9 % below {material/scallop/p99.9}, highest {material/highest}; "
                           "gouge {material/gouge}; uncut {material/uncut}; efficiency {material/efficiency}",
                           figuresOf(v, run.limits), on_page));
  const Verdict verdict = verdictOf(run.limits, v);
  page.addStatement(toneOf(verdict), (name.empty() ? name : name + ": ") + verdictText(run, verdict), grounds);
}

void
addFigures(HtmlPage& page, const VerificationRun& run, const Verification& verification)
{
  page.addHeading("Figures");
  page.addTable(figureRows(figuresOf(verification, run.limits), verification.program.has_value()), true);
  if (verification.program && verification.program->motion)
    page.addTable(motionRows(*verification.program->motion), false);
  addNoise(page, run, verification.deviation);
}

HtmlRows
judgingTimes(const Verification& v)
{
  const double rest = std::max(0.0, v.seconds - v.deviation.seconds - v.removal.seconds);
  return {
      {v.deviation.by_mesh ? "judging: samples of the mesh and their surface" : "judging: surface of the scan", formatted("%.2f s", rest)},
      {"judging: deviation", formatted("%.2f s", v.deviation.seconds)},
      {"judging: removed material", formatted("%.2f s", v.removal.seconds)}};
}

void
addWarnings(HtmlPage& page, const std::vector<std::string>& warnings)
{
  page.addHeading("Warnings");
  if (warnings.empty())
    page.addText("None.");
  page.addList(warnings);
}

void
writeVerificationHTML(const std::string& file, const ReportPage& page, const VerificationRun& asked,
                      const std::vector<Verification>& verifications, const std::vector<std::vector<ReportPicture>>& pictures)
{
  VerificationRun run = asked;
  run.words = movedBy(run.shift, run.words);
  HtmlPage html(page.title, std::string("Toolpath judged by a ") + (run.mesh ? "mesh" : "scan") + "; cutter of " + cutterText(run.cutter));
  std::vector<Verification> moved;
  for (const Verification& v : verifications)
    moved.push_back(movedBy(run.shift, v));
  const bool several = moved.size() > 1;
  for (const Verification& v : moved)
    addVerdict(html, run, v, several ? nameOf(v) : std::string());
  addScene(asked.scene.get(), html);
  for (std::size_t i = 0; i < moved.size() && i < pictures.size(); ++i) {
    if (several)
      html.addHeading(nameOf(moved[i]));
    for (const ReportPicture& picture : pictures[i])
      html.addPicture(picture);
  }
  for (const Verification& v : moved) {
    if (several)
      html.addPart(nameOf(v));
    addWarnings(html, textsOf(warningsOf(v), run.words));
    addFigures(html, run, v);
    html.addHeading("Time");
    html.addTable(judgingTimes(v), false);
  }
  if (verifications.size() > 1)
    html.addPart("Input");
  html.addHeading("Settings");
  const std::string part = run.mesh ? "mesh" : "scan";
  HtmlRows rows{{run.mesh ? "Mesh" : "Scan", run.scan}, {"Unit of the " + part, choiceName(run.unit)}};
  if (run.mesh)
    addMesh(rows, *run.mesh);
  for (const Verification& v : verifications)
    rows.push_back({"Path", formatted("%zu points, ", v.deviation.points) + nameOf(v)});
  rows.push_back({"Cutter", cutterText(run.cutter)});
  rows.push_back({"Scallop height asked for, h", formatted("%g mm", run.scallop_height)});
  rows.push_back({"Chord error asked for, e", formatted("%g mm", run.chord_error)});
  html.addTable(rows, false);
  if (!run.warnings.empty()) {
    html.addHeading("Warnings from reading the " + part);
    html.addList(textsOf(run.warnings, run.words));
  }
  html.write(file, page);
}

} // namespace pcl_spiral
