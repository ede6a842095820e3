// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distances from the creases of a mesh.
 */
#pragma once

#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/search/impl/move_index.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** The creases of a mesh between two chosen faces, as lines for searching. */
class CreaseLines {
public:
  /** \p chosen: not 0 for each face that counts; empty: all. */
  explicit CreaseLines(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen = {});
  CreaseLines(const CreaseLines&) = delete; // the index refers to the lines
  CreaseLines& operator=(const CreaseLines&) = delete;

  bool empty() const { return line_.empty(); }
  /** Length of all creases, mm. */
  double length() const { return length_; }
  /** Distance from the nearest crease, at most \p limit. */
  double distance(const Eigen::Vector3d& p, double limit) const;

private:
  Polyline line_;                      ///< pieces of creases, joined where one does not begin at the end of the one before
  std::vector<std::uint8_t> is_joint_; ///< of the segment that begins here
  std::unique_ptr<MoveIndex> index_;
  double length_ = 0.0;
};

} // namespace pcl_spiral
