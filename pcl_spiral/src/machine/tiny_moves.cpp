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
    if (!isTiny(block))
      return out_.push_back(block);
    held_ = true;
    const int parts = std::max(1, static_cast<int>(std::ceil((place(block) - place(before)).norm() / tolerance_)));
    for (int i = 1; i < parts; ++i)
      turn(between(before, block, static_cast<double>(i) / parts));
    turn(block);
  }

  bool held() const { return held_; }
  std::vector<ProgramBlock> take() { return std::move(out_); }

private:
  const Eigen::Vector3d& place(const ProgramBlock& block) const { return kinematics_.machine().rtcp ? block.tip : block.machine; }

  bool isTiny(const ProgramBlock& block) const
  {
    if (out_.empty() || block.rapid || !turns(out_.back(), block))
      return false;
    const double way = (place(block) - place(out_.back())).norm();
    return way > 0.0 && way < least_linear_rate * block.minutes;
  }

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
  bool held_ = false;
  std::vector<ProgramBlock> out_;
};

} // namespace

bool
holdTinyMoves(const Kinematics& kinematics, double tolerance, std::vector<ProgramBlock>& blocks)
{
  HeldBlocks held(kinematics, tolerance);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    held.add(blocks[i == 0 ? 0 : i - 1], blocks[i]);
  if (held.held())
    blocks = held.take();
  return held.held();
}

} // namespace pcl_spiral
