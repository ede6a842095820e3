/** \file
 *  Gaps of a scan bridged by smooth patches.
 */
#pragma once

#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/surface/surface_input.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** A gap, and what was put into it. */
struct BridgedGap {
  BoundaryLoop loop;       ///< the gap's boundary, of type ScanGap
  std::size_t points = 0;  ///< put into it; 0 where it is too narrow to be filled and paths run over it as it is
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double width = 0.0;      ///< its largest extent, mm
  double residual = 0.0;   ///< rms distance of the points about it from the patch, mm
};

/** A surface with its gaps bridged, and what was guessed for that. */
struct BridgedSurface {
  Surface::ConstPtr surface;       ///< the one given where there is nothing to bridge
  std::vector<BoundaryLoop> loops; ///< the rim (Outer), the hole that is kept if any (Inner), gaps that were not filled (ScanGap)
  std::vector<BridgedGap> gaps;
  std::vector<std::string> warnings; ///< one a gap
};

/** Where loops come from. */
enum class LoopOrigin {
  Found, ///< findBoundaryLoops found them on this very surface: boundaries are found again once gaps are bridged
  Given  ///< from outside: those that findBoundaryLoops does not find on the surface are checked, and kept as they are
};

/** What becomes of each hole. */
struct HoleOptions {
  BoundaryMode mode = BoundaryMode::Automatic;
  HoleHandling holes = HoleHandling::Around; ///< Over: as OneBoundary
  GapHandling gaps = GapHandling::Bridge;
  double hole_size = 0.0; ///< BoundaryOptions::min_hole_width, mm
};

/** Bridge all holes of a surface but those that BoundaryMode and HoleHandling keep as boundaries. \p surface is given up before a
 *  new one is made. Fails where chooseBoundaries does, on a gap with GapHandling::Refuse, on a hole with HoleHandling::Refuse, and
 *  on given loops that do not belong to the surface (checkLoop) or have points of it where they name a gap; \p bridged is empty
 *  then. */
Status
bridgeGaps(Surface::ConstPtr surface, const std::vector<BoundaryLoop>& loops, const HoleOptions& options,
           const ProgressCallback& progress, BridgedSurface& bridged, LoopOrigin origin = LoopOrigin::Given);

/** Bridges gaps in the data: every hole that is no boundary of the part is filled with points of a bicubic patch fitted to the
 *  surface about it, and the boundaries are found again; an outline of the user's own is kept. What was put in is a guess:
 *  Surface::isGuessed tells it, and paths over it are marked.
 *
 *  Takes a cloud or a surface, see SurfaceInput, and its loops; gives a new surface and its loops for RadialLines and
 *  SpiralToolpathGenerator. Where there is nothing to bridge both are those given. Lengths in mm.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class GapBridging : public SurfaceInput<pcl::PCLBase<PointT>, PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<GapBridging>;
  using ConstPtr = pcl::shared_ptr<const GapBridging>;

  /** The surface's loops, as BoundaryLoops gives them, or a user's own. None, the default: they are found. */
  void setBoundaryLoops(const std::vector<BoundaryLoop>& loops) { given_loops_ = loops; }
  const std::vector<BoundaryLoop>& getBoundaryLoops() const { return given_loops_; }

  /** Which hole is a boundary of the part and stays: Automatic (the default) a single real one, TwoBoundaries the longest,
   *  OneBoundary none. */
  void setBoundaryMode(BoundaryMode mode) { options_.mode = mode; }
  BoundaryMode getBoundaryMode() const { return options_.mode; }

  /** Bridge gaps, the default, or refuse a surface that has some. */
  void setGapHandling(GapHandling handling) { options_.gaps = handling; }
  GapHandling getGapHandling() const { return options_.gaps; }

  /** Keep holes of the part, the default, bridge them, or refuse a surface that has some. */
  void setHoleHandling(HoleHandling holes) { options_.holes = holes; }
  HoleHandling getHoleHandling() const { return options_.holes; }

  /** Least width of a hole of the part, mm; 0, the default: by the scan, see BoundaryOptions. */
  void setHoleSize(double width) { options_.hole_size = width; }
  double getHoleSize() const { return options_.hole_size; }

  /** Called with the share done; returning false cancels. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Bridge. On failure \p surface is null and \p loops is empty; see getStatus. */
  void compute(Surface::ConstPtr& surface, std::vector<BoundaryLoop>& loops);
  /** The same with what was guessed, by value. */
  void compute(BridgedSurface& bridged);

  /** What the last compute put into each gap. */
  const std::vector<BridgedGap>& getGaps() const { return gaps_; }
  const std::vector<std::string>& getWarnings() const { return warnings_; }

private:
  Status run(BridgedSurface& bridged);

  std::vector<BoundaryLoop> given_loops_;
  HoleOptions options_;
  ProgressCallback progress_;
  std::vector<BridgedGap> gaps_;
  std::vector<std::string> warnings_;
};

} // namespace pcl_spiral

#include <pcl_spiral/spiral/impl/gap_bridging.hpp>

namespace pcl_spiral {
extern template class GapBridging<pcl::PointXYZ>;
extern template class GapBridging<pcl::PointXYZRGB>;
extern template class GapBridging<pcl::PointNormal>;
} // namespace pcl_spiral
