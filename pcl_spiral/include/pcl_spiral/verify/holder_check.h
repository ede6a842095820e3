// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks whether shank and holder touch a scan or a mesh while the cutter follows its path.
 */
#pragma once

#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/verify/impl/holder_check_engine.h>
#include <pcl_spiral/verify/impl/tool_check.h>

#include <pcl/point_types.h>

#include <vector>

namespace pcl_spiral {

/** Checks shank and holder on the cutting moves of a path, or of a program as the machine makes them. What the program does between
 *  its cuts is checked by LeadCheck.
 *
 *  setInputCloud takes the whole scan, with all that stands beside the part. The shank is as wide as the cutter: from the centre of a
 *  ball, or from the top of the flank of another cutter, up to the holder; without a holder it has no end. Lengths in mm. The result does
 *  not depend on the order of the points or on the number of threads.
 *  \code
 *  HolderCheck<pcl::PointXYZ> check;
 *  check.setInputCloud(scan);
 *  check.setCutter(CutterShape::ball(5.0, 20.0)); // the holder begins 20 mm above the centre of the ball
 *  check.setHolder({ToolSegment::cylinder(12.0, 40.0, "chuck")});
 *  check.compute(ballPasses(path, 5.0));
 *  if (!check.getStatus().ok()) ...            // could not be looked at
 *  if (check.getReport().collided > 0) ...    // check.getReport().deepest says where
 *  \endcode */
template <typename PointT>
class HolderCheck : public ToolCheck<PointT> {
public:
  using Ptr = pcl::shared_ptr<HolderCheck>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const HolderCheck>; ///< A shared pointer to a constant one.

  /** A mesh instead of a scan, with the curved surface behind its faces. Null, the default: the scan. */
  void setInputMesh(const SurfaceMesh::ConstPtr& mesh) { mesh_ = mesh; }
  const SurfaceMesh::ConstPtr& getInputMesh() const { return mesh_; } ///< The value of setInputMesh.

  /** Checks \p passes: straight moves from pose to pose, the axis along its arc. Fails without a scan or a cutter, on invalid settings,
   *  without a move, or when cancelled. LeadCollision::block is the pose where the move ends, counted over all passes. */
  void compute(const std::vector<ToolPoses>& passes);
  /** Checks the cutting moves of \p program: with blended axes, and as tip and axis move between its blocks. */
  void compute(const MachineProgram& program);

private:
  template <typename MakeRuns>
  Status find(MakeRuns make_runs);

  SurfaceMesh::ConstPtr mesh_;
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/holder_check.hpp>

namespace pcl_spiral {
extern template class HolderCheck<pcl::PointXYZ>;
extern template class HolderCheck<pcl::PointXYZRGB>;
extern template class HolderCheck<pcl::PointNormal>;
} // namespace pcl_spiral
