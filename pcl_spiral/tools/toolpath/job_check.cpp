// SPDX-License-Identifier: BSD-3-Clause
#include "job_check.h"
#include "judging/stock_option.h"
#include "program/holder_options.h"
#include "program/program_check.h"
#include "terminal/file_names.h"
#include "terminal/idle_options.h"
#include "terminal/option_values.h"

#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/spiral/impl/settings_check.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fs = std::filesystem;

namespace {

void
requireGiven(const Job& job, const std::string& option, const pcl_spiral::Diagnostic& remedy)
{
  if (job.given.count(option) == 0)
    throw UsageError(pcl_spiral::Diagnostic("no --", option, " is given; ", remedy));
}

void
checkCutter(const Job& job)
{
  const pcl_spiral::SpiralSettings& s = job.settings;
  requireGiven(job, "tool-radius", "give the radius of the ball cutter in mm, such as --tool-radius 10");
  requireGiven(job, "scallop", "give the height of the ridge left between turns in mm, such as --scallop 0.05");
  for (const auto& [option, value] : {std::pair("scallop", s.scallop_height), std::pair("chord-error", s.chord_error)})
    requireOption(value < s.tool_radius, option, value,
                  pcl_spiral::Diagnostic("must be below the tool radius, which is ", pcl_spiral::SixDigits(s.tool_radius), " mm"));
  if (const pcl_spiral::Status status = pcl_spiral::checkSettings(s); !status.ok())
    throw UsageError(status.diagnostic());
}

/** Checks --mesh. */
void
checkMesh(const Job& job)
{
  if (!job.mesh)
    return;
  const auto& known = pcl_spiral::meshExtensions();
  if (const std::string extension = extensionOf(job.scan);
      !extension.empty() && std::find(known.begin(), known.end(), extension) == known.end())
    throw UsageError(pcl_spiral::Diagnostic(job.scan, ": --mesh reads .stl .obj and .ply, and '", extension,
                                            "' holds no faces; for points leave --mesh out"));
  requireOption(job.sample_spacing >= 0.0, "sample-spacing", job.sample_spacing, "must be above 0 mm, or 0 to find it from the mesh");
}

bool
isWritten(const std::string& file)
{
  const std::string extension = extensionOf(file);
  const auto& known = pcl_spiral::toolpathExtensions();
  return isProgram(file) || isExchange(file) || extension == ".json" || extension == ".png" || extension == ".html" ||
         std::find(known.begin(), known.end(), extension) != known.end();
}

void
checkOutputs(const Job& job)
{
  if (job.outputs.empty())
    throw UsageError("no output is given; give at least one, such as -o part.csv");
  for (const std::string& file : job.outputs)
    if (!isWritten(file))
      throw UsageError(
          pcl_spiral::Diagnostic("-o ", file, ": extension '", extensionOf(file),
                                 "' is not known; use .csv .pcd .ply .vtp .ngc .nc .mpf .h .apt .cls .yaml .json .html or .png"));
  if (const std::string extension = extensionOf(job.reach);
      !job.reach.empty() && extension != ".csv" && extension != ".pcd" && extension != ".ply" && extension != ".png")
    throw UsageError(pcl_spiral::Diagnostic(
        "--reach ", job.reach,
        ": the map of reach is a .csv, .pcd or .ply file, or a picture, .png; give one of these, such as reach.ply"));
  checkStockFiles(job.stock);
  const std::vector<std::string> files = filesOf(job);
  for (std::size_t i = 0; i < files.size(); ++i) {
    requireNoInput(files[i], {{"the scan", job.scan},
                              {"the raw scan", job.raw_scan},
                              {"the machine's file", job.program.machine_file},
                              {"the job file", job.config_file}});
    requireNoInput(files[i], polygonFiles(job.part, job.regions));
    if (std::find(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(i), files[i]) !=
        files.begin() + static_cast<std::ptrdiff_t>(i))
      throw UsageError(pcl_spiral::Diagnostic("-o ", files[i], ": is given twice"));
  }
}

/** What one run of several regions cannot do. */
void
checkRegions(const Job& job)
{
  if (!job.regions.several())
    return;
  if (job.given.count("center") > 0)
    throw UsageError("--center belongs to one region, and several are given (--part-at, --region); leave it out, or make one run a region");
  for (const std::string& output : job.outputs)
    if (job.verify && extensionOf(output) == ".png")
      throw UsageError(
          pcl_spiral::Diagnostic("-o ", output,
                                 ": with --verify it shows one region, and several are given (--part-at, --region); write .html, "
                                 "or leave --verify and its limits out"));
}

} // namespace

std::vector<PictureName>
picturesOf(const Job& job)
{
  std::vector<PictureName> pictures{{PictureKind::Spiral, ""}, {PictureKind::Lines, "_lines"}};
  if (hasProgram(job.program, job.outputs))
    pictures.push_back({PictureKind::Rotary, "_rotary"});
  if (job.verify)
    pictures.insert(pictures.end(),
                    {{PictureKind::Deviation, "_deviation"}, {PictureKind::Stock, "_stock"}, {PictureKind::Histogram, "_histogram"}});
  return pictures;
}

std::vector<std::string>
filesOf(const Job& job)
{
  std::vector<std::string> files;
  for (const std::string& output : job.outputs)
    if (extensionOf(output) == ".png")
      for (const PictureName& picture : picturesOf(job))
        files.push_back(besideName(output, picture.suffix));
    else
      files.push_back(output);
  if (!job.reach.empty())
    files.push_back(job.reach);
  files.insert(files.end(), job.stock.begin(), job.stock.end());
  return files;
}

void
checkJob(const Job& job)
{
  if (job.scan.empty())
    throw UsageError("no scan is given; give one, such as part.pcd");
  requireUsed(idleSetting(askedNames(job.given), job.settings, {job.mesh, !job.holder.empty(), true, job.ball_closing}));
  checkCutter(job);
  checkMesh(job);
  checkOutputs(job);
  checkRegions(job);
  checkProgram(job.program, job.outputs, job.given);
  checkHolder(job.holder, job.holder_clearance, job.flank_length);
  if (job.given.count("accept-collisions") > 0 && job.holder.empty() && !job.regions.several() && !hasLeads(job.program, job.outputs))
    throw UsageError("--accept-collisions: no --holder is given, and no output is a program, CLDATA or robot frames, with leads that are "
                     "checked; leave it out");
}
