// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Keep-outs as lines over the part.
 */
#pragma once

#include "part_view.h"

#include <pcl_spiral/visualization/pictures.h>

#include <vector>

namespace pcl_spiral {

/** Draws the outlines of the keep-outs of \p scene in front of the part, as high as the path nearest to them, and adds them to the
 *  legend. */
void addKeepOuts(PartView& view, const PictureScene& scene, std::vector<LegendEntry>& legend);

} // namespace pcl_spiral
