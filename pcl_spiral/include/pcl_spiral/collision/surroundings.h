// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What stands around the part, in the way of the tool.
 */
#pragma once

#include <pcl_spiral/core/prism.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** What the ball of a path and its shank must not cut into. Lengths in mm. */
struct Surroundings {
  std::vector<Prism> keep_outs;                  ///< the ball stays out of them; the holes that they leave in the part are no gaps
  std::vector<Eigen::Vector3f> kept_out;         ///< points in keep-outs, as of a clamp, whose top the shank can meet
  std::vector<Eigen::Vector3f> beside;           ///< other points of the scan that are not of the part; false echoes may be among them
  std::vector<Eigen::Vector3f> standing;         ///< points that are no false echoes: of other parts, of clusters on the part
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr scan; ///< all of it, which tells the false echoes among beside; null: there are none
  bool of_mesh = false;                          ///< the points are samples of a mesh: messages say so

  /** Whether there is nothing. */
  bool empty() const { return keep_outs.empty() && kept_out.empty() && beside.empty() && standing.empty(); }
};

/** What blocks the way of a path. */
enum class BlockedBy {
  KeepOut, ///< the ball enters a keep-out
  KeptOut, ///< the shank cuts into what stands in a keep-out
  Beside   ///< ball or shank cut into what stands beside what is cut
};

/** Why a path that was made is refused. */
struct BlockedWay {
  BlockedBy by = BlockedBy::Beside; ///< what is in the way
  double room = 0.0;                ///< of a keep-out: how much farther away from it the ball should stay, mm
  bool crosses = false;             ///< the path runs over the keep-out, not only a little beyond the last points beside it
};

} // namespace pcl_spiral
