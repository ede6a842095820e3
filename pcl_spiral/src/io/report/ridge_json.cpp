// SPDX-License-Identifier: BSD-3-Clause
#include "pass_json.h"
#include "run_options.h"
#include "settings_json.h"

#include "io/setting_names.h"

#include <stdexcept>

namespace pcl_spiral {

using Json = nlohmann::ordered_json;

namespace {

Json
settingsOf(const RunFiles& files, const RidgeRun& run)
{
  Json settings = {
      {"one_way", !run.rows.zigzag}, {"units", choiceName(files.unit)}, {"origin", placeJson(files.origin)}, {"feed", run.feed}};
  settings.update(settingsJson(run.ridge));
  settings.update(settingsJson(run.rows));
  settings.erase("zigzag"); // said by one_way
  settings.update(settingsJson(run.tool));
  if (!run.rough_points.empty()) {
    Json places = Json::array();
    for (const Eigen::Vector3d& place : run.rough_points)
      places.push_back(placeJson(place));
    settings["through"] = places;
    settings["half_width"] = run.half_width;
    settings["ring"] = run.closed;
  }
  if (run.tool.cutter.radius > 0.0)
    settings["cutter"] = cutterJson(run.tool.cutter);
  return settings;
}

Json
ridgeOf(const RidgeReport& r, const Eigen::Vector3d& shift)
{
  return {{"rail_points", r.rail_points},
          {"generator_points", r.generator_points},
          {"closed", r.closed},
          {"rail_length", r.rail_length},
          {"generator_length", r.generator_length},
          {"rail_error", r.rail_error},
          {"generator_error", r.generator_error},
          {"rail_direction", r.rail_direction},
          {"generator_direction", r.generator_direction},
          {"meeting_place", placeJson(r.meeting_place + shift)},
          {"meeting_distance", r.meeting_distance},
          {"chord", r.chord},
          {"chord_angle", r.chord_angle},
          {"tilt", r.tilt},
          {"largest_slope", r.largest_slope},
          {"steepest_place", placeJson(r.steepest_place + shift)},
          {"slope_factor", r.slope_factor},
          {"least_stretch", r.least_stretch}};
}

Json
foundOf(const ScanRidgeReport& f, const Eigen::Vector3d& shift)
{
  return {{"sections", f.sections},
          {"points", f.points},
          {"rounds", f.rounds},
          {"noise", f.noise},
          {"crest_wander", f.crest_wander},
          {"misfit", f.misfit},
          {"largest_misfit", f.largest_misfit},
          {"largest_place", placeJson(f.largest_place + shift)}};
}

} // namespace

std::string
ridgeReportJSON(const RunFiles& files, const RidgeRun& run, const PassPlan& plan, const RidgePlanReport& figures)
{
  if (!figures.ridge)
    throw std::invalid_argument("ridgeReportJSON: the plan has no ridge; it is one of a planner that succeeded");
  Json report = {{"program", "pcl_spiral_ridge"}};
  for (const auto& [name, value] : {std::pair("rail", run.rail), std::pair("generator", run.generator), std::pair("scan", files.scan)})
    if (!value.empty())
      report[name] = value;
  report["options"] = optionsJson(files.options);
  report["settings"] = settingsOf(files, run);
  report["ridge"] = ridgeOf(figures.ridge->report(), files.shift);
  if (figures.found)
    report["found_in_scan"] = foundOf(*figures.found, files.shift);
  report["rows"] = {{"count", figures.rows.rows}, {"largest_step", figures.rows.largest_step}, {"points", figures.rows.points}};
  addPasses(files, run, plan, report);
  return jsonText(report);
}

void
writeRidgeReportJSON(const std::string& file, const RunFiles& files, const RidgeRun& run, const PassPlan& plan,
                     const RidgePlanReport& figures)
{
  writeText(file, ridgeReportJSON(files, run, plan, figures));
}

} // namespace pcl_spiral
