// SPDX-License-Identifier: BSD-3-Clause
#include "planning/region_passes.h"

#include "verify/program_path.h"
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_voters = 1000; // of a pass that are looked at

/** Feed moves between rapids or links: the block before the first, and the last. */
struct FeedRun {
  std::size_t before = 0, last = 0;
};

std::vector<FeedRun>
feedRuns(const MachineProgram& program)
{
  std::vector<FeedRun> runs;
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    if (!mayCut(program.blocks[i]))
      continue;
    if (i == 1 || !mayCut(program.blocks[i - 1]))
      runs.push_back({i - 1, i});
    runs.back().last = i;
  }
  return runs;
}

} // namespace

RegionPasses::RegionPasses(const std::vector<JudgedPart>& parts)
{
  for (const JudgedPart& part : parts) {
    const Surface& surface = part.reference->scanned();
    std::vector<Eigen::Vector3f> points;
    for (std::size_t i = 0; i < surface.size(); ++i)
      points.push_back(surface.position(i).cast<float>());
    points_.push_back(std::make_unique<PointBlocks>(std::move(points)));
  }
}

std::size_t
RegionPasses::regionOf(const std::vector<Eigen::Vector3d>& places) const
{
  std::vector<std::size_t> votes(points_.size(), 0);
  const std::size_t step = places.size() / most_voters + 1;
  for (std::size_t i = 0; i < places.size(); i += step) {
    double least = std::numeric_limits<double>::max();
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const double distance = (points_[k]->position(points_[k]->nearest(places[i])) - places[i]).squaredNorm();
      if (distance < least) {
        least = distance;
        nearest = k;
      }
    }
    ++votes[nearest];
  }
  return static_cast<std::size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

std::vector<std::size_t>
RegionPasses::pointsOf(std::size_t region, const pcl::PointCloud<ToolpathPoint>& path) const
{
  std::vector<std::size_t> own;
  for (const PassRange& pass : passRanges(passBegins(path), path.size())) {
    std::vector<Eigen::Vector3d> places;
    for (std::size_t i = pass.begin; i < pass.end; ++i)
      places.push_back(path[i].getVector3fMap().cast<double>());
    if (regionOf(places) == region)
      for (std::size_t i = pass.begin; i < pass.end; ++i)
        own.push_back(i);
  }
  return own;
}

std::vector<std::size_t>
RegionPasses::blocksOf(std::size_t region, const MachineProgram& program) const
{
  std::vector<std::size_t> blocks;
  for (const FeedRun& run : feedRuns(program)) {
    std::vector<Eigen::Vector3d> tips;
    for (std::size_t i = run.before; i <= run.last; ++i)
      tips.push_back(program.blocks[i].tip);
    if (regionOf(tips) == region)
      for (std::size_t i = run.before; i <= run.last; ++i)
        blocks.push_back(i);
  }
  return blocks;
}

} // namespace pcl_spiral
