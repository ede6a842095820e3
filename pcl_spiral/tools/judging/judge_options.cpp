// SPDX-License-Identifier: BSD-3-Clause
#include "judge_options.h"

#include "terminal/cutter_shape.h"
#include "terminal/option_table.h"
#include "terminal/option_values.h"
#include "terminal/read_options.h"
#include "terminal/scan_places.h"

#include <pcl_spiral/common/impl/thread_limit.h>

namespace po = boost::program_options;

namespace {

po::typed_value<std::string>*
value(const char* name)
{
  return po::value<std::string>()->value_name(name);
}

} // namespace

po::variables_map
readArguments(int argc, const char* const* argv, const po::options_description& options)
{
  namespace style = po::command_line_style;
  po::positional_options_description positional;
  positional.add("file", -1);
  po::variables_map given;
  try {
    po::store(po::command_line_parser(argc, argv)
                  .options(options)
                  .positional(positional)
                  .style(style::unix_style & ~style::allow_guessing & ~style::allow_sticky)
                  .run(),
              given);
  }
  catch (const po::error& error) {
    throw UsageError(pcl_spiral::Diagnostic(std::string(error.what())));
  }
  return given;
}

void
addScanOptions(po::options_description& options)
{
  const std::string units = pcl_spiral::choiceList<pcl_spiral::LengthUnit>();
  options.add_options()("units", value(units.c_str()), units_help)("origin", value("X,Y,Z"), origin_help)(
      "columns", value("NAMES"), columns_help)("skip-lines", value("N"), skip_lines_help);
}

void
addCutterOptions(po::options_description& options, const char* radius_meaning)
{
  options.add_options()("tool-radius", value("R"), radius_meaning)("corner-radius", value("r"), corner_radius_help)(
      "flank-length", value("L"), "length of the cutting flank, along the flank; default 0: --flank-length 20")(
      "flank-angle", value("A"), flank_angle_help)("scallop", value("H"),
                                                   "scallop height that the path was made for; default 0.05: --scallop 0.02")(
      "chord-error", value("E"), "chord error that the path was made for; default 0.005: --chord-error 0.002")(
      "view-point", value("X,Y,Z"), view_point_help)("flip-normals", "the cutter is on the other side of the scan or mesh");
}

void
addPartOptions(po::options_description& options)
{
  const auto values = [](const char* name) { return po::value<std::vector<std::string>>()->value_name(name); };
  options.add_options()("part-at", values("X,Y,Z"),
                        "a place on the part, in the coordinates of the file, as given for the path; once for each region: "
                        "--part-at 120,80,15")(
      "region", values("FILE"),
      "polygon of a region, as given for the path; once for each region, which are judged one by one: --region left.txt")(
      "crop", value("BOX|FILE"), "only points inside are part of the scan, as given for the path: --crop 0,200,0,150")(
      "keep-out", values("FILE"),
      "polygon whose space the cutter must not enter, as given for the path; may be given several times: --keep-out clamp.txt")(
      "clusters", value("ride|leave-out"),
      "two or more points near each other that stand off the surface: the cutter must ride over them, or they are false echoes; default "
      "ride: --clusters leave-out");
}

PartOptions
partOptions(const po::variables_map& given)
{
  PartOptions choice;
  if (given.count("crop") > 0)
    choice.crop = given["crop"].as<std::string>();
  if (given.count("keep-out") > 0)
    choice.keep_outs = given["keep-out"].as<std::vector<std::string>>();
  choice.clusters = pcl_spiral::ClusterHandling::Ride;
  if (given.count("clusters") > 0)
    choice.clusters = choiceValue<pcl_spiral::ClusterHandling>("clusters", given["clusters"].as<std::string>());
  require(choice.clusters != pcl_spiral::ClusterHandling::Refuse,
          "--clusters refuse: a path is judged in any case; give ride, or leave-out for false echoes");
  return choice;
}

RegionChoice
regionChoice(const po::variables_map& given)
{
  RegionChoice choice;
  if (given.count("part-at") > 0)
    for (const std::string& place : given["part-at"].as<std::vector<std::string>>())
      choice.places.push_back(placeValue("part-at", place));
  if (given.count("region") > 0)
    choice.polygons = given["region"].as<std::vector<std::string>>();
  return choice;
}

pcl_spiral::ReadOptions
scanOptions(const po::variables_map& given)
{
  pcl_spiral::ReadOptions read = readFindingOrigin();
  const auto text = [&](const char* name) { return given[name].as<std::string>(); };
  if (given.count("units") > 0)
    read.unit = choiceValue<pcl_spiral::LengthUnit>("units", text("units"));
  if (given.count("origin") > 0)
    setOrigin(text("origin"), read);
  if (given.count("columns") > 0)
    read.columns = listValue(text("columns"));
  if (given.count("skip-lines") > 0)
    read.skip_lines = skipLinesValue(text("skip-lines"));
  return read;
}

pcl_spiral::JudgeSettings
cutterOptions(const po::variables_map& given)
{
  pcl_spiral::JudgeSettings settings;
  settings.scallop_height = 0.05;
  settings.chord_error = 0.005;
  settings.flip_normals = given.count("flip-normals") > 0;
  const auto text = [&](const char* name) { return given[name].as<std::string>(); };
  const auto read = [&](const char* name, double& number) {
    if (given.count(name) > 0)
      number = numberValue(name, text(name));
  };
  if (given.count("view-point") > 0)
    settings.view_point = placeValue("view-point", text("view-point"));
  read("tool-radius", settings.cutter.radius);
  read("corner-radius", settings.cutter.corner_radius);
  read("flank-length", settings.cutter.flank_length);
  read("flank-angle", settings.cutter.flank_angle);
  read("scallop", settings.scallop_height);
  read("chord-error", settings.chord_error);
  if (given.count("threads") > 0) {
    OptionGroup group;
    addSettings(group, {pcl_spiral::threadsSetting(settings.threads)});
    group.options.front().set(text("threads"));
  }
  const bool radius_given = given.count("tool-radius") > 0;
  require(!radius_given || settings.cutter.radius > 0.0, "--tool-radius must be above 0 mm, such as 10");
  require(settings.scallop_height > 0.0 && (!radius_given || settings.scallop_height < settings.cutter.radius),
          "--scallop must be above 0 mm and below the tool radius, such as 0.05");
  for (const char* name : {"corner-radius", "flank-length", "flank-angle"})
    require(radius_given || given.count(name) == 0,
            pcl_spiral::Diagnostic("--", std::string(name), ": no --tool-radius is given; give the radius of the cutter too"));
  if (radius_given)
    completeCutter(given.count("corner-radius") > 0, settings.cutter);
  require(settings.chord_error > 0.0, "--chord-error must be above 0 mm, such as 0.005");
  return settings;
}

void
addMeshOptions(po::options_description& options)
{
  options.add_options()("mesh",
                        "the first file is a mesh, .stl .obj .ply: judge by the curved surface behind its faces; without --mesh its "
                        "vertices are a scan")(
      "crease-angle", value("A"),
      "mesh edges bent by more than this are creases, with figures of their own, degrees; default 30: --crease-angle 20")(
      "sample-spacing", value("S"),
      "spacing of the points where the mesh is judged, mm; default found from area and curvature: --sample-spacing 0.2");
}

std::optional<MeshChoice>
meshOptions(const po::variables_map& given)
{
  const bool mesh = given.count("mesh") > 0;
  for (const char* name : {"crease-angle", "sample-spacing"})
    require(mesh || given.count(name) == 0,
            pcl_spiral::Diagnostic("--", std::string(name), " belongs to meshes; add --mesh, or leave it out"));
  for (const char* name : {"columns", "skip-lines", "view-point", "part-at", "region", "crop", "keep-out", "clusters"})
    require(!mesh || given.count(name) == 0, pcl_spiral::Diagnostic("--", std::string(name),
                                                                    " belongs to scans; the faces of a mesh define its side: leave "
                                                                    "it out, or turn the mesh over (--flip-normals)"));
  if (!mesh)
    return std::nullopt;
  MeshChoice choice;
  choice.settings.flip = given.count("flip-normals") > 0;
  if (given.count("crease-angle") > 0)
    choice.settings.crease_angle = numberValue("crease-angle", given["crease-angle"].as<std::string>());
  if (given.count("sample-spacing") > 0)
    choice.sample_spacing = numberValue("sample-spacing", given["sample-spacing"].as<std::string>());
  require(choice.settings.crease_angle > 0.0 && choice.settings.crease_angle <= 180.0,
          "--crease-angle must be above 0, up to 180 degrees, such as 30");
  require(choice.sample_spacing >= 0.0, "--sample-spacing must be above 0 mm, or 0 for the default");
  return choice;
}

void
require(bool holds, const pcl_spiral::Diagnostic& message)
{
  if (!holds)
    throw UsageError(message);
}
