// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Judges a path file by the exact part.
 */
#pragma once

#include "scene.h"

#include <string>
#include <vector>

namespace pcl_spiral::awkward {

/** What is wrong with the path in \p file; empty: nothing. The ball of the scene is put at each contact and compared with the exact
 *  surface, with the bodies and with samples of the part. \p kept_out: the user keeps out of the bodies. */
std::vector<std::string> faultsOf(const Scene& scene, const std::string& file, bool kept_out);

} // namespace pcl_spiral::awkward
