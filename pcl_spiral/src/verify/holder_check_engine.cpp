// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/holder_check_engine.h>

#include "core/angle_between.h"
#include "cutter/mesh_collision.h"
#include "drive/drive_kinds.h"

#include <pcl_spiral/cutter/impl/holder_collision.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr double least_step = 0.1; // mm between two places looked at
constexpr int most_halvings = 16;
constexpr std::size_t moves_together = 256; // moves looked at together
constexpr std::size_t batch = 64;           // chunks between two reports of progress

class PointObstacles {
public:
  explicit PointObstacles(const PointBlocks& points) : points_(points) {}

  const Box& box() const { return points_.box(); }
  bool mayCollide(const HolderProfile& holder, const AxisFrame& frame, const ToolSway& sway, double tolerance) const
  {
    return pcl_spiral::mayCollide(points_, holder, frame, sway, tolerance);
  }
  HolderCollision deepest(const HolderProfile& holder, const AxisFrame& frame, double tolerance) const
  {
    return findCollision(points_, holder, frame, 0.0, tolerance);
  }

private:
  const PointBlocks& points_;
};

class FaceObstacles {
public:
  FaceObstacles(const SurfaceMesh& mesh, double tolerance) : faces_(facesOf(mesh)), sag_(std::min(finest, fine_share * tolerance)) {}

  const Box& box() const { return faces_.boxes().box(faces_.boxes().root()); }
  bool mayCollide(const HolderProfile& holder, const AxisFrame& frame, const ToolSway& sway, double tolerance) const
  {
    return pcl_spiral::mayCollide(faces_, holder, frame, sway, tolerance, sag_);
  }
  HolderCollision deepest(const HolderProfile& holder, const AxisFrame& frame, double tolerance) const
  {
    return findCollision(faces_, holder, frame, 0.0, tolerance, sag_);
  }

private:
  static constexpr double finest = 5e-4, fine_share = 0.05; // of the faces off the curved surface: mm, and of the tolerance
  PatchTree faces_;
  double sag_;
};

/** How far the tool is at one of the poses from where it is at the other. */
ToolSway
swayBetween(const ToolPose& a, const ToolPose& b)
{
  return {(b.tip - a.tip).norm(), angleBetween(a.axis, b.axis)};
}

ToolSway
larger(const ToolSway& a, const ToolSway& b)
{
  return {std::max(a.tip, b.tip), std::max(a.turn, b.turn)};
}

/** Moves of one run. */
struct MoveRange {
  const ToolPoses* poses = nullptr;
  const std::size_t* moves = nullptr; ///< of each pose
  std::size_t begin = 0, end = 0;     ///< poses
};

template <typename Obstacles>
class PathSearch {
public:
  PathSearch(const Obstacles& obstacles, const UpperTool& tool, double tolerance)
  : obstacles_(obstacles), tool_(tool), tolerance_(tolerance), step_(std::max(least_step, tolerance)),
    reach_(std::hypot(tool.top(), std::max(tool.shank.radius(), tool.holder.radius())))
  {}

  /** Adds the collisions on the moves between the poses \p begin and \p end of \p range. */
  void look(const MoveRange& range, std::size_t begin, std::size_t end, std::vector<LeadCollision>& found) const
  {
    const std::size_t middle = begin + (end - begin) / 2;
    ToolSway sway;
    for (std::size_t i = begin; i <= end; ++i)
      sway = larger(sway, swayBetween((*range.poses)[middle], (*range.poses)[i]));
    if (!mayMeet((*range.poses)[middle], sway))
      return;
    if (end - begin > 1) {
      look(range, begin, middle, found);
      look(range, middle, end, found);
      return;
    }
    const LeadCollision deepest = deepestOn((*range.poses)[begin], (*range.poses)[end], begin == 0);
    if (deepest.depth > 0.0) {
      found.push_back(deepest);
      found.back().block = range.moves[end];
      found.back().section = BlockSection::Cut;
    }
  }

private:
  /** On one move, which begins a run if \p first: its beginning is then looked at, too. */
  LeadCollision deepestOn(const ToolPose& from, const ToolPose& to, bool first) const
  {
    LeadCollision deepest;
    if (first)
      lookAt(from, deepest);
    lookAt(to, deepest);
    if (!(deepest.depth > 0.0))
      lookBetween(from, to, 0.0, from, 1.0, to, 0, deepest);
    return deepest;
  }

  /** The way between two places that are free, until something is found. */
  void lookBetween(const ToolPose& from, const ToolPose& to, double a, const ToolPose& at_a, double b, const ToolPose& at_b, int halvings,
                   LeadCollision& deepest) const
  {
    const double reach = std::min(reach_, farthestCorner(obstacles_.box(), at_a.tip));
    if (deepest.depth > 0.0 || halvings == most_halvings || swayBetween(at_a, at_b).at(reach) <= step_)
      return;
    const double middle = 0.5 * (a + b);
    const ToolPose at_middle = between(from, to, middle);
    if (!mayMeet(at_middle, larger(swayBetween(at_middle, at_a), swayBetween(at_middle, at_b))))
      return;
    lookAt(at_middle, deepest);
    lookBetween(from, to, a, at_a, middle, at_middle, halvings + 1, deepest);
    lookBetween(from, to, middle, at_middle, b, at_b, halvings + 1, deepest);
  }

  bool mayMeet(const ToolPose& pose, const ToolSway& sway) const
  {
    const AxisFrame frame(pose.tip, pose.axis);
    return obstacles_.mayCollide(tool_.shank, frame, sway, tolerance_) || obstacles_.mayCollide(tool_.holder, frame, sway, tolerance_);
  }

  void lookAt(const ToolPose& pose, LeadCollision& deepest) const
  {
    const AxisFrame frame(pose.tip, pose.axis);
    for (const ToolPart part : {ToolPart::Shank, ToolPart::Holder}) {
      const HolderProfile& profile = part == ToolPart::Shank ? tool_.shank : tool_.holder;
      const HolderCollision met = obstacles_.deepest(profile, frame, std::max(tolerance_, deepest.depth));
      if (!met.found())
        continue;
      deepest.part = part;
      deepest.segment = part == ToolPart::Holder ? met.segment : -1;
      deepest.depth = met.depth;
      deepest.place = met.place;
      deepest.tip = pose.tip;
    }
  }

  const Obstacles& obstacles_;
  const UpperTool& tool_;
  double tolerance_, step_, reach_;
};

/** All moves in ranges of one moves_together. */
std::vector<MoveRange>
chunksOf(const CutRuns& cut)
{
  std::vector<MoveRange> ranges;
  const std::size_t* moves = cut.moves.data();
  for (const ToolPoses& poses : cut.runs) {
    for (std::size_t begin = 0; begin + 1 < poses.size(); begin += moves_together)
      ranges.push_back({&poses, moves, begin, std::min(begin + moves_together, poses.size() - 1)});
    moves += poses.size();
  }
  return ranges;
}

template <typename Obstacles>
Status
search(const Obstacles& obstacles, const UpperTool& tool, const CutRuns& runs, double tolerance, const ProgressCallback& progress,
       LeadReport& figures)
{
  const PathSearch<Obstacles> path(obstacles, tool, tolerance);
  const std::vector<MoveRange> ranges = chunksOf(runs);
  std::vector<std::vector<LeadCollision>> found(ranges.size());
  for (std::size_t begin = 0; begin < ranges.size(); begin += batch) {
    if (progress && !progress(static_cast<double>(begin) / static_cast<double>(ranges.size()), "holder"))
      return {StatusCode::Cancelled, "cancelled"};
    const auto end = static_cast<std::int64_t>(std::min(begin + batch, ranges.size()));
#pragma omp parallel for schedule(dynamic, 1)
    for (std::int64_t i = static_cast<std::int64_t>(begin); i < end; ++i)
      path.look(ranges[i], ranges[i].begin, ranges[i].end, found[i]);
  }
  figures = LeadReport();
  figures.moves = runs.count;
  const LeadCollision* last = nullptr;
  for (const std::vector<LeadCollision>& some : found)
    for (const LeadCollision& collision : some) {
      figures.collided += !last || last->block != collision.block;
      last = &collision;
      if (collision.depth > figures.deepest.depth)
        figures.deepest = collision;
    }
  return Status::success();
}

} // namespace

UpperTool
upperTool(const CutterShape& shape, const std::vector<ToolSegment>& holder, double clearance)
{
  constexpr double endless = 1e6; // mm
  const CutterProfile cutter(shape);
  const double begin = hasBallEnd(shape) ? cutter.cornerHeight() : cutter.topHeight();
  const double length = holder.empty() ? endless : cutter.topHeight() - begin;
  UpperTool tool;
  if (length > 0.0) // nothing below: a point just above the lower face has its shortest way out downwards
    tool.shank = HolderProfile({ToolSegment::cylinder(cutter.radius(), length, "shank")}, begin, 0.0, 0.0);
  tool.holder = HolderProfile(holder, cutter.topHeight(), cutter.radius(), clearance);
  return tool;
}

Status
findHolderCollisions(const PointBlocks& points, const UpperTool& tool, const CutRuns& runs, double tolerance,
                     const ProgressCallback& progress, LeadReport& figures)
{
  return search(PointObstacles(points), tool, runs, tolerance, progress, figures);
}

Status
findHolderCollisions(const SurfaceMesh& mesh, const UpperTool& tool, const CutRuns& runs, double tolerance,
                     const ProgressCallback& progress, LeadReport& figures)
{
  return search(FaceObstacles(mesh, tolerance), tool, runs, tolerance, progress, figures);
}

} // namespace pcl_spiral
