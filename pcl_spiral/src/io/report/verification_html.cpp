// SPDX-License-Identifier: BSD-3-Clause
#include "verification_html.h"

#include "io/setting_names.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Row = std::vector<std::string>;

std::string
placeOf(const PlacedValue& v)
{
  return words("%.3f, %.3f, %.3f", v.position.x(), v.position.y(), v.position.z());
}

/** Rows of a table of figures: name, value, limit, place, path point. */
class Figures {
public:
  void add(const std::string& name, const std::string& value) { rows_.push_back({name, value, "", "", ""}); }
  void add(const std::string& name, const std::string& value, const PlacedValue& place, const std::string& limit = "")
  {
    rows_.push_back({name, value, limit, placeOf(place), std::to_string(place.index)});
  }
  const HtmlRows& rows() const { return rows_; }

private:
  HtmlRows rows_{{"Figure", "Value", "Limit", "At x, y, z (mm)", "Path point"}};
};

std::string
limitText(const std::optional<double>& limit, double value, const char* unit)
{
  return limit ? words("%.4g %s, %s", *limit, unit, value <= *limit ? "held" : "BROKEN") : std::string();
}

void
addDeviation(Figures& figures, const DeviationFigures& d, const Limits& limits)
{
  figures.add("Deviation of contacts from the surface, largest (+ out of the material)", words("%+.4f mm", d.max.value), d.max,
              limitText(limits.deviation, std::abs(d.max.value), "mm"));
  figures.add("Deviation, amount: 99 % below", words("%.4f mm", d.p99));
  figures.add("Deviation, rms", words("%.4f mm", d.rms));
  if (d.wobble.measured > 0) {
    figures.add("Wobble from turn to turn (deviation off the mean of the turns beside), rms", words("%.4f mm", d.wobble.rms));
    figures.add("Wobble from turn to turn, largest", words("%+.4f mm", d.wobble.max.value), d.wobble.max);
  }
  if (d.beyond_rim > 0)
    figures.add(words("Deviation beyond the outermost scan points, largest of %zu contacts", d.beyond_rim),
                words("%+.4f mm", d.rim_max.value), d.rim_max, limitText(limits.deviation, std::abs(d.rim_max.value), "mm"));
  if (d.in_gaps > 0)
    figures.add(words("Distance of %zu contacts in gaps of the scan from the surface carried on, largest", d.in_gaps),
                words("%+.4f mm", d.gap_max.value), d.gap_max);
  if (d.in_crease_band > 0)
    figures.add(words("Within %.3g mm of creases, where fits round them: %zu contacts, largest distance from the fit; no verdict",
                      d.crease_band, d.in_crease_band),
                words("%+.4f mm", d.crease_max.value), d.crease_max);
  if (d.unmeasured > 0)
    figures.add("Contacts off the surface, not measured", words("%zu of %zu", d.unmeasured, d.points));
  figures.add("Normal error, largest", words("%.3g\u00b0", d.normal_error.value), d.normal_error);
  figures.add("Normal error, 99 % below", words("%.3g\u00b0", d.normal_p99));
  if (d.opposed > 0)
    figures.add("Normals that point into the material, and the first", std::to_string(d.opposed), d.first_opposed);
  if (d.inward_axes > 0)
    figures.add("Tool axes that point into the material, and the first", std::to_string(d.inward_axes), d.first_inward);
}

void
addMaterial(Figures& figures, const RemovalFigures& r, const Limits& limits)
{
  if (r.scallop.samples > 0) {
    figures.add("Scallop: ridge between passes, median", words("%.4f mm", r.scallop.p50));
    figures.add("Scallop, 99 % below", words("%.4f mm", r.scallop.p99));
    figures.add("Scallop, 99.9 % below", words("%.4f mm", r.scallop.p999));
    figures.add(words("Ridges above 1.02 h + e = %.4g mm", r.limit), words("%.3g %%", 100.0 * r.scallop.share_above));
  }
  const PlacedValue& highest = highestScallop(r);
  figures.add(r.scallop.samples > 0 ? "Scallop, highest" : "Stock left, highest (no ridge was measured)", words("%.4f mm", highest.value),
              highest, limitText(limits.scallop, highest.value, "mm"));
  if (r.rim.samples > 0)
    figures.add("Stock within one step-over of the rim, highest", words("%.4f mm", r.rim.max.value), r.rim.max,
                limitText(limits.scallop, r.rim.max.value, "mm"));
  const std::string gouge_limit = limitText(limits.gouge, r.gouge.value, "mm");
  if (r.gouge.value > 0.0)
    figures.add("Gouge, deepest", words("%.4f mm", r.gouge.value), r.gouge, gouge_limit);
  else
    figures.add("Gouge", "none" + (gouge_limit.empty() ? "" : "; limit " + gouge_limit));
  if (r.rim_gouge.value > 0.0)
    figures.add("Gouge beyond the outermost scan points, deepest", words("%.4f mm", r.rim_gouge.value), r.rim_gouge,
                limitText(limits.gouge, r.rim_gouge.value, "mm"));
  if (r.crease.samples > 0) {
    figures.add(words("Stock within %.3g mm of creases, highest; no verdict", r.crease_band), words("%.4f mm", r.crease.max.value),
                r.crease.max);
    figures.add("Gouge there, deepest; no verdict", words("%.4f mm", r.crease_gouge.value), r.crease_gouge);
  }
  const double uncut = uncutPercent(r);
  const std::string uncut_limit = limitText(limits.uncut, uncut, "%");
  if (uncut > 0.0)
    figures.add("Uncut points, and the first", words("%.3g %%", uncut), firstUncut(r), uncut_limit);
  else
    figures.add("Uncut points", "0 %" + (uncut_limit.empty() ? "" : "; limit " + uncut_limit));
}

void
addMotion(Figures& figures, const PathMotion& m, const RemovalFigures& r)
{
  figures.add("Path length", words("%.3f m", m.length / 1000.0));
  if (m.lifts > 0)
    figures.add("Lifts between passes, no cuts", words("%zu, %.3f m", m.lifts, m.lift_length / 1000.0));
  figures.add("Least length of a path with this scallop", words("%.3f m", r.least_length / 1000.0));
  figures.add("Efficiency \u03b7: least length / path length", words("%.3f", r.efficiency));
  figures.add("Longest linear move (largest gap)", words("%.4g mm", m.gap.value), m.gap);
  figures.add("Largest turn per step", words("%.3g\u00b0", m.turn.value), m.turn);
  figures.add("Largest axis change per step", words("%.3g\u00b0", m.axis_change.value), m.axis_change);
}

void
addStatement(HtmlPage& page, const VerificationRun& run, const Verification& v)
{
  const Limits& limits = run.limits;
  const RemovalFigures& r = v.removal;
  Row grounds = v.broken;
  grounds.insert(grounds.end(), v.unproven.begin(), v.unproven.end());
  grounds.push_back(words("largest deviation %+.4f mm; scallop 99.9 %% below %.4f mm, highest %.4f mm; gouge %.4f mm; "
                          "uncut %.3g %%; efficiency %.3f",
                          v.deviation.max.value, r.scallop.p999, highestScallop(r).value, r.gouge.value, uncutPercent(r), r.efficiency));
  if (!v.broken.empty())
    page.addStatement(Tone::Bad, "Limits are broken", grounds);
  else if (!v.unproven.empty())
    page.addStatement(Tone::Doubtful,
                      run.mesh ? "No limit is seen broken, but these samples cannot show that all hold"
                               : "No limit is seen broken, but this scan cannot show that all hold",
                      grounds);
  else if (limits.any())
    page.addStatement(Tone::Good, "All stated limits hold", grounds);
  else
    page.addStatement(Tone::Neutral, run.mesh ? "Judged by the mesh; no limits were stated" : "Judged by the scan; no limits were stated",
                      grounds);
}

/** Whether a value that was asked for can be told from the noise of the surface that it is measured against.
 */
Row
shownRow(const char* name, const std::optional<double>& value, const DeviationFigures& d)
{
  if (!value || !(*value > 0.0))
    return {};
  const double least = 3.0 * d.fit_noise;
  return {words("%s %.4g mm", name, *value),
          *value >= least ? (d.by_mesh ? "shown" : "shown by this scan")
          : d.by_mesh     ? words("NOT shown: below %.2g mm, three times what the fit is off the mesh by; sample more closely", least)
                          : words("NOT shown by this scan: below %.2g mm, three times its surface's noise", least)};
}

void
addNoise(HtmlPage& page, const VerificationRun& run, const DeviationFigures& d)
{
  page.addHeading(d.by_mesh ? "What the samples of the mesh can show" : "What the scan can show");
  HtmlRows rows{{d.by_mesh ? "Samples judged by" : "Scan points judged by", std::to_string(d.reference_points)}};
  if (!d.by_mesh)
    rows.push_back({"Noise of a single point, standard deviation", words("%.2g mm", d.noise)});
  rows.push_back({d.by_mesh ? "Distance of the mesh from the surface fitted to them, rms" : "Noise of the surface fitted to the points",
                  words("%.2g mm", d.fit_noise)});
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
  const MeshCounts& counts = mesh.counts;
  rows.push_back({"Faces judged", words("%zu of %zu%s", mesh.judged_faces, counts.faces, counts.closed ? ", closed" : "")});
  rows.push_back({"Rims", std::to_string(counts.loops)});
  rows.push_back({words("Creases, edges bent by more than %g\u00b0", mesh.settings.crease_angle),
                  words("%zu edges, %.1f mm", counts.creases.count, counts.crease_length)});
  rows.push_back({"Samples of the curved surface", words("every %.3g mm", mesh.sample_spacing)});
}

} // namespace

void
addVerification(HtmlPage& page, const VerificationRun& run, const Verification& verification, const std::vector<ReportPicture>& pictures)
{
  addStatement(page, run, verification);
  page.addHeading("Figures");
  Figures figures;
  addDeviation(figures, verification.deviation, run.limits);
  addMaterial(figures, verification.removal, run.limits);
  addMotion(figures, verification.deviation.motion, verification.removal);
  page.addTable(figures.rows(), true);
  addNoise(page, run, verification.deviation);
  for (const ReportPicture& picture : pictures)
    page.addPicture(picture);
}

HtmlRows
judgingTimes(const Verification& v)
{
  const double rest = std::max(0.0, v.seconds - v.deviation.seconds - v.removal.seconds);
  return {{v.deviation.by_mesh ? "judging: samples of the mesh and their surface" : "judging: surface of the scan", words("%.2f s", rest)},
          {"judging: deviation", words("%.2f s", v.deviation.seconds)},
          {"judging: removed material", words("%.2f s", v.removal.seconds)}};
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
writeVerificationHTML(const std::string& file, const ReportPage& page, const VerificationRun& run,
                      const std::vector<Verification>& verifications, const std::vector<std::vector<ReportPicture>>& pictures)
{
  HtmlPage html(page.title, words("Toolpath judged by a %s; ball cutter, radius %g mm", run.mesh ? "mesh" : "scan", run.tool_radius));
  for (std::size_t i = 0; i < verifications.size(); ++i) {
    const Verification& v = verifications[i];
    if (verifications.size() > 1)
      html.addPart(v.path);
    addVerification(html, run, v, i < pictures.size() ? pictures[i] : std::vector<ReportPicture>());
    addWarnings(html, warningsOf(v));
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
    rows.push_back({"Path", words("%zu points, ", v.deviation.points) + v.path});
  rows.push_back({"Ball cutter, radius R", words("%g mm", run.tool_radius)});
  rows.push_back({"Scallop height asked for, h", words("%g mm", run.scallop_height)});
  rows.push_back({"Chord error asked for, e", words("%g mm", run.chord_error)});
  html.addTable(rows, false);
  if (!run.warnings.empty()) {
    html.addHeading("Warnings from reading the " + part);
    html.addList(run.warnings);
  }
  if (!page.command.empty()) {
    html.addHeading("Made by");
    html.addCode(page.command);
  }
  html.write(file, page.made);
}

} // namespace pcl_spiral
