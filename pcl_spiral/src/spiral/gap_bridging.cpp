#include <pcl_spiral/spiral/gap_bridging.h>

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/surface/gap_filling.h>
#include <pcl_spiral/toolpath/boundary_choice.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl_spiral {

template class GapBridging<pcl::PointXYZ>;
template class GapBridging<pcl::PointXYZRGB>;
template class GapBridging<pcl::PointNormal>;

namespace {

std::string
warningOf(const BridgedGap& gap)
{
  if (gap.points == 0)
    return textOf("a gap in the scan at ", placeText(gap.loop.points.front()), ", ", gap.loop.length,
                  " mm round, is too narrow to be filled: the path runs over it as it is");
  return textOf("a gap in the scan at ", placeText(gap.centre), ", ", gap.width,
                " mm wide, was bridged by a smooth patch; the points about it lie ", gap.residual,
                " mm (rms) from it; a real hole there is ridden over like the rest");
}

Eigen::Vector3d
middleOf(const BoundaryLoop& loop)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : loop.points)
    sum += p;
  return sum / static_cast<double>(loop.points.size());
}

/** Of \p loops the rim is Outer, the holes whose middles are nearest to those \p kept are Inner, all others are gaps. */
void
nameLoops(const Polyline& kept, std::vector<BoundaryLoop>& loops)
{
  for (BoundaryLoop& loop : loops)
    if (loop.type != LoopType::Outer)
      loop.type = LoopType::ScanGap;
  for (const Eigen::Vector3d& middle : kept) {
    BoundaryLoop* nearest = nullptr;
    double least = std::numeric_limits<double>::max();
    for (BoundaryLoop& loop : loops)
      if (loop.type == LoopType::ScanGap && (middleOf(loop) - middle).norm() < least) {
        least = (middleOf(loop) - middle).norm();
        nearest = &loop;
      }
    if (nearest)
      nearest->type = LoopType::Inner;
  }
}

} // namespace

Status
bridgeGaps(Surface::ConstPtr surface, const std::vector<BoundaryLoop>& loops, BoundaryMode mode, GapHandling handling,
           const ProgressCallback& progress, BridgedSurface& bridged)
{
  bridged = BridgedSurface();
  BoundaryChoice choice;
  if (const Status status = chooseBoundaries(loops, mode, choice); !status.ok())
    return status;
  Polyline kept;
  for (const BoundaryLoop* hole : choice.kept)
    kept.push_back(middleOf(*hole));
  std::vector<Eigen::Vector3f> bridges;
  for (const BoundaryLoop& loop : loops) {
    if (loop.type == LoopType::Outer || std::find(choice.kept.begin(), choice.kept.end(), &loop) != choice.kept.end())
      continue;
    if (handling == GapHandling::Refuse)
      return {StatusCode::InvalidInput, textOf("the scan has a gap at ", placeText(loop.points.front()), ", ", loop.length,
                                               " mm round: scan it again, or allow gaps to be bridged (setGapHandling)")};
    const GapFill fill = fillGap(surface->graph(), loop.points);
    bridged.gaps.push_back({loop, fill.points.size(), fill.centre, fill.width, fill.residual});
    bridged.gaps.back().loop.type = LoopType::ScanGap;
    bridged.warnings.push_back(warningOf(bridged.gaps.back()));
    bridges.insert(bridges.end(), fill.points.begin(), fill.points.end());
  }
  if (bridges.empty()) {
    bridged.surface = std::move(surface);
    bridged.loops = loops;
    nameLoops(kept, bridged.loops);
    return Status::success();
  }
  if (const Status status = addPoints(std::move(surface), bridges, bridged.surface); !status.ok())
    return status;
  BoundaryOptions options;
  options.progress = partOf(progress, 0.0, 1.0, "boundaries");
  if (const Status status = findBoundaryLoops(*bridged.surface, options, bridged.loops); !status.ok())
    return status;
  nameLoops(kept, bridged.loops);
  const auto left = std::count_if(bridged.loops.begin(), bridged.loops.end(),
                                  [](const BoundaryLoop& loop) { return loop.type == LoopType::Inner; });
  if (static_cast<std::size_t>(left) < kept.size())
    return {StatusCode::Failed, textOf("the hole about ", placeText(kept[left]), ", a boundary of the part, was lost when gaps "
                                       "were bridged: refuse gaps to see them (setGapHandling)")};
  return Status::success();
}

} // namespace pcl_spiral
