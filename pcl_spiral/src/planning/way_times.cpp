// SPDX-License-Identifier: BSD-3-Clause
#include "planning/way_times.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr double way_rounding = 1e-9; // of the way of a pass

/** The blocks that cut, from one to the next along a way. */
class CuttingBlocks {
public:
  explicit CuttingBlocks(const std::vector<ProgramBlock>& blocks) : blocks_(blocks) {}

  /** To the first of \p pass. */
  void enter(std::size_t pass)
  {
    pass_ = pass;
    if (!cuts(at_))
      at_ = next();
    begin_ = before();
  }
  /** On to the one that ends \p way mm from the begin of the pass or later; to the last of the pass if there is none. */
  void goTo(double way)
  {
    while (blocks_[at_].arc_length < begin_ + way * (1.0 - way_rounding)) {
      const std::size_t on = next();
      if (on == at_)
        return;
      at_ = on;
    }
  }
  std::size_t block() const { return at_; }
  /** The share of the block that is made \p way mm from the begin of the pass. */
  double shareAt(double way) const
  {
    const double made = blocks_[at_].arc_length - before();
    return made > 0.0 ? std::clamp((begin_ + way - before()) / made, 0.0, 1.0) : 1.0;
  }

private:
  bool cuts(std::size_t b) const { return blocks_[b].section == BlockSection::Cut && blocks_[b].pass == pass_; }
  double before() const { return at_ > 0 ? blocks_[at_ - 1].arc_length : 0.0; }
  /** The next of the pass; the same if there is none. */
  std::size_t next() const
  {
    for (std::size_t b = at_ + 1; b < blocks_.size() && blocks_[b].pass <= pass_; ++b)
      if (cuts(b))
        return b;
    return at_;
  }

  const std::vector<ProgramBlock>& blocks_;
  std::size_t at_ = 0, pass_ = 0;
  double begin_ = 0.0; ///< arc length where the pass begins
};

} // namespace

std::vector<double>
timesOnWay(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<std::size_t>& begins, const std::vector<ProgramBlock>& blocks,
           const std::vector<double>& ends)
{
  std::vector<double> reached;
  reached.reserve(path.size());
  CuttingBlocks cutting(blocks);
  std::size_t pass = 0;
  double way = 0.0; // from the begin of the pass
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool later = pass < begins.size() && begins[pass] == i, first = i == 0 || later;
    pass += later;
    if (first)
      cutting.enter(pass);
    way = first ? 0.0 : way + (path[i].getVector3fMap().cast<double>() - path[i - 1].getVector3fMap().cast<double>()).norm();
    cutting.goTo(way);
    const double share = first ? 0.0 : cutting.shareAt(way), end = ends[cutting.block()];
    const double begin = cutting.block() > 0 ? ends[cutting.block() - 1] : 0.0;
    const double time = share < 1.0 ? begin + share * (end - begin) : end;
    reached.push_back(reached.empty() ? time : std::max(time, reached.back()));
  }
  return reached;
}

} // namespace pcl_spiral
