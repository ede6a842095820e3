/** \file
 *  The cloud with its boundaries and radial lines, on a picture or in the viewer.
 */
#pragma once

#include "part_view.h"

#include <pcl_spiral/toolpath/spiral_report.h>

namespace pcl_spiral {

/** Colours of the drawn surface's heights. */
vtkSmartPointer<vtkScalarsToColors> heightColors(const DisplaySurface& surface);

/** The surface, its points coloured by height, the loops, the radial lines and the centre of \p report as far
 * as it has them. Returns the legend. */
std::vector<LegendEntry> addBoundaries(PartView& view, const SpiralReport& report,
                                       vtkScalarsToColors* height_colors);

/** "scan.pcd: boundaries and radial lines", as far as there are any. */
std::string boundariesTitle(const std::string& title, const SpiralReport& report);

/** "107198 points, spacing 1.2 mm, noise 0.018 mm" */
std::string scanInWords(const SpiralReport& report);

} // namespace pcl_spiral
