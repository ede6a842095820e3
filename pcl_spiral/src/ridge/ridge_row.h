// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One row of a tool over a ridge. Private to ridge.
 */
#pragma once

#include <pcl_spiral/ridge/ridge_rows.h>

#include <optional>

namespace pcl_spiral {

struct RidgeRow {
  DrivePass pass;
  std::optional<Eigen::Vector3d>
      backwards; ///< a contact where the tool runs against the travel, because its stand-off is larger than the radius of the hollow
};

/** The row at \p place of the generator, or of the rail for rows across it; \p turned: reversed. */
RidgeRow ridgeRow(const RidgeSurface& surface, const RidgeRowSettings& settings, double place, bool turned);

} // namespace pcl_spiral
