// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/io/verification_writer.h>

#include "diagnostic_json.h"
#include "io/byte_file.h"
#include "io/setting_names.h"
#include "moved_places.h"
#include "verification_json.h"

namespace pcl_spiral {
namespace {

using Json = nlohmann::ordered_json;

/** null for a scan. */
Json
meshJson(const std::optional<JudgedMesh>& mesh)
{
  if (!mesh)
    return Json();
  const MeshReport& counts = mesh->counts;
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

std::string
verificationsJSON(const VerificationRun& asked, const std::vector<Verification>& verifications)
{
  VerificationRun run = asked;
  run.words = movedBy(run.shift, run.words);
  Json paths = Json::array();
  for (const Verification& verification : verifications) {
    Json path = {{"file", verification.path}};
    if (!verification.region.empty())
      path["region"] = verification.region;
    path.update(verificationJson(movedBy(run.shift, verification), run.words, run.shift));
    paths.push_back(path);
  }
  const Json json = {{"units", {{"length", "mm"}, {"angle", "degree"}, {"time", "s"}}},
                     {"input",
                      {{"file", run.scan},
                       {"unit", choiceName(run.unit)},
                       {"shift", {run.shift.x(), run.shift.y(), run.shift.z()}},
                       {"mesh", meshJson(run.mesh)}}},
                     {"settings",
                      {{"tool_radius", run.cutter.radius},
                       {"corner_radius", run.cutter.corner_radius},
                       {"flank_length", run.cutter.flank_length},
                       {"flank_angle", run.cutter.flank_angle},
                       {"scallop", run.scallop_height},
                       {"chord_error", run.chord_error}}},
                     {"limits", limitsJson(run.limits)},
                     {"paths", paths},
                     {"warnings", textsOf(run.warnings, run.words)},
                     {"diagnostics", diagnosticsJson(run.warnings, run.words, run.shift)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void
writeVerificationJSON(const std::string& file, const VerificationRun& run, const std::vector<Verification>& verifications)
{
  ByteFile out(file);
  out.write(verificationsJSON(run, verifications));
  out.close();
}

} // namespace pcl_spiral
