// SPDX-License-Identifier: BSD-3-Clause
#include "pass_report.h"

#include "io/report/diagnostic_json.h"

#include "terminal/scan_places.h"
#include "terminal/vocabulary.h"

#include <pcl_spiral/io/file_error.h>

#include <fstream>

using namespace pcl_spiral;
using Json = nlohmann::ordered_json;

namespace {

Json
statesOf(const LocationFigures& figures)
{
  Json states;
  for (std::size_t i = 0; i < location_states; ++i)
    states[nameOf(static_cast<LocationState>(i))] = figures.states[i];
  return states;
}

Json
locationsOf(const PassResult& result)
{
  const LocationFigures& f = result.locations;
  const BisectionFigures& b = result.bisection;
  return {{"count", result.poseCount()},
          {"put_in", b.inserted},
          {"largest_error", b.largest_error},
          {"unresolved_moves", b.unresolved},
          {"states", statesOf(f)},
          {"off_scan", result.off_scan},
          {"kept_out", result.left_out.entering + result.left_out.touching},
          {"touching_keep_outs", result.left_out.touching},
          {"touching_beside", result.left_out.beside},
          {"under_scan", f.under_scan},
          {"over_rim", f.over_rim},
          {"retilted", f.retilted},
          {"largest_retilt", f.largest_retilt},
          {"collisions", f.collisions},
          {"deepest_collision", f.deepest_collision},
          {"noise_allowance", f.noise_allowance}};
}

} // namespace

Json
cutterOf(const PassJob& job)
{
  const CutterShape& c = job.cutter;
  return {{"radius", c.radius}, {"corner_radius", c.corner_radius}, {"flank_length", c.flank_length}, {"flank_angle", c.flank_angle}};
}

void
addPasses(const PassResult& result, Json& report)
{
  Json stages = Json::array();
  for (const StageCost& stage : result.stages)
    stages.push_back({{"stage", stage.name}, {"seconds", stage.seconds}});
  report["passes"] = result.passes.size();
  report["tip_length"] = result.length;
  report["locations"] = locationsOf(result);
  report["stages"] = stages;
  report["warnings"] = textsOf(result.warnings, programWords());
  report["diagnostics"] = diagnosticsJson(result.warnings, programWords(), scanShift());
  report["shift"] = {scanShift().x(), scanShift().y(), scanShift().z()};
  if (result.program)
    report["machine"] = {{"name", result.program->machine.name},
                         {"blocks", result.program->blocks.size()},
                         {"minutes", result.program->report.minutes},
                         {"links", result.program->report.links},
                         {"blocked_links", result.program->report.blocked_links},
                         {"saved_way", result.program->report.saved_way}};
}

void
writeJSON(const std::string& file, const Json& report)
{
  std::ofstream out(file);
  out << report.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  if (!out.flush())
    throw FileError(file, "cannot be written; is the disk full?");
}
