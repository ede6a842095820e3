// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"
#include "verification_json.h"

#include "io/setting_names.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

using Json = nlohmann::ordered_json;

Json
placed(const PlacedValue& v)
{
  return {{"value", v.value}, {"position", {v.position.x(), v.position.y(), v.position.z()}}, {"index", v.index}};
}

Json
deviationJson(const DeviationFigures& d)
{
  return {{"points", d.points},
          {"measured", d.measured},
          {"beyond_rim", d.beyond_rim},
          {"in_gaps", d.in_gaps},
          {"in_crease_band", d.in_crease_band},
          {"crease_band", d.crease_band},
          {"unmeasured", d.unmeasured},
          {"rms", d.rms},
          {"p99", d.p99},
          {"max", placed(d.max)},
          {"beyond_rim_max", placed(d.rim_max)},
          {"gap_max", placed(d.gap_max)},
          {"crease_max", placed(d.crease_max)},
          {"turn_wobble_rms", d.wobble.rms},
          {"turn_wobble_max", placed(d.wobble.max)},
          {"normal_p99", d.normal_p99},
          {"normal_max", placed(d.normal_error)},
          {"opposed_normals", d.opposed},
          {"inward_axes", d.inward_axes},
          {"seconds", d.seconds}};
}

Json
motionJson(const PathMotion& m)
{
  return {{"length", m.length},
          {"lifts", m.lifts},
          {"lift_length", m.lift_length},
          {"largest_gap", placed(m.gap)},
          {"largest_turn", placed(m.turn)},
          {"largest_axis_change", placed(m.axis_change)},
          {"largest_normal_change", placed(m.normal_change)}};
}

Json
stockJson(const StockFigures& s)
{
  return {{"samples", s.samples},
          {"p50", s.p50},
          {"p90", s.p90},
          {"p99", s.p99},
          {"p99.9", s.p999},
          {"max", placed(s.max)},
          {"uncut_share", s.uncutShare()},
          {"first_uncut", s.uncut > 0 ? placed(s.first_uncut) : Json()},
          {"share_above_limit", s.share_above}};
}

Json
removalJson(const RemovalFigures& r)
{
  return {{"reference_points", r.reference_points},
          {"unmeasured", r.unmeasured},
          {"scallop_limit", r.limit},
          {"reach", r.reach},
          {"scallop", stockJson(r.scallop)},
          {"stock", stockJson(r.stock)},
          {"rim_band", stockJson(r.rim)},
          {"crease_band", stockJson(r.crease)},
          {"crease_gouge", placed(r.crease_gouge)},
          {"gouge", placed(r.gouge)},
          {"rim_gouge", placed(r.rim_gouge)},
          {"area", r.area},
          {"rim_length", r.rim_length},
          {"least_length", r.least_length},
          {"efficiency", r.efficiency},
          {"seconds", r.seconds}};
}

/** null for a scan. */
Json
meshJson(const std::optional<JudgedMesh>& mesh)
{
  if (!mesh)
    return Json();
  const MeshCounts& counts = mesh->counts;
  return {{"faces", counts.faces},
          {"vertices", counts.vertices},
          {"parts", counts.parts},
          {"rims", counts.loops},
          {"closed", counts.closed},
          {"judged_faces", mesh->judged_faces},
          {"crease_angle", mesh->settings.crease_angle},
          {"crease_edges", counts.creases.count},
          {"crease_length", counts.crease_length},
          {"flipped", mesh->settings.flip},
          {"sample_spacing", mesh->sample_spacing}};
}

Json
limitsJson(const Limits& limits)
{
  const auto value = [](const std::optional<double>& limit) { return limit ? Json(*limit) : Json(); };
  return {{"max_gouge", value(limits.gouge)},
          {"max_scallop", value(limits.scallop)},
          {"max_deviation", value(limits.deviation)},
          {"max_uncut_percent", value(limits.uncut)}};
}

} // namespace

double
uncutPercent(const RemovalFigures& removal)
{
  const std::size_t samples = removal.stock.samples + removal.rim.samples;
  const std::size_t uncut = removal.stock.uncut + removal.rim.uncut;
  return samples > 0 ? 100.0 * static_cast<double>(uncut) / static_cast<double>(samples) : 100.0;
}

const PlacedValue&
firstUncut(const RemovalFigures& removal)
{
  return removal.stock.uncut > 0 ? removal.stock.first_uncut : removal.rim.first_uncut;
}

const PlacedValue&
highestScallop(const RemovalFigures& removal)
{
  return removal.scallop.samples > 0 ? removal.scallop.max : removal.stock.max;
}

std::vector<std::string>
warningsOf(const Verification& verification)
{
  std::vector<std::string> warnings = verification.deviation.warnings;
  for (const std::string& warning : verification.removal.warnings)
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      warnings.push_back(warning);
  return warnings;
}

nlohmann::ordered_json
verificationJson(const Verification& v)
{
  return {{"noise", v.deviation.noise},
          {"fit_noise", v.deviation.fit_noise},
          {"deviation", deviationJson(v.deviation)},
          {"material", removalJson(v.removal)},
          {"motion", motionJson(v.deviation.motion)},
          {"tips_off", v.tips_off},
          {"tip_error", placed(v.tip_error)},
          {"broken_limits", v.broken},
          {"unproven_limits", v.unproven},
          {"seconds", v.seconds},
          {"warnings", warningsOf(v)}};
}

void
writeVerificationJSON(const std::string& file, const VerificationRun& run, const std::vector<Verification>& verifications)
{
  Json paths = Json::array();
  for (const Verification& verification : verifications) {
    Json path = {{"file", verification.path}};
    path.update(verificationJson(verification));
    paths.push_back(path);
  }
  const Json json = {{"units", {{"length", "mm"}, {"angle", "degree"}, {"time", "s"}}},
                     {"input", {{"file", run.scan}, {"unit", choiceName(run.unit)}, {"mesh", meshJson(run.mesh)}}},
                     {"settings", {{"tool_radius", run.tool_radius}, {"scallop", run.scallop_height}, {"chord_error", run.chord_error}}},
                     {"limits", limitsJson(run.limits)},
                     {"paths", paths},
                     {"warnings", run.warnings}};
  ByteFile out(file);
  out.write(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  out.close();
}

} // namespace pcl_spiral
