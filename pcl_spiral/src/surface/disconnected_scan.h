// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Scans with many points apart from the surface. Private.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Whether \p point is over or under the surface of the graph, rather than beside it: it is along the normal of the nearest point of the
 *  graph, but for a few spacings. */
bool isOverPart(const SurfaceGraph& graph, const Eigen::Vector3d& point);

/** Refuses \p isolated of \p given points: they are too many to be outliers. */
Status disconnectedRefusal(const SurfaceGraph& graph, const std::vector<Eigen::Vector3f>& isolated, std::size_t given);

} // namespace pcl_spiral
