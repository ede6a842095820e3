// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Refuses a scene whose values do not fit its points.
 */
#pragma once

#include <pcl_spiral/visualization/verification_pictures.h>

namespace pcl_spiral {

/** Returns \p scene. \throw std::invalid_argument if values are given but not one per point, or if \p with_path and there is no
 * path */
VerificationScene checkedScene(VerificationScene scene, bool with_path = true);

} // namespace pcl_spiral
