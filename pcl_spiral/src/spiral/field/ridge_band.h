// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The nodes about the ridges of a field, found by distance and by position.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The nodes within 1.4 step-overs of the ridges of a field. */
class RidgeBand {
public:
  explicit RidgeBand(const StepOverDistance& field);

  /** Nodes of the band with distances from \p low to below \p high, ascending. */
  std::vector<std::uint32_t> between(double low, double high) const;
  /** Whether a node is within 1.5 step-overs of the band: loops there may be the nearest to its nodes. */
  bool isNear(std::uint32_t v) const { return is_near_[v] != 0; }

  /** Call \p visit(node) for the nodes of the band and their neighbours within \p reach mm of \p p. */
  template <typename Visit>
  void forNodesNear(const Eigen::Vector3d& p, double reach, Visit visit) const
  {
    const Eigen::Vector3f place = p.cast<float>();
    const auto radius = static_cast<float>(reach);
    Box box;
    box.extend(place.data());
    blocks_.forBlocksNear(box, radius * radius, [&](std::size_t block) {
      for (std::size_t b = blocks_.blockBegin(block); b < blocks_.blockEnd(block); ++b)
        if ((blocks_.point(b) - place).squaredNorm() <= radius * radius)
          visit(about_[blocks_.originalIndex(b)]);
    });
  }

private:
  void sortNodes();
  void findNear();
  void findAbout();

  const StepOverDistance& field_;
  std::vector<std::uint32_t> nodes_;  ///< by the whole step-overs of their distances, then ascending
  std::vector<std::size_t> begin_;    ///< in nodes_, of those from each number of step-overs on; and the end
  std::vector<std::uint8_t> is_near_; ///< one a node of the mesh
  std::vector<std::uint32_t> about_;  ///< nodes of triangles with a node of the band
  PointBlocks blocks_;                ///< of about_
};

} // namespace pcl_spiral
