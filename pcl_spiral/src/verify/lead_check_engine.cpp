// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/lead_check_engine.h>

#include <pcl_spiral/core/impl/swept_error.h>
#include <pcl_spiral/cutter/impl/holder_collision.h>
#include <pcl_spiral/machine/impl/block_spacing.h>

#include "core/angle_between.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr int most_lead_halvings = 16;
constexpr double most_turn = 0.5;          // radians of a rotary axis: after more it may be back where it was
constexpr double least_holder_step = 0.1;  // mm between two tests of a holder
constexpr std::size_t moves_at_once = 256; // moves between two reports of progress

/** The machine where a block ends. */
MachineLocation
endOf(const ProgramBlock& block)
{
  MachineLocation location;
  location.pose.tip = block.tip;
  location.pose.axis = block.axis;
  location.pose.contact = block.tip;
  location.pose.normal = block.normal;
  location.angles = block.angles;
  return location;
}

/** Distance of two shanks of \p radius, side by side, that leave a wedge of depth \p depth between them. */
double
stepForWedge(double radius, double depth)
{
  return depth < radius ? 2.0 * std::sqrt(depth * (2.0 * radius - depth)) : 2.0 * radius;
}

class LeadSearch {
public:
  LeadSearch(const PointBlocks& points, const CutterProfile& cutter, const HolderProfile& holder, const MachineProgram& program,
             double tolerance)
  : kinematics_(program.machine), points_(points), cutter_(cutter), inset_(insetCutter(cutter, tolerance)), holder_(holder),
    program_(program), drop_(points, inset_), tolerance_(tolerance), shank_step_(stepForWedge(cutter.radius(), 0.5 * tolerance)),
    holder_step_(std::max(tolerance, least_holder_step))
  {}

  /** The deepest place on the move to \p block; depth 0 where it is free. */
  LeadCollision deepestOn(std::size_t block) const
  {
    const MachineLocation from = endOf(program_.blocks[block - 1]), to = endOf(program_.blocks[block]);
    LeadCollision deepest;
    const ToolPose begin = interpolated(kinematics_, from, to, 0.0), end = interpolated(kinematics_, from, to, 1.0);
    lookAt(begin, deepest);
    lookBetween(from, to, 0.0, begin, 1.0, end, 0, deepest);
    deepest.block = block;
    deepest.section = program_.blocks[block].section;
    return deepest;
  }

private:
  /** The way from share \p a to share \p b of a move, its end with it. */
  void lookBetween(const MachineLocation& from, const MachineLocation& to, double a, const ToolPose& at_a, double b, const ToolPose& at_b,
                   int halvings, LeadCollision& deepest) const
  {
    const double turn = std::max(std::abs(to.angles.first - from.angles.first), std::abs(to.angles.second - from.angles.second));
    if (halvings < most_lead_halvings && ((b - a) * turn > most_turn || !isNear(at_a, at_b))) {
      const double middle = 0.5 * (a + b);
      const ToolPose at_middle = interpolated(kinematics_, from, to, middle);
      lookBetween(from, to, a, at_a, middle, at_middle, halvings + 1, deepest);
      lookBetween(from, to, middle, at_middle, b, at_b, halvings + 1, deepest);
      return;
    }
    lookAt(at_b, deepest);
  }

  /** Whether a test at both places finds everything that is too deep between them. Along the axis the cutter and its shank
   *  cover all between them; a place of the holder must be near a tested one. */
  bool isNear(const ToolPose& a, const ToolPose& b) const
  {
    const Eigen::Vector3d way = b.tip - a.tip;
    const double turn = angleBetween(a.axis, b.axis), aside = (way - way.dot(a.axis) * a.axis).norm();
    if (sweptError(cutter_, {a.tip, a.axis}, {b.tip, b.axis}) > 0.5 * tolerance_ ||
        aside + turn * farthestCorner(points_.box(), a.tip) > shank_step_)
      return false;
    return holder_.empty() || way.norm() + turn * holder_.top() <= holder_step_;
  }

  void lookAt(const ToolPose& pose, LeadCollision& deepest) const
  {
    const AxisFrame frame(pose.tip, pose.axis);
    drop_.visitAbove(frame, tolerance_, [&](std::uint32_t i, double tip) {
      if (!(tip > tolerance_))
        return;
      const Eigen::Vector3d p = points_.position(i);
      const double along = frame.along(p), l = frame.across(p).norm();
      const double aside = inset_.radiusAt(along - tolerance_) - l;
      const double depth = std::min(tip - tolerance_, aside) + tolerance_;
      if (depth > std::max(tolerance_, deepest.depth)) {
        deepest.part = along > cutter_.topHeight() ? ToolPart::Shank : ToolPart::Cutter;
        set(depth, p, pose, deepest);
      }
    });
    const HolderCollision held = findCollision(points_, holder_, frame, 0.0, std::max(tolerance_, deepest.depth));
    if (held.found()) {
      deepest.part = ToolPart::Holder;
      deepest.segment = held.segment;
      set(held.depth, held.place, pose, deepest);
    }
  }

  static void set(double depth, const Eigen::Vector3d& place, const ToolPose& pose, LeadCollision& deepest)
  {
    deepest.depth = depth;
    deepest.place = place;
    deepest.tip = pose.tip;
  }

  Kinematics kinematics_;
  const PointBlocks& points_;
  const CutterProfile& cutter_;
  CutterProfile inset_;
  const HolderProfile& holder_;
  const MachineProgram& program_;
  CutterDrop drop_;
  double tolerance_, shank_step_, holder_step_;
};

} // namespace

Status
findLeadCollisions(const PointBlocks& points, const CutterProfile& cutter, const HolderProfile& holder, const MachineProgram& program,
                   double tolerance, const ProgressCallback& progress, LeadReport& figures)
{
  figures = LeadReport();
  if (const Status status = checkMachine(program.machine); !status.ok())
    return status;
  if (program.blocks.empty())
    return {StatusCode::InvalidInput, "the program has no moves; make it first with {MachineProgramGenerator}"};
  std::vector<std::size_t> moves;
  for (std::size_t i = 1; i < program.blocks.size(); ++i)
    if (program.blocks[i].section != BlockSection::Cut || program.blocks[i].rapid)
      moves.push_back(i);
  const LeadSearch search(points, cutter, holder, program, tolerance);
  std::vector<LeadCollision> found(moves.size());
  for (std::size_t begin = 0; begin < moves.size(); begin += moves_at_once) {
    if (progress && !progress(static_cast<double>(begin) / static_cast<double>(moves.size()), "leads"))
      return {StatusCode::Cancelled, "cancelled"};
    const auto end = static_cast<std::int64_t>(std::min(begin + moves_at_once, moves.size()));
#pragma omp parallel for schedule(dynamic, 4)
    for (std::int64_t i = static_cast<std::int64_t>(begin); i < end; ++i)
      found[i] = search.deepestOn(moves[i]);
  }
  figures.moves = moves.size();
  for (const LeadCollision& collision : found) {
    if (collision.depth > 0.0)
      figures.blocks.push_back(collision.block);
    if (collision.depth > figures.deepest.depth)
      figures.deepest = collision;
  }
  figures.collided = figures.blocks.size();
  return Status::success();
}

} // namespace pcl_spiral
