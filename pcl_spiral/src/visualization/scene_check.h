// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A scene whose values do not fit its points is refused.
 */
#pragma once

#include <pcl_spiral/visualization/verification_pictures.h>

namespace pcl_spiral {

/** \p scene itself. \throw std::invalid_argument where values are given but not one a point, or without a
 * path */
VerificationScene checkedScene(VerificationScene scene);

} // namespace pcl_spiral
