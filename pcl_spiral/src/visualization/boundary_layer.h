// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The cloud with its boundaries and radial lines, in a picture or in the viewer.
 */
#pragma once

#include "part_view.h"

#include <pcl_spiral/spiral/spiral_report.h>

namespace pcl_spiral {

/** Colours for the heights of the drawn surface. */
vtkSmartPointer<vtkScalarsToColors> heightColors(const DisplaySurface& surface);

/** Draws the surface coloured by height, at its points or as faces, and the loops, radial lines and centre of \p report if
 * it has them. Returns the legend. */
std::vector<LegendEntry> addBoundaries(PartView& view, const SpiralReport& report, vtkScalarsToColors* height_colors);

/** "scan.pcd: boundaries and radial lines", if there are any. */
std::string boundariesTitle(const PictureScene& scene);

/** "107198 points, spacing 1.2 mm, noise 0.018 mm", or "1200 faces, 602 vertices" */
std::string partInWords(const PictureScene& scene);

} // namespace pcl_spiral
