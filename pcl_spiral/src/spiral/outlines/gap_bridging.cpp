// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/gap_bridging.h>

#include "surface/gap_filling.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/graph/impl/surface_parts.h>
#include <pcl_spiral/spiral/impl/boundary_choice.h>
#include <pcl_spiral/spiral/impl/loop_check.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

namespace pcl_spiral {

template class GapBridging<pcl::PointXYZ>;
template class GapBridging<pcl::PointXYZRGB>;
template class GapBridging<pcl::PointNormal>;

namespace {

Diagnostic
warningOf(const BridgedGap& gap)
{
  if (gap.points == 0)
    return Diagnostic("{a gap in the scan} at ", Place(gap.loop.points.front()), ", ", gap.loop.length,
                      " {mm} round, is too narrow to be filled: the path runs over it without filling");
  return Diagnostic("{a gap in the scan} at ", Place(gap.centre), ", ", gap.width,
                    " {mm} wide, was bridged by a smooth patch; the points around it lie ", gap.residual,
                    " {mm} (rms) from the patch; {if it is a real hole, the path still runs over it}");
}

Eigen::Vector3d
middleOf(const BoundaryLoop& loop)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : loop.points)
    sum += p;
  return sum / static_cast<double>(loop.points.size());
}

/** Set the types of \p loops: the rim is Outer, the holes with middles nearest to the points of \p kept are Inner, others are gaps. */
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

/** Refuse a surface that falls apart once its gaps are bridged: what stands on a part hangs on it by a few triangles beside a gap. */
Status
checkHoldsTogether(const SurfaceGraph& graph)
{
  const std::vector<SurfacePart> parts = surfaceParts(graph).parts;
  if (const OtherParts others = otherParts(parts, largest_cluster); others == OtherParts::None || others == OtherParts::Clusters)
    return Status::success();
  Eigen::AlignedBox3d box;
  for (std::size_t i = 1; i < parts.size(); ++i)
    box.extend(parts[i].box);
  return {StatusCode::InvalidInput,
          Diagnostic("the surface falls apart where {gaps of the scan} are bridged: ", partsText(parts, false),
                     ". Something stands on the part there: keep the cutter out of it with a polygon that covers it, ",
                     Proposed("addKeepOut", box.min(), box.max()), " ({addKeepOut})")};
}

/** One run: the input, and which loops are the user's own. */
class Bridging {
public:
  Bridging(const std::vector<BoundaryLoop>& loops, const HoleOptions& options, BridgedSurface& bridged)
  : loops_(loops), options_(options), own_(loops.size(), 0), bridged_(bridged)
  {}

  /** Loops that are not found on \p surface are the user's own. */
  Status findOwn(const Surface& surface, const std::function<bool(double)>& progress)
  {
    own_.assign(loops_.size(), 1);
    for (std::size_t i = 0; i < loops_.size(); ++i)
      if (const Status status = checkLoopShape(loops_[i], i); !status.ok())
        return status;
    if (loops_.size() < 2) // nothing to bridge or to find again
      return Status::success();
    BoundaryOptions options;
    options.min_hole_width = options_.hole_size;
    options.progress = progress;
    std::vector<BoundaryLoop> found;
    if (const Status status = findBoundaryLoops(surface, options, found); status.code() == StatusCode::Cancelled)
      return status;
    for (std::size_t i = 0; i < loops_.size(); ++i)
      own_[i] = std::none_of(found.begin(), found.end(),
                             [&](const BoundaryLoop& loop) { return loop.curve == loops_[i].curve && loop.points == loops_[i].points; });
    return Status::success();
  }

  /** Make points for each loop that bounds a gap. */
  Status fill(const Surface& surface, std::vector<Eigen::Vector3f>& bridges)
  {
    if (const Status status = choose(); !status.ok())
      return status;
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const BoundaryLoop& loop = loops_[i];
      if (loop.type == LoopType::Outer || std::find(choice_.kept.begin(), choice_.kept.end(), &loop) != choice_.kept.end())
        continue;
      if (const Status status = checkGap(surface.graph(), i); !status.ok())
        return status;
      if (options_.gaps == GapHandling::Refuse)
        return {StatusCode::InvalidInput, Diagnostic("the {scan} has a gap at ", Place(loop.points.front()), ", ", loop.length,
                                                     " {mm} round: {scan it again}, or allow gaps to be bridged ({setGapHandling})")};
      const GapFill fill = fillGap(surface.graph(), loop.points);
      bridged_.gaps.push_back({loop, fill.points.size(), fill.centre, fill.width, fill.residual});
      bridged_.gaps.back().loop.type = LoopType::ScanGap;
      bridged_.warnings.push_back(warningOf(bridged_.gaps.back()));
      bridges.insert(bridges.end(), fill.points.begin(), fill.points.end());
    }
    return Status::success();
  }

  /** No points were added to the surface. */
  void keepAll()
  {
    bridged_.loops = loops_;
    nameLoops(keptMiddles(), bridged_.loops);
  }

  /** Loops of the surface with the added points: the user's own as they are, others found again. */
  Status findAgain(const std::function<bool(double)>& progress)
  {
    const bool own_rim = isOwn(choice_.rim);
    const bool find_holes = std::any_of(choice_.kept.begin(), choice_.kept.end(), [this](const auto* hole) { return !isOwn(hole); });
    std::vector<BoundaryLoop>& loops = bridged_.loops;
    if (!own_rim || find_holes) {
      BoundaryOptions options;
      options.min_hole_width = options_.hole_size;
      options.progress = progress;
      if (const Status status = checkHoldsTogether(bridged_.surface->graph()); !status.ok())
        return status;
      if (const Status status = findBoundaryLoops(*bridged_.surface, options, loops); !status.ok())
        return status;
      if (const Status status = nameFound(); !status.ok())
        return status;
    }
    else
      for (const BridgedGap& gap : bridged_.gaps)
        if (gap.points == 0)
          loops.push_back(gap.loop);
    if (own_rim) { // replaces the rim that was found
      loops.erase(std::remove_if(loops.begin(), loops.end(), [](const auto& l) { return l.type == LoopType::Outer; }), loops.end());
      loops.insert(loops.begin(), *choice_.rim);
    }
    for (const BoundaryLoop* hole : choice_.kept)
      if (isOwn(hole)) {
        loops.push_back(*hole);
        loops.back().type = LoopType::Inner;
      }
    return Status::success();
  }

  /** Check the user's own boundaries on the bridged surface: they may lead over a gap. */
  Status checkBoundaries() const
  {
    std::vector<const BoundaryLoop*> boundaries = choice_.kept;
    boundaries.insert(boundaries.begin(), choice_.rim);
    for (const BoundaryLoop* loop : boundaries)
      if (isOwn(loop))
        if (const Status status = checkLoop(bridged_.surface->graph(), *loop, indexOf(loop)); !status.ok())
          return status;
    return Status::success();
  }

private:
  /** Choose the holes that stay. */
  Status choose()
  {
    const bool over = options_.holes == HoleHandling::Over && options_.mode == BoundaryMode::Automatic;
    if (const Status status = chooseBoundaries(loops_, over ? BoundaryMode::OneBoundary : options_.mode, choice_); !status.ok())
      return status;
    for (const BoundaryLoop& loop : loops_)
      if (loop.type == LoopType::Inner && options_.holes == HoleHandling::Refuse)
        return {StatusCode::InvalidInput, Diagnostic("the part has a hole at ", Place(middleOf(loop)), ", ", loop.length,
                                                     " {mm} round, but holes are refused: let the path run round holes or over them "
                                                     "({setHoleHandling})")};
    return Status::success();
  }

  std::size_t indexOf(const BoundaryLoop* loop) const { return static_cast<std::size_t>(loop - loops_.data()); }
  bool isOwn(const BoundaryLoop* loop) const { return loop && own_[indexOf(loop)] != 0; }
  Polyline keptMiddles() const
  {
    Polyline middles;
    for (const BoundaryLoop* hole : choice_.kept)
      middles.push_back(middleOf(*hole));
    return middles;
  }
  /** Set the types of the loops found again. Those at the user's own holes are left out, because the own ones replace them. */
  Status nameFound()
  {
    std::vector<BoundaryLoop>& loops = bridged_.loops;
    nameLoops(keptMiddles(), loops);
    for (const BoundaryLoop* hole : choice_.kept) {
      const Eigen::Vector3d middle = middleOf(*hole);
      auto nearest = loops.end();
      for (auto loop = loops.begin(); loop != loops.end(); ++loop)
        if (loop->type == LoopType::Inner &&
            (nearest == loops.end() || (middleOf(*loop) - middle).norm() < (middleOf(*nearest) - middle).norm()))
          nearest = loop;
      if (nearest == loops.end() && !isOwn(hole))
        return {StatusCode::Failed, Diagnostic("the hole about ", Place(middle),
                                               ", a boundary of the part, was lost when gaps "
                                               "were bridged: refuse gaps to see them ({setGapHandling})")};
      if (nearest != loops.end() && isOwn(hole))
        loops.erase(nearest);
    }
    return Status::success();
  }

  /** Refuse loop \p i if it is the user's own and not a gap of this surface. */
  Status checkGap(const SurfaceGraph& graph, std::size_t i) const
  {
    if (!own_[i])
      return Status::success();
    if (const Status status = checkLoop(graph, loops_[i], i); !status.ok())
      return status;
    if (const std::size_t inside = pointsInside(graph, loops_[i].points); inside > 0)
      return {StatusCode::InvalidInput,
              Diagnostic("loop ", i, " at ", Place(loops_[i].points.front()), " is to be bridged, but ", inside,
                         " points of the surface lie inside it: give loops of the same cloud, or none to have them found")};
    return Status::success();
  }

  const std::vector<BoundaryLoop>& loops_;
  HoleOptions options_;
  std::vector<std::uint8_t> own_; ///< a flag a loop
  BridgedSurface& bridged_;
  BoundaryChoice choice_;
};

Status
bridge(Surface::ConstPtr surface, const std::vector<BoundaryLoop>& loops, const HoleOptions& options, const ProgressCallback& progress,
       LoopOrigin origin, BridgedSurface& bridged)
{
  Bridging bridging(loops, options, bridged);
  const double begin = origin == LoopOrigin::Given ? 0.5 : 0.0; // of finding loops again
  if (origin == LoopOrigin::Given)
    if (const Status status = bridging.findOwn(*surface, partOf(progress, 0.0, begin, "boundaries")); !status.ok())
      return status;
  std::vector<Eigen::Vector3f> bridges;
  if (const Status status = bridging.fill(*surface, bridges); !status.ok())
    return status;
  if (bridges.empty()) {
    bridged.surface = std::move(surface);
    bridging.keepAll();
    return bridging.checkBoundaries();
  }
  if (const Status status = addPoints(std::move(surface), bridges, bridged.surface); !status.ok())
    return status;
  if (const Status status = bridging.findAgain(partOf(progress, begin, 1.0, "boundaries")); !status.ok())
    return status;
  return bridging.checkBoundaries();
}

} // namespace

Status
bridgeGaps(Surface::ConstPtr surface, const std::vector<BoundaryLoop>& loops, const HoleOptions& options, const ProgressCallback& progress,
           BridgedSurface& bridged, LoopOrigin origin)
{
  bridged = BridgedSurface();
  const Status status = bridge(std::move(surface), loops, options, progress, origin, bridged);
  if (!status.ok())
    bridged = BridgedSurface();
  return status;
}

} // namespace pcl_spiral
