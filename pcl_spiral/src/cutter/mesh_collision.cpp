// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_collision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_spiral {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double precision = 1e-3;        // mm, of the depth
constexpr std::size_t most_parts = 20000; // cut for one location; after that the bound of the deepest part left is used

/** A part of a face that may be deeper than the place found, and the bound of its depth. */
struct DeepPart {
  PatchCell cell;
  double bound = 0.0;
  int segment = -1;
  std::uint32_t face = 0;

  bool operator<(const DeepPart& other) const { return bound != other.bound ? bound < other.bound : face > other.face; }
};

class CollisionSearch {
public:
  CollisionSearch(const PatchTree& patches, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance, double sag,
                  double above)
  : patches_(patches), holder_(holder), frame_(frame), tip_(tip), above_(above - tip), least_(tolerance), sag_(sag)
  {
    axes_ << frame.e1.transpose(), frame.e2.transpose(), frame.axis.transpose();
  }

  /** Instead of the depth: whether it may be more than the tolerance within \p sway. */
  bool anyWithin(const ToolSway& sway)
  {
    sway_ = sway;
    any_ = true;
    return run().found();
  }

  HolderCollision run()
  {
    constexpr double slack = 1e-9;
    const AxisView view(frame_);
    const auto keep = [&](const Box& box) {
      const AxisBox seen = view.see(box);
      double depth = 0.0;
      const double low = std::max(seen.low - tip_, above_) - slack, high = seen.high - tip_ + slack;
      return !isDone() && high >= low &&
             depthWithin(seen.nearest - slack, low, high, sway_.at(farthestCorner(box, frame_.origin)), depth) >= 0 && depth > least_;
    };
    patches_.boxes().forItems(keep, [&](std::uint32_t place) {
      const PatchCell cell = patches_.cell(place);
      const Vector3d base = frame_.origin + tip_ * frame_.axis;
      look({axes_ * (cell.corners.colwise() - base), axes_ * cell.bows}, patches_.index(place));
    });
    for (std::size_t looked = 0; !parts_.empty() && !isDone(); ++looked) {
      std::pop_heap(parts_.begin(), parts_.end());
      const DeepPart top = parts_.back();
      parts_.pop_back();
      if (top.bound <= least_ + precision)
        break;
      if (looked == most_parts) {
        take(top.cell.corners.col(0), top.bound, top.segment, top.face);
        break;
      }
      for (int k = 0; k < 4; ++k)
        look(top.cell.quarter(k), top.face);
    }
    return worst_;
  }

private:
  bool isDone() const { return any_ && worst_.found(); }

  /** The bound of the depth within \p reach, as HolderProfile::mayBeInside. */
  int depthWithin(double nearest, double low, double high, double reach, double& depth) const
  {
    return holder_.mayBeInside(std::max(0.0, nearest - reach), low - reach, high + reach, depth);
  }

  /** Take the deepest of some places of \p cell; keep the cell if other places may be deeper. */
  void look(const PatchCell& cell, std::uint32_t face)
  {
    Matrix3d across = cell.corners;
    across.row(2).setZero();
    const Vector3d nearest = nearestOnTriangle(across, Vector3d::Zero());
    const bool flat = !(cell.sag() > sag_);
    for (const Vector3d& b : {nearest, Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) {
      const Vector3d p = std::isfinite(sag_) ? cell.position(b) : cell.corners * b;
      double depth = 0.0;
      const int segment = p.z() > above_ ? depthWithin(p.head<2>().norm(), p.z(), p.z(), sway_.at(p.norm()), depth) : -1;
      if (segment >= 0)
        take(p, depth, segment, face);
    }
    const double off = flat ? 0.0 : cell.sag();
    const double lowest = cell.corners.row(2).minCoeff(), highest = cell.corners.row(2).maxCoeff();
    if (highest + off < above_)
      return;
    double bound = 0.0;
    const double reach = off + sway_.at(cell.corners.colwise().norm().maxCoeff() + off);
    const int segment = depthWithin((across * nearest).norm(), std::max(lowest, above_ + off), highest, reach, bound);
    if (segment >= 0 && bound > least_ + precision) {
      parts_.push_back({cell, bound, segment, face});
      std::push_heap(parts_.begin(), parts_.end());
    }
  }

  void take(const Vector3d& p, double depth, int segment, std::uint32_t face)
  {
    if (!(depth > least_) && !(depth == least_ && worst_.found() && face < worst_.cloud_index))
      return;
    least_ = depth;
    worst_ = {ToolPart::Holder, segment, depth, frame_.place(p.head<2>(), p.z() + tip_), face};
  }

  const PatchTree& patches_;
  const HolderProfile& holder_;
  const AxisFrame& frame_;
  double tip_, above_; ///< above_ is from the tip
  double least_;       ///< the depth found, or the tolerance
  double sag_;
  ToolSway sway_;    ///< of the tool; none for the depth where it stands
  bool any_ = false; ///< ends at the first place found
  Matrix3d axes_;
  std::vector<DeepPart> parts_; ///< a heap
  HolderCollision worst_;
};

} // namespace

HolderCollision
findCollision(const PatchTree& patches, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance, double sag,
              double above)
{
  if (holder.empty())
    return {};
  return CollisionSearch(patches, holder, frame, tip, tolerance, sag, above).run();
}

bool
mayCollide(const PatchTree& patches, const HolderProfile& holder, const AxisFrame& frame, const ToolSway& sway, double tolerance,
           double sag)
{
  return !holder.empty() &&
         CollisionSearch(patches, holder, frame, 0.0, tolerance, sag, -std::numeric_limits<double>::infinity()).anyWithin(sway);
}

} // namespace pcl_spiral
