// SPDX-License-Identifier: BSD-3-Clause
#include "figures_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

using pcl_spiral::Limits;
using pcl_spiral::PlacedValue;
using pcl_spiral::StockFigures;

namespace {

std::string
at(const PlacedValue& value)
{
  char text[120];
  std::snprintf(text, sizeof(text), "at (%.3f, %.3f, %.3f), path point %zu", value.position.x(), value.position.y(), value.position.z(),
                value.index);
  return text;
}

void
printStock(const char* name, const StockFigures& stock)
{
  if (stock.samples == 0)
    std::printf("%-16sno reference point lies there\n", name);
  else
    std::printf("%-16sp50 %.4f, p99 %.4f, p99.9 %.4f, max %.4f mm %s\n", name, stock.p50, stock.p99, stock.p999, stock.max.value,
                at(stock.max).c_str());
}

} // namespace

std::vector<std::string>
brokenLimits(const Limits& limits, const pcl_spiral::Verification& verification)
{
  const pcl_spiral::DeviationFigures& deviation = verification.deviation;
  const pcl_spiral::RemovalFigures& removal = verification.removal;
  std::vector<std::string> broken;
  const auto check = [&](const char* option, const std::optional<double>& limit, double value, const std::string& place) {
    if (!limit || value <= *limit)
      return;
    std::ostringstream text;
    text << option << " " << *limit << " is broken: " << value << " " << place;
    broken.push_back(text.str());
  };
  const PlacedValue& scallop = highestScallop(removal);
  check("--max-deviation", limits.deviation, std::abs(deviation.max.value), "mm " + at(deviation.max));
  check("--max-deviation", limits.deviation, std::abs(deviation.rim_max.value), "mm beyond the rim " + at(deviation.rim_max));
  check("--max-scallop", limits.scallop, scallop.value, "mm " + at(scallop));
  check("--max-scallop", limits.scallop, removal.rim.max.value, "mm left at the rim " + at(removal.rim.max));
  check("--max-gouge", limits.gouge, removal.gouge.value, "mm " + at(removal.gouge));
  check("--max-gouge", limits.gouge, removal.rim_gouge.value, "mm beyond the rim " + at(removal.rim_gouge));
  check("--max-uncut", limits.uncut, uncutPercent(removal), "percent, first " + at(firstUncut(removal)));
  const auto fault = [&](std::size_t count, const std::string& what) {
    if (count > 0 && limits.any())
      broken.push_back("no limit can hold: " + std::to_string(count) + " of " + std::to_string(deviation.points) + " path points " + what);
  };
  fault(deviation.unmeasured, "lie off the surface and were not judged");
  fault(deviation.opposed, "have a normal that points into the material, first " + at(deviation.first_opposed));
  fault(deviation.inward_axes, "have a tool axis that points into the material, first " + at(deviation.first_inward));
  fault(verification.tips_off, "have a tool tip that is not this cutter's, the farthest " + at(verification.tip_error));
  return broken;
}

std::vector<std::string>
unprovenLimits(const Limits& limits, const pcl_spiral::Verification& verification)
{
  const double least = 3.0 * verification.deviation.fit_noise;
  std::vector<std::string> unproven;
  const auto check = [&](const char* option, const std::optional<double>& limit, double value) {
    if (!limit || *limit >= least || value > *limit)
      return;
    std::ostringstream text;
    text << option << " " << *limit << " mm lies below " << std::setprecision(2) << least
         << (verification.deviation.by_mesh
                 ? " mm, three times what the surface fitted to the mesh's samples is off by: these cannot show that it holds; "
                   "sample more closely (--sample-spacing)"
                 : " mm, three times the noise of the scan's surface: this scan cannot show that it holds");
    unproven.push_back(text.str());
  };
  check("--max-deviation", limits.deviation, std::abs(verification.deviation.max.value));
  check("--max-scallop", limits.scallop, highestScallop(verification.removal).value);
  check("--max-gouge", limits.gouge, verification.removal.gouge.value);
  if (limits.any() && verification.deviation.in_gaps > 0)
    unproven.push_back(std::to_string(verification.deviation.in_gaps) +
                       " path points lie in gaps of the scan: no limit is shown to hold there");
  return unproven;
}

void
printFigures(const pcl_spiral::Verification& verification)
{
  const pcl_spiral::DeviationFigures& d = verification.deviation;
  const pcl_spiral::RemovalFigures& r = verification.removal;
  if (!verification.path.empty())
    std::printf("path            %s: %zu points, %.3f m\n", verification.path.c_str(), d.points, d.motion.length / 1000.0);
  if (d.by_mesh)
    std::printf("reference       %zu samples of the mesh; their surface is known to %.2g mm\n", d.reference_points, d.fit_noise);
  else
    std::printf("reference       %zu points, noise %.2g mm; its surface is known to %.2g mm\n", d.reference_points, d.noise, d.fit_noise);
  std::printf("deviation       rms %.4f, p99 %.4f, max %.4f mm %s\n", d.rms, d.p99, d.max.value, at(d.max).c_str());
  if (d.wobble.measured > 0)
    std::printf("turn to turn    wobble rms %.4f, max %.4f mm %s\n", d.wobble.rms, d.wobble.max.value, at(d.wobble.max).c_str());
  if (d.beyond_rim > 0)
    std::printf("beyond the rim  %zu points, max %.4f mm %s\n", d.beyond_rim, d.rim_max.value, at(d.rim_max).c_str());
  if (d.in_gaps > 0)
    std::printf("in scan gaps    %zu points, %.4f mm off the surface carried on %s\n", d.in_gaps, d.gap_max.value, at(d.gap_max).c_str());
  if (d.in_crease_band > 0)
    std::printf("at creases      %zu points within %.3g mm, up to %.4f mm off the rounded fit %s\n", d.in_crease_band, d.crease_band,
                d.crease_max.value, at(d.crease_max).c_str());
  if (r.crease.samples > 0)
    std::printf("                stock up to %.4f mm %s, gouge %.4f mm; no verdict\n", r.crease.max.value, at(r.crease.max).c_str(),
                r.crease_gouge.value);
  if (d.unmeasured > 0)
    std::printf("off the surface %zu points\n", d.unmeasured);
  std::printf("normals         p99 %.3g, max %.3g degrees %s\n", d.normal_p99, d.normal_error.value, at(d.normal_error).c_str());
  if (d.opposed > 0)
    std::printf("turned normals  %zu, first %s\n", d.opposed, at(d.first_opposed).c_str());
  if (d.inward_axes > 0)
    std::printf("inward axes     %zu, first %s\n", d.inward_axes, at(d.first_inward).c_str());
  if (verification.tips_off > 0)
    std::printf("wrong tips      %zu, by up to %.4f mm %s\n", verification.tips_off, verification.tip_error.value,
                at(verification.tip_error).c_str());
  printStock("scallop", r.scallop);
  std::printf("                %.3g %% of the ridges above %.4g mm\n", 100.0 * r.scallop.share_above, r.limit);
  printStock("stock at rim", r.rim);
  if (r.gouge.value > 0.0)
    std::printf("gouge           %.4f mm %s\n", r.gouge.value, at(r.gouge).c_str());
  else
    std::printf("gouge           none\n");
  if (r.rim_gouge.value > 0.0)
    std::printf("  beyond the rim %.4f mm %s\n", r.rim_gouge.value, at(r.rim_gouge).c_str());
  const double uncut = uncutPercent(r);
  std::printf("uncut           %.3g %% of the points%s%s\n", uncut, uncut > 0.0 ? ", first " : "",
              uncut > 0.0 ? at(firstUncut(r)).c_str() : "");
  std::printf("efficiency      %.3f: least length %.3f m of %.3f m\n", r.efficiency, r.least_length / 1000.0, r.path_length / 1000.0);
  if (d.motion.lifts > 0)
    std::printf("lifts           %zu between passes, %.3f m, no cuts\n", d.motion.lifts, d.motion.lift_length / 1000.0);
  std::printf("largest step    %.4g mm %s\n", d.motion.gap.value, at(d.motion.gap).c_str());
  std::printf("largest turn    %.3g degrees a step %s\n", d.motion.turn.value, at(d.motion.turn).c_str());
  std::printf("axis change     %.3g degrees a step %s\n", d.motion.axis_change.value, at(d.motion.axis_change).c_str());
  for (const std::string& broken : verification.broken)
    std::printf("LIMIT           %s\n", broken.c_str());
  for (const std::string& unproven : verification.unproven)
    std::printf("limit           %s\n", unproven.c_str());
}
