// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places and axes along which a cutter is driven over a scan or a mesh.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/drive/drive_input.h>

#include <pcl/point_types.h>

namespace pcl_spiral {

/** Drive points in passes over a scan, with tool axes and without normals. Each is a
 *  line along which CutterLocation moves the cutter down until it touches. The spiral
 *  of SpiralToolpathGenerator is another such path: see CutterLocation::setDrivePath.
 *
 *  - DriveKind::Planes: planes that contain the tool axis and the direction of the
 *  passes cut the triangulated scan. The extent across is divided into equal steps no
 *  larger than the step-over, with a plane in the middle of each. Gaps wider than three
 *  spacings of the scan cut a pass in two. Where one part hides another from the tool,
 *  both are cut: CutterLocation then lifts the cutter from the lower onto the upper.
 *  - DriveKind::Helix, Rings: on a cylinder with the scan's mean radius about the axis of the drive
 *  cylinder, which is given or fitted. The extent along the axis is divided in the same way. The helix
 *  climbs one step per turn from the middle of the first step to that of the last, with a ring at both ends.
 *  - DriveKind::Curve: a curve at equal steps of arc length.
 *  - DriveKind::BoundaryOffset: lines at equal distances from the outer boundary, measured
 *  along the surface. The greatest distance is divided in the same way. The outermost
 *  line is first; the boundary is on the right. Where an island ends more than half
 *  a step inside its last line, one more line runs half a step from its peak. A hole
 *  cuts the lines. A rim more jagged than half a step also cuts them, with a warning.
 *
 *  No place of the surface is farther from a pass than half a step-over, across the passes: projected
 *  along the tool axis for planes, along the axis of the cylinder, or along the surface for offsets.
 *
 *  Takes a cloud or a surface, see SurfaceInput; a curve with a fixed axis needs neither. Source of planes
 *  and cylinder: Sun, Cui, Kang, Wang, five-axis NC toolpath generation from scattered points. Lengths in
 *  mm, angles in degrees. The output does not depend on the order of the cloud or on the number of threads. */
template <typename PointT>
class DrivePath : public DriveInput<PointT> {
public:
  using Ptr = pcl::shared_ptr<DrivePath>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const DrivePath>; ///< A shared pointer to a constant one.

  /** Computes the passes. \p passes is empty on failure: no cloud or fewer than
   *  50 points, a setting out of range, a scan of the wrong shape, a path of
   *  more than 1e8 points or larger than the free memory, or cancelled. */
  void compute(DrivePasses& passes);

  const DriveReport& getReport() const { return report_; } ///< Figures and warnings of the last compute.

private:
  using DriveInput<PointT>::settings_;
  using DriveInput<PointT>::progress_;

  Status run(DrivePasses& passes);
  Status runOnMesh(DrivePasses& passes);

  DriveReport report_;
};

} // namespace pcl_spiral

#include <pcl_spiral/drive/impl/drive_path.hpp>

namespace pcl_spiral {
extern template class DrivePath<pcl::PointXYZ>;
extern template class DrivePath<pcl::PointXYZRGB>;
extern template class DrivePath<pcl::PointNormal>;
} // namespace pcl_spiral
