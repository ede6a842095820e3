// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_report.h"

#include "passes/pass_report.h"

#include "io/report/run_options.h"
#include "io/report/settings_json.h"
#include "io/setting_names.h"

using namespace pcl_spiral;
using Json = nlohmann::ordered_json;

namespace {

Json
placeOf(const Eigen::Vector3d& place)
{
  return {place.x(), place.y(), place.z()};
}

Json
settingsOf(const Job& job)
{
  Json settings = {
      {"one_way", job.one_way}, {"units", choiceName(job.read.unit)}, {"origin", placeOf(job.read.origin)}, {"feed", job.feed}};
  settings.update(settingsJson(job.ridge));
  settings.update(settingsJson(job.rows));
  settings.erase("zigzag"); // said by one_way
  settings.update(settingsJson(static_cast<const PassSettings&>(job)));
  if (!job.through.empty()) {
    Json places = Json::array();
    for (const Eigen::Vector3d& place : job.through)
      places.push_back(placeOf(place));
    settings["through"] = places;
    settings["half_width"] = job.half_width;
    settings["ring"] = job.ring;
  }
  if (job.hasCutter())
    settings["cutter"] = cutterOf(job);
  return settings;
}

Json
ridgeOf(const RidgeReport& r)
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
          {"meeting_place", placeOf(inScan(r.meeting_place))},
          {"meeting_distance", r.meeting_distance},
          {"chord", r.chord},
          {"chord_angle", r.chord_angle},
          {"tilt", r.tilt},
          {"largest_slope", r.largest_slope},
          {"steepest_place", placeOf(inScan(r.steepest_place))},
          {"slope_factor", r.slope_factor},
          {"least_stretch", r.least_stretch}};
}

Json
foundOf(const ScanRidgeReport& f)
{
  return {{"sections", f.sections},
          {"points", f.points},
          {"rounds", f.rounds},
          {"noise", f.noise},
          {"crest_wander", f.crest_wander},
          {"misfit", f.misfit},
          {"largest_misfit", f.largest_misfit},
          {"largest_place", placeOf(inScan(f.largest_place))}};
}

} // namespace

void
writeRidgeReport(const std::string& file, const Job& job, const Result& result)
{
  Json report = {{"program", "pcl_spiral_ridge"}};
  for (const auto& [name, value] : {std::pair("rail", job.rail), std::pair("generator", job.generator), std::pair("scan", job.scan)})
    if (!value.empty())
      report[name] = value;
  report["options"] = optionsJson(job.options);
  report["settings"] = settingsOf(job);
  report["ridge"] = ridgeOf(result.ridge->report());
  if (result.found)
    report["found_in_scan"] = foundOf(*result.found);
  report["rows"] = {{"count", result.rows.rows}, {"largest_step", result.rows.largest_step}, {"points", result.rows.points}};
  addPasses(result, report);
  writeJSON(file, report);
}
