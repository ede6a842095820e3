// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A ridge and arrows on it in pictures. Private to visualization.
 */
#pragma once

#include "display_surface.h"

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include <functional>
#include <vector>

namespace pcl_spiral {

/** Triangles over the ridge with true normals; the values of the point data are \p value at (u, v).
 *  \throw std::invalid_argument without a ridge, or if the ridge is too narrow for triangles */
DisplaySurface ridgeDisplay(const RidgeSurface::ConstPtr& ridge, const std::function<double(double, double)>& value);

/** The corners of the box that also shows \p places. */
void extend(DisplaySurface& surface, const Polyline& places);

/** An arrow as lines: its shaft, and a head that faces a viewer in direction \p towards. */
void addArrow(std::vector<Polyline>& lines, const Eigen::Vector3d& from, const Eigen::Vector3d& arrow, const Eigen::Vector3d& towards);

/** \p steps + 1 places along \p line, or \p steps of a closed one. */
std::vector<double> stationsAlong(const SmoothLine& line, int steps);

/** The generator at \p u. */
Polyline generatorAt(const RidgeSurface& ridge, double u);

} // namespace pcl_spiral
