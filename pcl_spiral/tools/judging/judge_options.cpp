// SPDX-License-Identifier: BSD-3-Clause
#include "judge_options.h"

#include "terminal/cutter_shape.h"
#include "terminal/idle_options.h"
#include "terminal/read_options.h"

using namespace pcl_spiral;

OptionGroup
judgedFiles(JudgeOptions& job, const std::string& files_help)
{
  OptionGroup group{
      "Files",
      {{"file", "FILE", files_help + "; --file itself can be left out", [&job](const std::string& value) { job.files.push_back(value); },
        true},
       textOption("config", "FILE", "job file in YAML with these option names; the command line has priority: --config job.yaml",
                  job.config_file),
       placeOption("view-point", view_point_help, job.settings.view_point)}};
  addOptions(group, readOptions(job.read));
  std::vector<Option> part = regionOptions(job.part, job.regions);
  for (Option& option : part)
    if (option.name == "part-at")
      option.help = "a place on the part, in the coordinates of the file, as given for the path; once for each region: --part-at 120,80,15";
    else if (option.name == "region")
      option.help = "polygon of a region, as given for the path; once for each region, which are judged one by one: --region left.txt";
    else
      option.help = "as given for the path: " + option.help;
  addOptions(group, part);
  addOptions(group, {{"clusters", "ride|leave-out",
                      "two or more points near each other that stand off the surface: the cutter must ride over them, or they are false "
                      "echoes; default ride: --clusters leave-out",
                      [&job](const std::string& value) { job.part.clusters = choiceValue<ClusterHandling>("clusters", value); }},
                     switchOption("mesh",
                                  "the first file is a mesh, .stl .obj .ply: judge by the curved surface behind its faces; without --mesh "
                                  "its vertices are a scan",
                                  job.mesh)});
  addSettings(group, settingTable(job.mesh_settings));
  return group;
}

OptionGroup
judgedCutter(JudgeOptions& job, const std::string& radius_help)
{
  OptionGroup group{"Cutter (tapered bull-nose and its special cases) and finish", cutterShapeOptions(radius_help, job.settings.cutter)};
  addSettings(group, settingTable(job.settings));
  return group;
}

void
completeJudging(JudgeOptions& job)
{
  JudgeSettings& settings = job.settings;
  if (!isGiven(job, "clusters"))
    job.part.clusters = ClusterHandling::Ride;
  require(job.part.clusters != ClusterHandling::Refuse,
          "--clusters refuse: a path is judged in any case; give ride, or leave-out for false echoes");
  requireUsed(idleOfJudging(askedNames(job.given), {job.mesh}));
  settings.flip_normals = job.mesh_settings.flip;
  const bool radius_given = isGiven(job, "tool-radius");
  require(!radius_given || settings.cutter.radius > 0.0, "--tool-radius must be above 0 mm, such as 10");
  require(!radius_given || settings.scallop_height < settings.cutter.radius,
          "--scallop must be above 0 mm and below the tool radius, such as 0.05");
  for (const char* name : {"corner-radius", "flank-length", "flank-angle"})
    require(radius_given || !isGiven(job, name),
            Diagnostic("--", std::string(name), ": no --tool-radius is given; give the radius of the cutter too"));
  if (radius_given)
    completeCutter(isGiven(job, "corner-radius"), settings.cutter);
}

void
require(bool holds, const Diagnostic& message)
{
  if (!holds)
    throw UsageError(message);
}
