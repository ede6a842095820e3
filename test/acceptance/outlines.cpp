// SPDX-License-Identifier: BSD-3-Clause
#include "case_series.h"
#include "method_name.h"
#include "outline_line.h"
#include "outline_picture.h"

#include "support/sampling.h"

#include <pcl/console/print.h>

#include <chrono>
#include <cstdio>
#include <sstream>

namespace pcl_spiral::acceptance {

namespace {

constexpr unsigned int longest = 1800; ///< s of processor time for a row

bool
isWanted(const std::string& name, const std::string& only)
{
  std::istringstream names(only);
  for (std::string wanted; std::getline(names, wanted, ',');)
    if (wanted == name)
      return true;
  return only.empty();
}

/** The path over the cloud of a row, and its report. */
Run
planned(const OutlineCloud& cloud, const Options& options, const test::JudgeSettings& judge)
{
  Generator generator;
  generator.setInputCloud(test::toCloud(cloud.points));
  generator.setToolRadius(judge.tool_radius);
  generator.setScallopHeight(judge.scallop_height);
  generator.setMethod(*methodNamed(options.method));
  generator.setOneWay(options.one_way);
  generator.setNumberOfThreads(static_cast<unsigned int>(options.threads));
  Run made;
  const auto from = std::chrono::steady_clock::now();
  generator.compute(made.path);
  made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
  made.report = generator.getReport();
  made.status = generator.getStatus();
  return made;
}

std::vector<Polyline>
curves(const SpiralReport& report)
{
  std::vector<Polyline> loops;
  for (const BoundaryLoop& loop : report.loops)
    loops.push_back(loop.curve.empty() ? loop.points : loop.curve);
  return loops;
}

/** Prints the places of all figures, the boundaries and the planner's warnings. Flushes, because the process ends without a
 * flush. */
void
printPlaces(const OutlineRow& row, const SpiralReport& report, const OutlineLine& line)
{
  std::printf("  places on %s:\n%s", row.name.c_str(), line.places.c_str());
  for (const BoundaryLoop& loop : report.loops)
    std::printf("    boundary: %s, %.1f mm, %zu corners\n",
                loop.type == LoopType::Outer   ? "rim"
                : loop.type == LoopType::Inner ? "hole"
                                               : "gap",
                loop.length, loop.corners.size());
  for (const pcl_spiral::Diagnostic& warning : report.warnings)
    std::printf("    warning: %s\n", warning.text().c_str());
  std::fflush(stdout);
}

/** Writes path and picture of a row; returns the reason if they cannot be written. */
std::string
drawn(const OutlineRow& row, const Options& options, const OutlineCloud& cloud, const test::CheckedPath& path,
      const test::JudgedReport& figures)
{
  if (options.picture.empty())
    return "";
  const std::string base = options.picture + "/" + row.name + "_" + options.method;
  const bool written = writePath(base + ".csv", path) && writePicture(base + ".png", *cloud.part, path, figures, options.scallop);
  return written ? "" : "    cannot write " + base + ".csv and .png: does the folder exist?\n";
}

/** Faults of the path over a gap of the scan: points over it, at least a spacing inside, that are not marked. */
std::string
gapFaults(const OutlineCloud& cloud, const Path& path)
{
  if (cloud.gap.empty())
    return "";
  const test::Region gap({cloud.gap});
  Polyline rim;
  for (const Eigen::Vector2d& u : cloud.gap)
    rim.push_back(cloud.part->lift(u));
  const test::MoveTree tree(rim);
  std::size_t over = 0, unmarked = 0;
  for (const ToolpathPoint& p : path) {
    const Eigen::Vector3d x = p.getVector3fMap().cast<double>();
    if (!gap.contains(cloud.part->chart(x)) || tree.nearest(x).first < cloud.spacing)
      continue;
    ++over;
    unmarked += p.over_gap == 0 ? 1 : 0;
  }
  return unmarked == 0 ? ""
                       : "    " + std::to_string(unmarked) + " of " + std::to_string(over) +
                             " path points over the gap, a spacing in, are not marked\n";
}

Outcome
outcomeOf(const OutlineRow& row, const Options& options)
{
  test::JudgeSettings settings;
  settings.tool_radius = 5.0;
  settings.scallop_height = options.scallop;
  settings.threads = options.threads;
  settings.seed = options.seed + 77;
  const double pitch = test::exactStepOver(settings.tool_radius, settings.scallop_height, 0.0);
  const OutlineCloud cloud = outlineCloud(row, options, pitch);
  settings.spacing = cloud.spacing;
  settings.gap = cloud.gap;
  const Run made = planned(cloud, options, settings);
  char name[40];
  std::snprintf(name, sizeof name, "%-16s", row.name.c_str());
  if (!made.status.ok() || made.path.size() < 3)
    return {name + std::string(" no path"), "    " + made.status.message() + "\n"};
  const test::CheckedPath path = test::fromToolpath(made.path);
  const auto from = std::chrono::steady_clock::now();
  const test::JudgedReport figures = test::judgedPath(*cloud.part, curves(made.report), path, settings);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - from;
  const OutlineLine line = outlineLine(row, figures, settings);
  char end[120];
  std::snprintf(end, sizeof end, ", %zu points in, %zu out, planned in %.1f s, judged in %.1f s%s", cloud.points.size(), path.size(),
                made.seconds, took.count(),
                cloud.gap.empty()  ? ""
                : figures.over_gap ? ", over the gap"
                                   : ", round the gap");
  if (options.places)
    printPlaces(row, made.report, line);
  return {line.line + end, line.broken + gapFaults(cloud, made.path) + drawn(row, options, cloud, path, figures)};
}

} // namespace

int
judgeOutlines(const Options& options)
{
  if (!isMethod(options.method))
    return 1;
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  std::printf("outlines, method %s, R 5, h %g, seed %llu, variation %llu, size %g\n%s\n", options.method.c_str(), options.scallop,
              static_cast<unsigned long long>(options.seed), static_cast<unsigned long long>(options.variation), options.size,
              outlineHeading().c_str());
  int judged = 0, broken = 0;
  for (const OutlineRow& row : outlineRows()) {
    if (!isWanted(row.name, options.only))
      continue;
    const Outcome outcome = isolated(longest, [&] { return outcomeOf(row, options); });
    const bool came_back = outcome.kind.compare(0, row.name.size(), row.name) == 0;
    std::printf("%s%s\n%s", came_back ? "" : (row.name + ": ").c_str(), outcome.kind.c_str(), outcome.faults.c_str());
    if (!came_back)
      std::printf("\n");
    std::fflush(stdout);
    ++judged;
    broken += outcome.faults.empty() ? 0 : 1;
  }
  std::printf("%d of %d outlines within every limit\n", judged - broken, judged);
  return judged > 0 ? broken : 1;
}

} // namespace pcl_spiral::acceptance
