// SPDX-License-Identifier: BSD-3-Clause
#include "pass_json.h"

#include "diagnostic_json.h"
#include "io/byte_file.h"
#include "motion_report.h"
#include "moved_places.h"

namespace pcl_spiral {

using Json = nlohmann::ordered_json;

namespace {

Json
statesOf(const LocationReport& figures)
{
  Json states;
  for (std::size_t i = 0; i < location_states; ++i)
    states[nameOf(static_cast<LocationState>(i))] = figures.states[i];
  return states;
}

Json
locationsOf(const PassPlan& result)
{
  const LocationReport& f = result.locations;
  const BisectionReport& b = result.bisection;
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
cutterJson(const CutterShape& c)
{
  return {{"radius", c.radius}, {"corner_radius", c.corner_radius}, {"flank_length", c.flank_length}, {"flank_angle", c.flank_angle}};
}

Json
placeJson(const Eigen::Vector3d& place)
{
  return {place.x(), place.y(), place.z()};
}

void
addPasses(const RunFiles& files, const PassRun& run, const PassPlan& plan, Json& report)
{
  Json stages = Json::array();
  for (const StageCost& stage : plan.stages)
    stages.push_back({{"stage", stage.name}, {"seconds", stage.seconds}});
  Diagnostics warnings = files.warnings;
  warnings.insert(warnings.end(), plan.warnings.begin(), plan.warnings.end());
  const Vocabulary words = movedBy(files.shift, files.words);
  report["passes"] = plan.passes.size();
  report["tip_length"] = plan.length;
  report["locations"] = locationsOf(plan);
  report["stages"] = stages;
  report["warnings"] = textsOf(warnings, words);
  report["diagnostics"] = diagnosticsJson(warnings, words, files.shift);
  report["shift"] = placeJson(files.shift);
  if (run.program)
    report["machine"] = {{"name", run.program->machine.name},
                         {"blocks", run.program->blocks.size()},
                         {"minutes", run.program->report.minutes},
                         {"links", run.program->report.links},
                         {"blocked_links", run.program->report.blocked_links},
                         {"saved_way", run.program->report.saved_way}};
  if (run.motion)
    report["motion"] = motionJson(*run.motion);
}

void
writeText(const std::string& file, const std::string& text)
{
  ByteFile out(file);
  out.write(text);
  out.close();
}

std::string
jsonText(const Json& report)
{
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace pcl_spiral
