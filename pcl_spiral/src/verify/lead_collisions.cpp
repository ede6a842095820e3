#include <pcl_spiral/verify/lead_collisions.h>

#include <pcl_spiral/core/swept_error.h>
#include <pcl_spiral/machine/block_spacing.h>
#include <pcl_spiral/toolpath/holder_collision.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr int most_halvings = 16;
constexpr std::size_t chunk = 256; // moves between two reports of progress

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

class LeadSearch {
public:
  LeadSearch(const PointBlocks& points, const CutterProfile& cutter, const HolderProfile& holder,
             const MachineProgram& program, double tolerance)
  : kinematics_(program.machine), points_(points), cutter_(cutter), holder_(holder), program_(program),
    drop_(points, insetCutter(cutter, tolerance)), tolerance_(tolerance)
  {
  }

  /** The deepest place on the move to \p block; depth 0 where it is free. */
  LeadCollision
  deepestOn(std::size_t block) const
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
  void
  lookBetween(const MachineLocation& from, const MachineLocation& to, double a, const ToolPose& at_a, double b,
              const ToolPose& at_b, int halvings, LeadCollision& deepest) const
  {
    const double error = sweptError(cutter_, {at_a.tip, at_a.axis}, {at_b.tip, at_b.axis});
    const bool turns_far = at_a.axis.dot(at_b.axis) < 0.9;
    if (halvings < most_halvings && (error > 0.5 * tolerance_ || turns_far)) {
      const double middle = 0.5 * (a + b);
      const ToolPose at_middle = interpolated(kinematics_, from, to, middle);
      lookBetween(from, to, a, at_a, middle, at_middle, halvings + 1, deepest);
      lookBetween(from, to, middle, at_middle, b, at_b, halvings + 1, deepest);
      return;
    }
    lookAt(at_b, deepest);
  }

  void
  lookAt(const ToolPose& pose, LeadCollision& deepest) const
  {
    const AxisFrame frame(pose.tip, pose.axis);
    const DropContact drop = drop_.highest(frame, tolerance_ + deepest.depth);
    if (drop.found) {
      deepest.segment = -1;
      deepest.depth = drop.height - tolerance_;
      deepest.place = points_.position(drop.point);
      deepest.tip = pose.tip;
    }
    const HolderCollision held = findCollision(points_, holder_, frame, 0.0, std::max(tolerance_, deepest.depth));
    if (held.found()) {
      deepest.segment = held.segment;
      deepest.depth = held.depth;
      deepest.place = held.place;
      deepest.tip = pose.tip;
    }
  }

  Kinematics kinematics_;
  const PointBlocks& points_;
  const CutterProfile& cutter_;
  const HolderProfile& holder_;
  const MachineProgram& program_;
  CutterDrop drop_;
  double tolerance_;
};

} // namespace

Status
findLeadCollisions(const PointBlocks& points, const CutterProfile& cutter, const HolderProfile& holder,
                   const MachineProgram& program, double tolerance, const ProgressCallback& progress,
                   LeadFigures& figures)
{
  figures = LeadFigures();
  if (const Status status = checkMachine(program.machine); !status.ok())
    return status;
  std::vector<std::size_t> moves;
  for (std::size_t i = 1; i < program.blocks.size(); ++i)
    if (program.blocks[i].section != BlockSection::Cut)
      moves.push_back(i);
  const LeadSearch search(points, cutter, holder, program, tolerance);
  std::vector<LeadCollision> found(moves.size());
  for (std::size_t begin = 0; begin < moves.size(); begin += chunk) {
    if (progress && !progress(static_cast<double>(begin) / static_cast<double>(moves.size()), "leads"))
      return {StatusCode::Cancelled, "cancelled"};
    const auto end = static_cast<std::int64_t>(std::min(begin + chunk, moves.size()));
#pragma omp parallel for schedule(dynamic, 4)
    for (std::int64_t i = static_cast<std::int64_t>(begin); i < end; ++i)
      found[i] = search.deepestOn(moves[i]);
  }
  figures.moves = moves.size();
  for (const LeadCollision& collision : found) {
    figures.collided += collision.depth > 0.0;
    if (collision.depth > figures.deepest.depth)
      figures.deepest = collision;
  }
  return Status::success();
}

} // namespace pcl_spiral
