// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Bridges the gaps of a scan with smooth patches.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface_input.h>

#include <vector>

namespace pcl_spiral {

/** A gap, and the patch put into it. */
struct BridgedGap {
  BoundaryLoop loop;                                ///< the boundary of the gap, of type ScanGap
  std::size_t points = 0;                           ///< put into it; 0 if it is too narrow to be filled, and paths run over it as it is
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< its middle, mm
  double width = 0.0;                               ///< its largest extent, mm
  double residual = 0.0;                            ///< rms distance of the points around it from the patch, mm
};

/** A surface with its gaps bridged, and what was guessed for that. */
struct BridgedSurface {
  Surface::ConstPtr surface;       ///< the given one if there is nothing to bridge
  std::vector<BoundaryLoop> loops; ///< the rim (Outer), the hole that is kept, if any (Inner), gaps that were not filled (ScanGap)
  std::vector<BridgedGap> gaps;    ///< with the patch put into each
  Diagnostics warnings;            ///< one per gap
};

/** Where loops come from. */
enum class LoopOrigin {
  Found, ///< by findBoundaryLoops on this very surface: boundaries are found again after gaps are bridged
  Given  ///< by the user: those that findBoundaryLoops does not find on the surface are checked, and kept as they are
};

/** What to do with each hole. */
struct HoleOptions {
  BoundaryMode mode = BoundaryMode::Automatic; ///< which holes stay as boundaries
  HoleHandling holes = HoleHandling::Around;   ///< Over: as OneBoundary
  GapHandling gaps = GapHandling::Bridge;      ///< what to do with gaps in the data
  double hole_size = 0.0;                      ///< BoundaryOptions::min_hole_width, mm
};

/** Bridge all holes of a surface except those that BoundaryMode and HoleHandling keep as boundaries. \p surface is released before
 *  a new one is made. Fails where chooseBoundaries fails, on a gap with GapHandling::Refuse and on a hole with HoleHandling::Refuse.
 *  Fails also on given loops that do not belong to the surface (checkLoop) or mark a gap where the surface has points. On failure
 *  \p bridged is empty. */
Status bridgeGaps(Surface::ConstPtr surface, const std::vector<BoundaryLoop>& loops, const HoleOptions& options,
                  const ProgressCallback& progress, BridgedSurface& bridged, LoopOrigin origin = LoopOrigin::Given);

/** Bridges gaps in the data. Every hole that is not a boundary of the part is filled with points of a bicubic patch, fitted to the
 *  surface around it. Then the boundaries are found again; the user's own outline is kept. The filled points are guessed:
 *  Surface::isGuessed reports them, and paths over them are marked.
 *
 *  Takes a cloud or a surface, see SurfaceInput, and its loops. Gives a new surface and its loops for RadialLines and
 *  SpiralToolpathGenerator. If there is nothing to bridge, it returns the given ones. Lengths in mm.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class GapBridging : public SurfaceInput<pcl::PCLBase<PointT>, PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<GapBridging>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const GapBridging>; ///< A shared pointer to a constant one.

  /** The loops of the surface, as BoundaryLoops gives them, or the user's own. None, the default: they are found. */
  void setBoundaryLoops(const std::vector<BoundaryLoop>& loops) { given_loops_ = loops; }
  const std::vector<BoundaryLoop>& getBoundaryLoops() const { return given_loops_; } ///< The value of setBoundaryLoops.

  /** Which hole stays as a boundary of the part: with Automatic (the default) a single real one, with TwoBoundaries the longest,
   *  with OneBoundary none. */
  void setBoundaryMode(BoundaryMode mode) { options_.mode = mode; }
  BoundaryMode getBoundaryMode() const { return options_.mode; } ///< The value of setBoundaryMode.

  /** Bridge gaps, the default, or refuse a surface with gaps. */
  void setGapHandling(GapHandling handling) { options_.gaps = handling; }
  GapHandling getGapHandling() const { return options_.gaps; } ///< The value of setGapHandling.

  /** Keep holes of the part, the default, bridge them, or refuse a surface with holes. */
  void setHoleHandling(HoleHandling holes) { options_.holes = holes; }
  HoleHandling getHoleHandling() const { return options_.holes; } ///< The value of setHoleHandling.

  /** Least width of a hole of the part, mm; 0, the default: decided from the scan, see BoundaryOptions. */
  void setHoleSize(double width) { options_.hole_size = width; }
  double getHoleSize() const { return options_.hole_size; } ///< The value of setHoleSize.

  /** Called with the share done; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Bridge the gaps. On failure \p surface is null and \p loops is empty; see getStatus. */
  void compute(Surface::ConstPtr& surface, std::vector<BoundaryLoop>& loops);
  /** The same, with what was guessed, by value. */
  void compute(BridgedSurface& bridged);

  /** What the last compute put into each gap. */
  const std::vector<BridgedGap>& getGaps() const { return gaps_; }
  const Diagnostics& getWarnings() const { return warnings_; } ///< Warnings of the last compute, one per gap.

private:
  Status run(BridgedSurface& bridged);

  std::vector<BoundaryLoop> given_loops_;
  HoleOptions options_;
  ProgressCallback progress_;
  std::vector<BridgedGap> gaps_;
  Diagnostics warnings_;
};

} // namespace pcl_spiral

#include <pcl_spiral/spiral/impl/gap_bridging.hpp>

namespace pcl_spiral {
extern template class GapBridging<pcl::PointXYZ>;
extern template class GapBridging<pcl::PointXYZRGB>;
extern template class GapBridging<pcl::PointNormal>;
} // namespace pcl_spiral
