// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines and points coloured by values, for views that can be turned.
 */
#pragma once

#include "path_layer.h"
#include "value_style.h"

#include <cstdint>

namespace pcl_spiral {

/** Lines of a path coloured by the values of its points. */
vtkSmartPointer<vtkActor> valueLines(const PathLines& lines, const std::vector<float>& values, const ValueStyle& style);

/** The given points, coloured by their values. */
vtkSmartPointer<vtkActor> valuePoints(const pcl::PointCloud<pcl::PointXYZ>& points, const std::vector<std::uint32_t>& indices,
                                      const std::vector<float>& values, const ValueStyle& style);

/** The outstanding values, larger: one actor per colour, from the lowest rank up. */
template <typename PointT>
std::vector<vtkSmartPointer<vtkActor>> outstandingPoints(const pcl::PointCloud<PointT>& points, const std::vector<float>& values,
                                                         const ValueStyle& style);

} // namespace pcl_spiral
