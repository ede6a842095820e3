// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the cutter of a toolpath leaves on a scanned surface, and where it gouges.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/verify/figures.h>
#include <pcl_spiral/verify/impl/material_removal_engine.h>
#include <pcl_spiral/verify/impl/reference_input.h>

#include <utility>
#include <vector>

namespace pcl_spiral {

/** Stock left or gouge at every point of a scan, after a cutter has run along a toolpath in straight
 *  lines; also the ridges between turns, and the length of the path against the least possible length.
 *
 *  setInputCloud takes the reference: the raw scan, that of the planner or another
 *  one. Heights are above the local fit of its points; see ReferenceSurface for
 *  the part of them that is noise. Lengths in mm. The input is never changed. */
template <typename PointT>
class MaterialRemoval : public ReferenceInput<PointT> {
public:
  using Ptr = pcl::shared_ptr<MaterialRemoval>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const MaterialRemoval>; ///< A shared pointer to a constant one.

  /** Radius of a ball cutter, mm. This or setCutter must be set. */
  void setToolRadius(double radius) { cutter_ = CutterShape::ball(radius); }
  double getToolRadius() const { return cutter_.radius; } ///< Radius of the cutter, mm.

  /** Any cutter. Unless it is a ball without a flank, the path needs tool axes. Its flank counts, and a shank above it as wide as its top,
   *  up to twice the radius above the tip. The least length of a path is that of a ball which leaves the same scallop on a plane across
   *  the axis. */
  void setCutter(const CutterShape& cutter) { cutter_ = cutter; }
  const CutterShape& getCutter() const { return cutter_; } ///< The value of setCutter.

  /** Tool tips, one for each point of the toolpath, mm; not used for a ball. Empty, the default: the cutter touches at the contacts.
   *  A flat end or a flank touches along an area or a line, so the contact alone does not tell where it is. */
  void setInputTips(Polyline tips) { tips_ = std::move(tips); }
  const Polyline& getInputTips() const { return tips_; } ///< The value of setInputTips.

  /** Scallop height asked of the path, mm. Must be set, below the radius. */
  void setScallopHeight(double height) { scallop_height_ = height; }
  double getScallopHeight() const { return scallop_height_; } ///< The value of setScallopHeight.

  /** How far above the surface stock is looked for, mm; nothing met counts as uncut.
   *  0, the default: 20 scallop heights, and at least ten times the scan's noise. */
  void setReach(double reach) { reach_ = reach; }
  double getReach() const { return reach_; } ///< The value of setReach.

  /** Measures. \p output has one point per input point (per index, if indices are set), in their order. With a surface
   *  and no cloud: one per point of the cloud that the surface was made of; the place of a point that was left out is NaN
   *  too. Each has its place, and the stock as intensity: negative for a gouge, the reach where uncut, NaN where the point
   *  is not part of the surface (not finite, a duplicate, an outlier). Empty on failure: a missing or unfit reference or
   *  toolpath, a surface or reference with a cloud of another size, a setting or index out of range, or cancelled. */
  void compute(pcl::PointCloud<pcl::PointXYZI>& output);

  const RemovalReport& getReport() const { return figures_; }                                     ///< Figures of the last compute.
  [[deprecated("use getReport")]] const RemovalReport& getFigures() const { return getReport(); } ///< \deprecated Use getReport.
  /** Height of the ridge next to each output point, mm; NaN near the rim and where none was found. */
  const std::vector<float>& getRidgeHeights() const { return ridge_heights_; }

private:
  Status checkCloud() const;
  void write(const RemovalHeights& heights, pcl::PointCloud<pcl::PointXYZI>& output);

  CutterShape cutter_;
  Polyline tips_;
  double scallop_height_ = 0.0, reach_ = 0.0;
  RemovalReport figures_;
  std::vector<float> ridge_heights_;
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/material_removal.hpp>

namespace pcl_spiral {
extern template class ReferenceInput<pcl::PointXYZ>;
extern template class ReferenceInput<pcl::PointXYZRGB>;
extern template class ReferenceInput<pcl::PointNormal>;
extern template class MaterialRemoval<pcl::PointXYZ>;
extern template class MaterialRemoval<pcl::PointXYZRGB>;
extern template class MaterialRemoval<pcl::PointNormal>;
} // namespace pcl_spiral
