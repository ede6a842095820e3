// SPDX-License-Identifier: BSD-3-Clause
// Clean random parts: what the preparation of the surface says of steps, clusters, outliers and gaps that are not there.
#include "case_series.h"

#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/graph/impl/surface_parts.h>
#include <pcl_spiral/surface/impl/ball_reach.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <vector>

namespace pcl_spiral::acceptance {

namespace {

constexpr double most_alarms = 0.02; ///< of the scans, of each kind

std::vector<std::string>
alarmsOf(const RandomCase& made)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(made.cloud);
  scanned.setViewPoint(*made.settings.view_point);
  scanned.setStrict(false);
  scanned.setQuiet(true);
  scanned.setNumberOfThreads(1);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  if (!surface)
    return {"refused"};
  std::vector<std::string> alarms;
  if (surfaceParts(surface->graph()).parts.size() > 1)
    alarms.emplace_back("parts"); // joined only over steps or voids
  if (surface->report().offSurface() > 0)
    alarms.emplace_back("outliers");
  if (!surface->clusters().empty())
    alarms.emplace_back("clusters");
  const double tolerance = reachTolerance(surface->fit(), reach_share * made.settings.chord_error);
  if (BallReach(surface->graph(), surface->fit(), made.settings.tool_radius, tolerance).missed().count > 0)
    alarms.emplace_back("edges");
  BoundaryLoops<pcl::PointXYZ> boundary;
  boundary.setInputSurface(surface);
  boundary.setQuiet(true);
  std::vector<BoundaryLoop> loops;
  boundary.compute(loops);
  if (loops.size() > made.surface->region().loops().size())
    alarms.emplace_back("gaps");
  return alarms;
}

} // namespace

int
judgeAlarms(const Options& options)
{
  std::map<std::string, int> kinds{{"parts", 0}, {"outliers", 0}, {"clusters", 0}, {"gaps", 0}, {"edges", 0}, {"refused", 0}};
  constexpr unsigned int longest = 30; // s
  int scans = 0;
  for (std::uint64_t i = options.first; i < options.first + options.count; ++i) {
    const RandomCase made = randomCase(options.seed, i);
    if (made.outliers > 0)
      continue;
    ++scans;
    const Outcome outcome = isolated(longest, [&made]() -> Outcome {
      std::string all;
      for (const std::string& alarm : alarmsOf(made))
        all += alarm + ' ';
      return {all, ""};
    });
    for (auto& [kind, count] : kinds)
      count += outcome.kind.find(kind) != std::string::npos ? 1 : 0;
    if (!outcome.kind.empty() || !outcome.faults.empty())
      std::printf("  case %llu: %s\n    %s%s\n", static_cast<unsigned long long>(i), made.name.c_str(), outcome.kind.c_str(),
                  outcome.faults.c_str());
  }
  int broken = 0;
  std::printf("alarms, seed %llu: %d clean scans\n", static_cast<unsigned long long>(options.seed), scans);
  for (const auto& [kind, count] : kinds) {
    const bool above = count > std::max(1.0, most_alarms * scans);
    std::printf("  %5d  %s%s\n", count, kind.c_str(), above ? "  LIMIT" : "");
    broken += above ? 1 : 0;
  }
  return broken;
}

} // namespace pcl_spiral::acceptance
