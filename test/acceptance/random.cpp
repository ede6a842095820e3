// SPDX-License-Identifier: BSD-3-Clause
#include "case_series.h"
#include "method_name.h"

#include "support/path_checks.h"
#include "support/removed_material.h"

#include <pcl_spiral/verify/deviation_estimation.h>
#include <pcl_spiral/verify/material_removal.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl_spiral::acceptance {

namespace {

constexpr unsigned int longest_run = 30; ///< s

/** Collects broken limits. */
class Faults {
public:
  void atMost(const char* what, double value, double limit)
  {
    if (!(value <= limit))
      text_ << what << ' ' << value << " above " << limit << "; ";
  }
  std::string text() const { return text_.str(); }

private:
  std::ostringstream text_;
};

/** The path, moved to the exact surface. */
test::CheckedPath
movedBack(const RandomCase& made, const Path& path)
{
  test::CheckedPath back = test::fromToolpath(path);
  const Eigen::Isometry3d inverse = made.motion.inverse();
  for (Eigen::Vector3d& contact : back.contacts)
    contact = inverse * contact;
  for (Eigen::Vector3d& normal : back.normals)
    normal = inverse.linear() * normal;
  return back;
}

/** The points that are not marked as over a gap of the scan, where the surface is estimated. */
test::CheckedPath
offGaps(const Path& path, const test::CheckedPath& all)
{
  test::CheckedPath known = all;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < path.size(); ++i)
    if (path[i].over_gap == 0) {
      known.contacts[kept] = all.contacts[i];
      known.normals[kept] = all.normals[i];
      ++kept;
    }
  known.contacts.resize(kept);
  known.normals.resize(kept);
  known.turns.clear();
  return known;
}

void
checkPoints(const Path& path, Faults& faults)
{
  std::size_t bad = 0, back = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const ToolpathPoint& p = path[i];
    const bool numbers = p.getVector3fMap().allFinite() && std::isfinite(p.arc_length) && std::isfinite(p.turn);
    const auto unit = [](const auto& v) { return std::abs(v.norm() - 1.0f) < 1e-5f; };
    bad += numbers && unit(p.getNormalVector3fMap()) && unit(p.getAxisVector3fMap()) ? 0 : 1;
    back += i == 0 || (p.arc_length >= path[i - 1].arc_length && p.turn >= path[i - 1].turn) ? 0 : 1;
  }
  faults.atMost("points that are no numbers or no units", static_cast<double>(bad), 0.0);
  faults.atMost("steps back", static_cast<double>(back), 0.0);
}

/** Whether the points tell the surface well enough for the limits of the job to be kept, and not only aimed at: corners of
 *  the outline are known to one and a half spacings, which must lie within the step-over that is left out at the rim. */
bool
isToldWell(const RandomCase& made)
{
  const SpiralSettings& s = made.settings;
  if (1.5 * made.spacing > std::sqrt(8.0 * s.tool_radius * s.scallop_height))
    return false;
  const double sag = made.spacing * made.spacing * made.bend / 8.0;
  return made.noise == 0.0 && made.outliers == 0 && made.even && sag < 0.3 * s.chord_error && made.spacing * made.bend < 0.1 &&
         s.tool_radius * made.concave < 0.5;
}

/** The ridges that the settings allow and those foretold at corners, as radial turns leave them: turns seem there at most twice as far
 *  apart. */
double
highestRidge(const SpiralSettings& s, const SpiralReport& report)
{
  constexpr double most = 4.2; // times the height of turns half as far apart
  return 1.05 * std::max(s.scallop_height, std::min(report.corner_ridge, most * s.scallop_height));
}

void
checkAgainstSurface(const RandomCase& made, const Path& path, const SpiralReport& report, Faults& faults)
{
  const SpiralSettings& s = made.settings;
  const test::CheckedPath back = movedBack(made, path);
  const test::ToolpathReport f = test::checkPath(*made.surface, back, made.spacing, 1);
  const test::ToolpathReport known = test::checkPath(*made.surface, offGaps(path, back), made.spacing, 1);
  const double rounding = 1e-6 * made.cloud->size() + 1e-5 * made.surface->region().upper().norm();
  const double sag = made.spacing * made.spacing * made.bend;
  faults.atMost("step", f.gap.value, report.largest_allowed_step * 1.001 + rounding);
  const double crossing = std::max(0.05 * made.spacing, s.chord_error); // chords may lie so far off the curve
  faults.atMost("crossings", static_cast<double>(test::crossings(*made.surface, back, crossing, 1).size()), 0.0);
  faults.atMost("deviation rms", known.deviation_rms, 0.6 * made.noise + 0.1 * sag + rounding);
  faults.atMost("deviation", std::abs(known.deviation.value), 2.5 * made.noise + 0.5 * sag + rounding);
  faults.atMost("normal error, degrees", f.normal_error.value, 45.0);
  if (!isToldWell(made))
    return;
  test::RemovalSettings settings;
  settings.tool_radius = s.tool_radius;
  settings.scallop_height = s.scallop_height;
  settings.samples = 1500;
  settings.threads = 1;
  const test::RemovalReport left = test::removedMaterial(*made.surface, back, settings);
  faults.atMost("gouge", left.gouge.value, 1.2 * s.chord_error + sag + rounding);
  if (report.corner_ridge == s.tool_radius) // left uncut, as foretold
    return;
  faults.atMost("scallop p99.9", left.ridge.p999, highestRidge(s, report) + s.chord_error + rounding);
  faults.atMost("uncut share", left.ridge.uncut_share, 0.0);
}

template <typename Judge>
void
judgeBy(Judge& judge, const RandomCase& made, const Path::ConstPtr& path, pcl::PointCloud<pcl::PointXYZI>& values)
{
  judge.setInputCloud(made.cloud);
  judge.setInputToolpath(path);
  judge.setChordError(made.settings.chord_error);
  judge.setViewPoint(*made.settings.view_point);
  judge.setNumberOfThreads(1);
  judge.compute(values);
}

/** The path by our own judges, which know the scan alone. */
void
checkByScan(const RandomCase& made, const Path::ConstPtr& path, const SpiralReport& report, Faults& faults)
{
  const SpiralSettings& s = made.settings;
  pcl::PointCloud<pcl::PointXYZI> values;
  DeviationEstimation<pcl::PointXYZ> deviation;
  judgeBy(deviation, made, path, values);
  if (!deviation.getStatus().ok()) {
    faults.atMost(("not judged: " + deviation.getStatus().message()).c_str(), 1.0, 0.0);
    return;
  }
  const DeviationReport& d = deviation.getReport();
  const double known = 3.0 * d.fit_noise + made.spacing * made.spacing * made.bend;
  faults.atMost("opposed normals", static_cast<double>(d.opposed), 0.0);
  faults.atMost("inward axes", static_cast<double>(d.inward_axes), 0.0);
  faults.atMost("judged deviation p99", d.p99, s.chord_error + known + 2.0 * made.noise);
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setToolRadius(s.tool_radius);
  removal.setScallopHeight(s.scallop_height);
  removal.setReferenceSurface(deviation.getReferenceSurface());
  judgeBy(removal, made, path, values);
  if (!removal.getStatus().ok()) {
    faults.atMost(("not judged: " + removal.getStatus().message()).c_str(), 1.0, 0.0);
    return;
  }
  const RemovalReport& r = removal.getReport();
  if (report.corner_ridge == s.tool_radius) // left uncut, as foretold
    return;
  faults.atMost("judged uncut share", r.scallop.uncutShare(), 0.0);
  const double limit = std::max(r.limit, highestRidge(s, report) + s.chord_error);
  faults.atMost("judged scallop p99.9", r.scallop.p999, limit + known + 3.0 * made.noise);
}

Outcome
outcomeOf(const RandomCase& made, SpiralMethod method)
{
  Generator generator;
  generator.setInputCloud(made.cloud);
  generator.setSettings(settingsOf(made, method));
  const Path::Ptr path(new Path);
  generator.compute(*path);
  const Status& status = generator.getStatus();
  if (!status.ok()) {
    const bool told = path->empty() && status.message().size() > 30 && status.code() != StatusCode::NotComputed;
    return {reasonOf(status.message()), told ? "" : "a refusal with a path or without a reason: " + status.message()};
  }
  Faults faults;
  if (path->size() < 3)
    return {"path", "success without a path"};
  checkPoints(*path, faults);
  checkAgainstSurface(made, *path, generator.getReport(), faults);
  checkByScan(made, path, generator.getReport(), faults);
  return {"path", faults.text()};
}

} // namespace

int
judgeRandom(const Options& options)
{
  if (!isMethod(options.method))
    return 1;
  return judgeSeries("random", options, longest_run,
                     [&options](const RandomCase& made) { return outcomeOf(made, *methodNamed(options.method)); });
}

} // namespace pcl_spiral::acceptance
