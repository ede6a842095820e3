// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The part of a scan, and the holder that must not meet the rest: settings of all planners.
 */
#pragma once

#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/planning/impl/cloud_of.h>
#include <pcl_spiral/planning/part_choice.h>

#include <vector>

namespace pcl_spiral {

/** Adds the choice of the part to \p BaseT, a SurfaceInput. Base of all planners, and of PathVerifier. Lengths in mm. */
template <typename BaseT>
class PartInput : public BaseT {
public:
  /** Only points in this box are of the part. */
  void setCropBox(const Eigen::AlignedBox3d& box) { choice_.crop_box = box; }
  /** Only points in this prism are of the part. */
  void setCrop(const Prism& prism) { choice_.crop = prism; }
  /** The cutter must not enter this prism, nor its shank what was scanned in it. May be called several times. */
  void addKeepOut(const Prism& prism) { choice_.keep_outs.push_back(prism); }
  /** One region of the part, with a path of its own; may be called several times. */
  void addRegion(const PlanRegion& region) { regions_.push_back(region); }
  /** Takes back setCropBox, setCrop, addKeepOut and addRegion. */
  void clearPart()
  {
    choice_ = PartChoice();
    regions_.clear();
  }
  const PartChoice& getPartChoice() const { return choice_; }            ///< Crops and keep-outs.
  const std::vector<PlanRegion>& getRegions() const { return regions_; } ///< Those of addRegion.

protected:
  /** The choice with what the surface has of it: place of the part and clusters. */
  PartChoice choice() const
  {
    PartChoice choice = choice_;
    choice.part_at = this->getPartAt();
    choice.clusters = this->getClusterHandling();
    return choice;
  }

  PartChoice choice_;               ///< of setCropBox, setCrop and addKeepOut
  std::vector<PlanRegion> regions_; ///< of addRegion
};

/** Adds the holder to PartInput. Base of SpiralPlanner and DrivePlanner. */
template <typename BaseT>
class HolderInput : public PartInput<BaseT> {
public:
  /** The holder above the cutter, from the cutter upwards. Its way, and that of the shank below it, is checked against the whole scan or
   *  mesh. Empty by default. */
  void setHolder(const std::vector<ToolSegment>& segments) { holder_ = segments; }
  const std::vector<ToolSegment>& getHolder() const { return holder_; } ///< The value of setHolder.
  /** Distance that the holder keeps, mm; 0 by default. */
  void setHolderClearance(double clearance) { holder_clearance_ = clearance; }
  double getHolderClearance() const { return holder_clearance_; } ///< The value of setHolderClearance.
  /** Collisions of shank and holder are only warnings; off by default. */
  void setAcceptCollisions(bool accept) { accept_collisions_ = accept; }
  bool getAcceptCollisions() const { return accept_collisions_; } ///< The value of setAcceptCollisions.

protected:
  std::vector<ToolSegment> holder_; ///< of setHolder
  double holder_clearance_ = 0.0;   ///< of setHolderClearance
  bool accept_collisions_ = false;  ///< of setAcceptCollisions
};

} // namespace pcl_spiral
