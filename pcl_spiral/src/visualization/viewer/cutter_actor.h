// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The cutter at a point of the path, and the whole tool.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace pcl_spiral {

/** A ball of \p radius mm that touches the contact, with a shank along the axis. */
vtkSmartPointer<vtkActor> cutterActor(const ToolpathPoint& point, double radius);

/** The cutter with its shank and \p holder, from the flank upwards, in true size: the tip at the origin, the axis along z. Without a holder
 *  a shank as wide as the cutter. */
vtkSmartPointer<vtkActor> toolActor(const CutterShape& cutter, const std::vector<ToolSegment>& holder);

/** Height of its upper end above the tip. */
double toolHeight(const CutterShape& cutter, const std::vector<ToolSegment>& holder);

} // namespace pcl_spiral
