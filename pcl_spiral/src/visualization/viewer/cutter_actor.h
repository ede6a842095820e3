// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The cutter at a point of the path.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

namespace pcl_spiral {

/** A ball of \p radius mm that touches the contact, with a shank along the axis. */
vtkSmartPointer<vtkActor> cutterActor(const ToolpathPoint& point, double radius);

} // namespace pcl_spiral
