// SPDX-License-Identifier: BSD-3-Clause
#include "verification_json.h"
#include "diagnostic_json.h"
#include "motion_report.h"
#include "side_json.h"

#include "verify/verification_figures.h"

namespace pcl_spiral {
namespace {

using Json = nlohmann::ordered_json;

Json
figureJson(const Figure& figure)
{
  switch (figure.kind) {
  case FigureKind::Count:
    return static_cast<std::size_t>(figure.value);
  case FigureKind::Number:
    return figure.value;
  case FigureKind::Placed:
    break;
  }
  if (!figure.place)
    return nullptr;
  const Eigen::Vector3d& at = figure.place->position;
  return {{"value", figure.value}, {"position", {at.x(), at.y(), at.z()}}, {figure.by_line ? "line" : "index", figure.place->index}};
}

} // namespace

nlohmann::ordered_json
verificationJson(const Verification& v, const Vocabulary& words, const Eigen::Vector3d& shift)
{
  Json json;
  const FigureTable table = figuresOf(v);
  for (const Figure& figure : table.figures())
    if (figure.in_json)
      json[Json::json_pointer("/" + figure.key)] = figureJson(figure);
  if (v.program && v.program->motion)
    json["program"]["motion"] = motionJson(*v.program->motion);
  json["side"] = sideJson(v.side);
  json["broken_limits"] = textsOf(v.broken, words);
  json["unproven_limits"] = textsOf(v.unproven, words);
  json["seconds"] = v.seconds;
  json["warnings"] = textsOf(warningsOf(v), words);
  json["diagnostics"] = {{"broken_limits", diagnosticsJson(v.broken, words, shift)},
                         {"unproven_limits", diagnosticsJson(v.unproven, words, shift)},
                         {"warnings", diagnosticsJson(warningsOf(v), words, shift)}};
  return json;
}

} // namespace pcl_spiral
