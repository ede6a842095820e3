// SPDX-License-Identifier: BSD-3-Clause
#include "verify/program_path.h"

#include <pcl_spiral/machine/impl/sampled_moves.h>
#include <pcl_spiral/verify/impl/cutter_contacts.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include <utility>

namespace pcl_spiral {
namespace {

constexpr double least_slope = 0.02; // of a lead against the surface

/** Poses of the moves that may cut, one run after the other. */
struct SampledRuns {
  ToolPoses poses;
  std::vector<std::size_t> blocks;                         ///< of each pose; a run begins with the end of the block before it
  std::vector<std::pair<std::size_t, std::size_t>> ranges; ///< poses of each run: first, and the one after the last
};

SampledRuns
sampledRuns(const MachineProgram& program, const ProgramPathSettings& settings)
{
  const Kinematics kinematics(program.machine);
  const MoveSampling sampling{settings.cutter.radius, settings.tolerance, settings.axis_arcs, !isBall(settings.cutter)};
  SampledRuns runs;
  const auto add = [&](const ToolPose& pose, std::size_t block) {
    runs.poses.push_back(pose);
    runs.blocks.push_back(block);
  };
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    if (!mayCut(program.blocks[i]))
      continue;
    if (i == 1 || !mayCut(program.blocks[i - 1])) {
      runs.ranges.emplace_back(runs.poses.size(), 0);
      add(poseOf(program.blocks[i - 1]), i - 1);
    }
    for (const ToolPose& pose : sampledMove(kinematics, program.blocks[i - 1], program.blocks[i], sampling))
      add(pose, i);
    runs.ranges.back().second = runs.poses.size();
  }
  return runs;
}

class PathMaker {
public:
  PathMaker(const SampledRuns& runs, std::vector<NearestContact> contacts, const ProgramPathSettings& settings, MachineProgram& program)
  : runs_(runs), contacts_(std::move(contacts)), settings_(settings), program_(program)
  {}

  ProgramPath make()
  {
    for (const auto& [first, end] : runs_.ranges) {
      std::size_t begin = first, last = end - 1;
      for (std::size_t to = endOfBlock(begin, last); begin < last && leads(begin, to); to = endOfBlock(begin, last)) {
        program_.blocks[runs_.blocks[to]].section = BlockSection::LeadIn;
        begin = to;
      }
      for (std::size_t from = beginOfBlock(last, begin); last > begin && leads(last, from); from = beginOfBlock(last, begin)) {
        program_.blocks[runs_.blocks[last]].section = BlockSection::LeadOut;
        last = from;
      }
      if (begin < last)
        addPass(begin, last);
    }
    return std::move(result_);
  }

private:
  /** The last pose of the block after pose \p i. */
  std::size_t endOfBlock(std::size_t i, std::size_t last) const
  {
    if (i >= last)
      return last;
    const std::size_t block = runs_.blocks[++i];
    while (i < last && runs_.blocks[i + 1] == block)
      ++i;
    return i;
  }

  /** The pose from which the block of pose \p i starts. */
  std::size_t beginOfBlock(std::size_t i, std::size_t first) const
  {
    const std::size_t block = runs_.blocks[i];
    while (i > first && runs_.blocks[i] == block)
      --i;
    return i;
  }

  bool inAir(std::size_t i) const { return !contacts_[i].valid || contacts_[i].height > settings_.air; }

  /** Whether the cutter is off the surface at pose \p outer, and pose \p inner is nearer to it, or in the air too. */
  bool leads(std::size_t outer, std::size_t inner) const
  {
    if (inAir(outer))
      return true;
    const double way = (runs_.poses[outer].tip - runs_.poses[inner].tip).norm();
    return contacts_[outer].height > settings_.tolerance && contacts_[inner].height < contacts_[outer].height - least_slope * way;
  }

  void addPass(std::size_t begin, std::size_t last)
  {
    pcl::PointCloud<ToolpathPoint>& path = result_.path;
    for (std::size_t i = begin; i <= last; ++i) {
      ToolpathPoint point = pointAt(i);
      if (!path.empty())
        point.arc_length = path.back().arc_length;
      if (i > begin)
        point.arc_length += (point.getVector3fMap() - path.back().getVector3fMap()).norm();
      path.push_back(point);
      result_.blocks.push_back(runs_.blocks[i]);
      result_.tips.push_back(runs_.poses[i].tip);
    }
    ++result_.passes;
  }

  ToolpathPoint pointAt(std::size_t i) const
  {
    const ToolPose& pose = runs_.poses[i];
    const NearestContact& contact = contacts_[i];
    ToolpathPoint point;
    point.getVector3fMap() = (contact.valid ? contact.position : pose.tip).cast<float>();
    point.getNormalVector3fMap() = (contact.valid ? contact.normal : pose.axis).cast<float>();
    point.getAxisVector3fMap() = pose.axis.cast<float>();
    point.turn = static_cast<float>(result_.passes);
    return point;
  }

  const SampledRuns& runs_;
  std::vector<NearestContact> contacts_;
  const ProgramPathSettings& settings_;
  MachineProgram& program_;
  ProgramPath result_;
};

} // namespace

bool
mayCut(const ProgramBlock& block)
{
  return !block.rapid && block.section != BlockSection::Link;
}

ProgramPath
programPath(const ReferenceSurface& reference, const ProgramPathSettings& settings, MachineProgram& program)
{
  const SampledRuns runs = sampledRuns(program, settings);
  std::vector<CutterPlace> places;
  places.reserve(runs.poses.size());
  for (const ToolPose& pose : runs.poses)
    places.push_back({pose.tip, pose.axis});
  return PathMaker(runs, cutterContacts(reference, places, settings.cutter), settings, program).make();
}

} // namespace pcl_spiral
