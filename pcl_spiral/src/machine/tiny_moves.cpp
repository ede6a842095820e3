// SPDX-License-Identifier: BSD-3-Clause
#include "tiny_moves.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

bool
turns(const ProgramBlock& a, const ProgramBlock& b)
{
  return a.angles.first != b.angles.first || a.angles.second != b.angles.second;
}

/** The blocks as they are written. */
class HeldBlocks {
public:
  HeldBlocks(const Kinematics& kinematics, double tolerance) : kinematics_(kinematics), tolerance_(tolerance) {}

  /** Adds the block from \p before to \p block. */
  void add(const ProgramBlock& before, const ProgramBlock& block)
  {
    if (out_.empty() || !isTiny(out_.back(), block))
      return out_.push_back(block);
    const int parts = std::max(1, static_cast<int>(std::ceil((place(block) - place(before)).norm() / tolerance_)));
    for (int i = 1; i < parts; ++i)
      turn(between(before, block, static_cast<double>(i) / parts));
    turn(block);
  }

  /** Whether the linear axes of \p block after \p before hardly move. */
  bool isTiny(const ProgramBlock& before, const ProgramBlock& block) const
  {
    if (block.rapid || !turns(before, block))
      return false;
    const double way = (place(block) - place(before)).norm();
    return way > 0.0 && way < least_linear_rate * block.minutes;
  }
  std::vector<ProgramBlock> take() { return std::move(out_); }

private:
  const Eigen::Vector3d& place(const ProgramBlock& block) const { return kinematics_.machine().rtcp ? block.tip : block.machine; }

  /** The block with its linear axes at \p to. */
  ProgramBlock movedTo(ProgramBlock block, const Eigen::Vector3d& to) const
  {
    const bool rtcp = kinematics_.machine().rtcp;
    block.tip = rtcp ? to : kinematics_.tipOf(to, block.angles);
    block.machine = rtcp ? kinematics_.programmed(to, block.angles) : to;
    return block;
  }

  ProgramBlock between(const ProgramBlock& a, const ProgramBlock& b, double share) const
  {
    const auto mix = [share](const auto& from, const auto& to) { return from + share * (to - from); };
    ProgramBlock block = b;
    block.angles = {mix(a.angles.first, b.angles.first), mix(a.angles.second, b.angles.second)};
    block.axis = kinematics_.toolAxis(block.angles);
    block.normal = mix(a.normal, b.normal).eval().normalized();
    block.arc_length = mix(a.arc_length, b.arc_length);
    return movedTo(block, mix(place(a), place(b)));
  }

  /** Turns to the angles of \p block; the linear axes stay, or go to their place before if that is too far away. */
  void turn(const ProgramBlock& block)
  {
    if ((place(block) - place(out_.back())).norm() > tolerance_) {
      ProgramBlock ahead = movedTo(out_.back(), place(block));
      ahead.section = block.section;
      out_.push_back(ahead);
    }
    out_.push_back(movedTo(block, place(out_.back())));
  }

  const Kinematics& kinematics_;
  double tolerance_;
  std::vector<ProgramBlock> out_;
};

} // namespace

bool
holdTinyMoves(const Kinematics& kinematics, double tolerance, std::vector<ProgramBlock>& blocks)
{
  HeldBlocks held(kinematics, tolerance);
  const auto tiny = std::adjacent_find(blocks.begin(), blocks.end(),
                                       [&](const ProgramBlock& before, const ProgramBlock& block) { return held.isTiny(before, block); });
  if (tiny == blocks.end())
    return false; // without a copy
  for (std::size_t i = 0; i < blocks.size(); ++i)
    held.add(blocks[i == 0 ? 0 : i - 1], blocks[i]);
  blocks = held.take();
  return true;
}

} // namespace pcl_spiral
