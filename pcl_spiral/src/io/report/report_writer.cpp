// SPDX-License-Identifier: BSD-3-Clause
#include "diagnostic_json.h"
#include "io/byte_file.h"
#include "mesh_json.h"
#include "motion_report.h"
#include "moved_places.h"
#include "run_options.h"
#include "settings_json.h"
#include "side_json.h"
#include "verification_json.h"

#include "io/setting_names.h"
#include <pcl_spiral/io/report_writer.h>

#include <nlohmann/json.hpp>

namespace pcl_spiral {
namespace {

using Json = nlohmann::ordered_json; // keeps the order of writing

Json
toJson(const Eigen::Vector3d& v)
{
  return Json::array({v.x(), v.y(), v.z()});
}

Json
loopsJson(const SpiralReport& report)
{
  Json loops = Json::array();
  for (const BoundaryLoop& loop : report.loops) {
    Json corners = Json::array();
    for (const std::size_t corner : loop.corners)
      if (corner < loop.curve.size())
        corners.push_back(toJson(loop.curve[corner]));
    const char* const type = loop.type == LoopType::Outer ? "outer" : loop.type == LoopType::Inner ? "inner" : "scan gap";
    loops.push_back(
        {{"type", type}, {"length", loop.length}, {"points", std::max(loop.points.size(), loop.indices.size())}, {"corners", corners}});
  }
  return loops;
}

Json
holesJson(const SpiralReport& report)
{
  Json holes = Json::array();
  for (const HoleReport& hole : report.holes)
    holes.push_back({{"place", toJson(hole.place)}, {"width", hole.width}, {"path", choiceName(hole.handling)}});
  return holes;
}

/** Points that stand out of the surface; null if there are none. */
Json
missedJson(const MissedPoints& missed)
{
  if (missed.count == 0)
    return {};
  return {{"count", missed.count}, {"height", missed.height}, {"place", toJson(missed.place)}};
}

/** What the ball does not reach; null with TightHandling::Refuse and with the published method. */
Json
tightJson(const SpiralReport& report)
{
  if (!(report.fitting_radius > 0.0))
    return {};
  Json places = Json::array();
  for (const TightPlace& place : report.tight_places)
    places.push_back({{"place", toJson(place.place)},
                      {"height", place.height},
                      {"area", place.area},
                      {"radius", place.radius},
                      {"under_cluster", place.under_cluster}});
  return {{"fitting_radius", report.fitting_radius},
          {"lifted_length", report.lifted_length},
          {"largest_lift", report.largest_lift},
          {"missed", missedJson(report.missed)},
          {"places", places}};
}

/** Figures of the path at constant scallop height. */
Json
scallopJson(const SpiralReport& report)
{
  if (report.method != SpiralMethod::ConstantScallop)
    return {};
  return {{"loops", report.scallop_loops},    {"chain_loops", report.chain_loops},       {"bridges", report.bridges},
          {"fingers", report.fingers},        {"reversed_share", report.reversed_share}, {"passes", report.pass_begins.size() + 1},
          {"lift_length", report.lift_length}};
}

Json
foreseenJson(const SpiralReport& report)
{
  if (report.foreseen_scallop == 0.0)
    return {};
  return {{"radial", report.foreseen_radial > 0.0 ? Json(report.foreseen_radial) : Json()}, {"constant_scallop", report.foreseen_scallop}};
}

Json
surfaceJson(const SpiralReport& report)
{
  return {{"input_points", report.input_points},
          {"nonfinite_points", report.nonfinite_points},
          {"duplicate_points", report.duplicate_points},
          {"outlier_points", report.outlier_points},
          {"surplus_points", report.surplus_points},
          {"left_out_parts", report.left_out_parts},
          {"left_out_points", report.left_out_points},
          {"used_points", report.used_points},
          {"neighbourhood_passes", report.passes},
          {"spacing", report.spacing},
          {"noise", report.noise},
          {"side", sideJson(report.side)},
          {"projection_neighbours", report.projection_neighbours}};
}

Json
pathJson(const SpiralReport& report, double feed)
{
  return {{"method", choiceName(report.method)},
          {"foreseen_length", foreseenJson(report)},
          {"boundaries", report.boundaries},
          {"center", report.boundaries == 1 && report.method != SpiralMethod::ConstantScallop ? toJson(report.centre) : Json()},
          {"radial_lines", report.radial_lines.size()},
          {"harmonic_lines", report.harmonic_lines},
          {"center_settled", report.centre_settled},
          {"unsettled_lines", report.unsettled_lines},
          {"largest_unsettled", report.largest_unsettled},
          {"line_error", report.line_error},
          {"line_tolerance", report.line_tolerance},
          {"constant_scallop", scallopJson(report)},
          {"turn_radius", report.turn_radius > 0.0 ? Json(report.turn_radius) : Json()},
          {"sharpest_turn", report.turn_radius > 0.0 ? toJson(report.sharpest_place) : Json()},
          {"least_length", report.least_length > 0.0 ? Json(report.least_length) : Json()},
          {"efficiency", report.efficiency > 0.0 ? Json(report.efficiency) : Json()},
          {"turns", report.turns},
          {"points", report.path_points},
          {"length", report.path_length},
          {"points_over_gaps", report.gap_points},
          {"length_over_gaps", report.gap_length},
          {"machining_minutes", feed > 0.0 ? Json(report.path_length / feed) : Json()},
          {"smallest_step_over", report.smallest_step_over},
          {"closest_turns", report.closest_place.isZero() ? Json() : toJson(report.closest_place)},
          {"largest_step_over", report.largest_step_over},
          {"reversals", report.reversals},
          {"corner_ridge", report.corner_ridge},
          {"largest_allowed_step", report.largest_allowed_step},
          {"largest_gap", report.largest_gap},
          {"largest_axis_change", report.largest_axis_change},
          {"largest_axis_rate", report.largest_axis_rate},
          {"largest_axis_lean", report.largest_axis_lean},
          {"largest_axis_deviation", report.largest_axis_deviation},
          {"deviating_points", report.deviating_points}};
}

/** MB; null if it is not known. */
Json
megabytes(std::size_t bytes)
{
  return bytes > 0 ? Json(1e-6 * static_cast<double>(bytes)) : Json();
}

Json
secondsJson(const std::vector<StageCost>& costs)
{
  Json stages = Json::object();
  double total = 0.0;
  for (const StageCost& stage : costs) {
    stages[stage.name] = stage.seconds;
    total += stage.seconds;
  }
  return {{"total", total}, {"stages", stages}};
}

/** At the end of each stage: memory in use, and the peak up to then. */
Json
memoryJson(const std::vector<StageCost>& costs)
{
  Json stages = Json::object();
  for (const StageCost& stage : costs)
    stages[stage.name] = {{"resident", megabytes(stage.memory.resident)}, {"peak", megabytes(stage.memory.peak)}};
  return {{"peak", costs.empty() ? Json() : megabytes(costs.back().memory.peak)}, {"stages", stages}};
}

Json
inputJson(const RunFiles& files)
{
  return {{"file", files.scan}, {"unit", choiceName(files.unit)}, {"origin", toJson(files.origin)}, {"shift", toJson(files.shift)}};
}

/** Adds the tries, if there is more than one, each with the reason why the next one was made. */
void
addTries(const std::vector<PlanAttempt>& attempts, const Vocabulary& words, Json& json)
{
  for (std::size_t i = 0; attempts.size() > 1 && i < attempts.size(); ++i) {
    const PlanAttempt& one = attempts[i];
    json["tries"].push_back({{"margin", one.margin},
                             {"strip_width", one.strip_width},
                             {"strips_cut", one.cut},
                             {"refusal", one.refusal.empty() ? Json() : Json(one.refusal.text(words))}});
  }
}

/** What a report has of the whole run, of one region. */
Json
regionJson(const PathReport& region, const RunFiles& files, double feed)
{
  const SpiralReport& report = region.report;
  Json json = {{"region", region.name},
               {"passes", report.pass_begins.size() + 1},
               {"surface", surfaceJson(report)},
               {"loops", loopsJson(report)},
               {"holes", holesJson(report)},
               {"path", pathJson(report, feed)},
               {"not_reached", tightJson(report)},
               {"seconds", secondsJson(report.stages)},
               {"warnings", textsOf(report.warnings, files.words)},
               {"diagnostics", diagnosticsJson(report.warnings, files.words, files.shift)}};
  addTries(region.attempts, files.words, json);
  if (region.verification)
    json["verification"] = verificationJson(*region.verification, files.words, files.shift);
  return json;
}

} // namespace

RunReport
reportOf(const SpiralPlan& plan, const std::vector<Verification>& judged)
{
  RunReport run;
  run.report = plan.report;
  run.attempts = plan.attempts;
  run.settings = plan.settings;
  if (plan.mesh)
    run.mesh = RunMesh{plan.mesh->counts, plan.mesh->spacing};
  if (plan.regions.empty() && !judged.empty())
    run.verification = judged.front();
  for (std::size_t k = 0; k < plan.regions.size(); ++k) {
    const SpiralPlan& region = plan.regions[k];
    run.regions.push_back({region.region, region.report, std::nullopt, {}, region.attempts});
    if (k < judged.size())
      run.regions.back().verification = judged[k];
  }
  return run;
}

std::string
reportJSON(const RunFiles& of_run, const RunReport& given)
{
  RunFiles files = of_run;
  files.words = movedBy(files.shift, files.words);
  const RunReport run = movedBy(files.shift, given);
  const SpiralSettings& settings = run.settings;
  const SpiralReport& report = run.report;
  Diagnostics warnings = files.warnings;
  warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
  Json json = {{"units", {{"length", "mm"}, {"angle", "degree"}, {"feed", "mm/min"}, {"time", "s"}, {"memory", "MB"}}},
               {"input", inputJson(files)},
               {"outputs", files.outputs},
               {"options", optionsJson(files.options)},
               {"settings", settingsJson(settings)},
               {"surface", surfaceJson(report)},
               {"loops", loopsJson(report)},
               {"holes", holesJson(report)},
               {"path", pathJson(report, settings.feed)},
               {"not_reached", tightJson(report)},
               {"seconds", secondsJson(report.stages)},
               {"memory", memoryJson(report.stages)},
               {"warnings", textsOf(warnings, files.words)},
               {"diagnostics", diagnosticsJson(warnings, files.words, files.shift)}};
  if (settings.max_step == 0.0)
    json["settings"]["max_step"] = settings.tool_radius; // as used
  if (settings.hole_size == 0.0)
    json["settings"]["hole_size"] = nullptr; // found from the scan
  addTries(run.attempts, files.words, json);
  if (run.motion)
    json["motion"] = motionJson(*run.motion);
  if (run.mesh)
    json["mesh"] = meshJson(*run.mesh);
  if (run.verification)
    json["verification"] = verificationJson(*run.verification, files.words, files.shift);
  for (const PathReport& region : run.regions)
    json["regions"].push_back(regionJson(region, files, settings.feed));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void
writeReportJSON(const std::string& file, const RunFiles& files, const RunReport& report)
{
  ByteFile out(file);
  out.write(reportJSON(files, report));
  out.close();
}

} // namespace pcl_spiral
