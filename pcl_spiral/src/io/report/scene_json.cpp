// SPDX-License-Identifier: BSD-3-Clause
#include "scene_json.h"

#include "packed_array.h"
#include "verify/stock_cells.h"
#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

using Json = nlohmann::ordered_json;

/** What \p value gives of each frame, one component after the other. */
template <typename Value>
std::vector<double>
ofFrames(const ReportScene& scene, std::size_t size, const Value& value)
{
  std::vector<double> values;
  values.reserve(size * scene.frames.size());
  for (const SceneFrame& frame : scene.frames)
    for (std::size_t k = 0; k < size; ++k)
      values.push_back(value(frame, k));
  return values;
}

template <typename Number, typename Value>
std::vector<Number>
numbersOfFrames(const ReportScene& scene, const Value& value)
{
  std::vector<Number> numbers;
  numbers.reserve(scene.frames.size());
  for (const SceneFrame& frame : scene.frames)
    numbers.push_back(static_cast<Number>(value(frame)));
  return numbers;
}

void
addFrames(const ReportScene& scene, Json& arrays)
{
  const auto any = [&](const auto& test) { return std::any_of(scene.frames.begin(), scene.frames.end(), test); };
  arrays["time"] = packedNumbers("f32", numbersOfFrames<float>(scene, [](const SceneFrame& f) { return f.time; }));
  arrays["tip"] = packedValues(ofFrames(scene, 3, [](const SceneFrame& f, std::size_t k) { return f.tip[k]; }), 3);
  if (any([](const SceneFrame& f) { return f.contact != f.tip; }))
    arrays["contact"] = packedValues(ofFrames(scene, 3, [](const SceneFrame& f, std::size_t k) { return f.contact[k]; }), 3);
  arrays["axis"] = packedValues(ofFrames(scene, 3, [](const SceneFrame& f, std::size_t k) { return f.axis[k]; }), 3);
  arrays["length"] = packedNumbers("f32", numbersOfFrames<float>(scene, [](const SceneFrame& f) { return f.length; }));
  arrays["turn"] = packedNumbers("f32", numbersOfFrames<float>(scene, [](const SceneFrame& f) { return f.turn; }));
  arrays["move"] = packedNumbers("u8", numbersOfFrames<std::uint8_t>(scene, [](const SceneFrame& f) { return f.move; }));
  if (any([](const SceneFrame& f) { return f.feed > 0.0; }))
    arrays["feed"] = packedValues(ofFrames(scene, 1, [](const SceneFrame& f, std::size_t) { return f.feed; }), 1);
  if (any([](const SceneFrame& f) { return f.number > 0; }))
    arrays["number"] = packedNumbers("u32", numbersOfFrames<std::uint32_t>(scene, [](const SceneFrame& f) { return f.number; }));
  if (scene.rotary_letters.empty())
    return;
  std::vector<float> angles;
  for (const SceneFrame& frame : scene.frames)
    for (const double angle : {frame.angles.first, frame.angles.second})
      angles.push_back(static_cast<float>(angle * in_degrees));
  arrays["angles"] = packedNumbers("f32", angles);
}

std::vector<double>
widened(const std::vector<float>& values)
{
  return {values.begin(), values.end()};
}

void
addPart(const ScenePart& part, Json& arrays)
{
  std::vector<double> places;
  std::vector<double> normals;
  for (std::size_t i = 0; i < part.places.size(); ++i)
    for (int d = 0; d < 3; ++d) {
      places.push_back(part.places[i][d]);
      normals.push_back(part.normals[i][d]);
    }
  std::vector<std::int8_t> short_normals;
  for (const double n : normals)
    short_normals.push_back(static_cast<std::int8_t>(std::lround(127.0 * std::clamp(n, -1.0, 1.0))));
  std::vector<std::uint32_t> corners;
  for (const Triangulation::Triangle& t : part.triangles)
    corners.insert(corners.end(), t.begin(), t.end());
  arrays["places"] = packedValues(places, 3);
  arrays["normals"] = packedNumbers("i8", short_normals);
  arrays["normals"]["low"] = std::vector<double>{0.0};
  arrays["normals"]["step"] = std::vector<double>{1.0 / 127.0};
  arrays["triangles"] = packedNumbers("u32", corners);
  if (!part.stock.empty())
    arrays["stock"] = packedValues(widened(part.stock), 1);
  if (!part.deviation.empty())
    arrays["deviation"] = packedValues(widened(part.deviation), 1);
  if (!part.cut_at.empty())
    arrays["cutAt"] = packedNumbers("f32", part.cut_at);
  if (!part.first_at.empty()) {
    arrays["firstAt"] = packedNumbers("f32", part.first_at);
    arrays["firstStock"] = packedValues(widened(part.first_stock), 1);
  }
}

Json
solid(std::vector<std::array<double, 2>> profile, const char* colour, double opacity)
{
  profile.insert(profile.begin(), {0.0, profile.front()[1]});
  profile.push_back({0.0, profile.back()[1]});
  return {{"profile", profile}, {"colour", colour}, {"opacity", opacity}};
}

/** Mean distance between neighbouring passes of the path, if it covers the part. */
double
spacingOf(const ReportScene& scene)
{
  const double area = trianglesArea(scene.part.places, scene.part.triangles);
  return scene.frames.empty() ? 0.0 : area / std::max(1e-9, scene.frames.back().length);
}

/** The half profiles of cutter, shank and holder: pairs of radius and height above the tip. A beam is a thin needle. */
Json
toolSolids(const ReportScene& scene, double size)
{
  if (!(scene.cutter.radius > 0.0))
    return {solid({{0.0, 0.0}, {0.008 * size, 0.25 * size}}, "#d8362a", 0.7)};
  constexpr int pieces = 24;
  const CutterProfile cutter(scene.cutter);
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i <= pieces; ++i) {
    const double l = cutter.flatRadius() + (cutter.flankRadius() - cutter.flatRadius()) * std::sin(0.5 * pi * i / pieces);
    profile.push_back({l, cutter.height(std::min(l, cutter.flankRadius()))});
  }
  const double radius = cutter.radius();
  profile.push_back({radius, cutter.topHeight()});
  Json solids{solid(profile, "#e2a33a", 0.9)};
  double at = cutter.topHeight();
  if (scene.holder.empty())
    solids.push_back(solid({{radius, at}, {radius, cutter.cornerHeight() + shank_radii * radius}}, "#8f98a5", 0.6));
  for (const ToolSegment& segment : scene.holder) {
    solids.push_back(solid({{segment.lower_radius, at}, {segment.upper_radius, at + segment.length}}, "#6c7a90", 0.6));
    at += segment.length;
  }
  return solids;
}

Json
scaleJson(const SceneScale& scale)
{
  return scale.high > scale.low ? Json{{"low", scale.low}, {"high", scale.high}} : Json();
}

/** How many turns or passes there are. The page counts them from 1; the last turn need not be whole. */
std::size_t
turnsOf(const ReportScene& scene)
{
  constexpr double hardly_begun = 1e-3; // of a turn
  double turns = 0.0;
  for (const SceneFrame& frame : scene.frames)
    turns = std::max(turns, frame.turn);
  return static_cast<std::size_t>(scene.turn_word == "Turn" ? std::ceil(turns - hardly_begun) : std::floor(turns) + 1.0);
}

std::string
inHtml(const std::string& json)
{
  std::string text;
  text.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else if (c == '&')
      text += "\\u0026";
    else
      text += c;
  return text;
}

} // namespace

std::string
sceneJson(const ReportScene& scene)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : scene.part.places)
    box.extend(p.cast<double>());
  Json json;
  json["outward"] = {scene.outward.x(), scene.outward.y(), scene.outward.z()};
  json["spacing"] = spacingOf(scene);
  json["uncut"] = scene.uncut;
  json["scales"] = {{"stock", scaleJson(scene.stock)}, {"deviation", scaleJson(scene.deviation)}};
  json["turnWord"] = scene.turn_word;
  json["numberWord"] = scene.number_word;
  json["feedWord"] = scene.feed_word;
  json["turns"] = turnsOf(scene);
  for (const char letter : scene.rotary_letters)
    json["rotary"].push_back(std::string(1, letter));
  json["tool"] = toolSolids(scene, box.isEmpty() ? 1.0 : box.diagonal().norm());
  Json arrays;
  addPart(scene.part, arrays);
  addFrames(scene, arrays);
  json["arrays"] = std::move(arrays);
  return inHtml(json.dump());
}

} // namespace pcl_spiral
