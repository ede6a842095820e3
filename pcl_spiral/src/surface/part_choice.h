// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which of several separate parts of a scan is the part to be machined. Private.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/graph/impl/surface_parts.h>
#include <pcl_spiral/surface/surface.h>

namespace pcl_spiral {

/** The part nearest to settings.part_at, else the one with the largest area. Fails, with the distance, if the place is far from all
 *  parts. */
Status choosePart(const SurfaceGraph& graph, const SurfaceParts& found, const SurfaceSettings& settings, std::size_t& kept);

/** Refuses several large parts if none was chosen: what is wrong may be wrong with another one. */
Status checkChosen(const SurfaceGraph& graph, const SurfaceSettings& settings);

/** Which part was kept of a graph with \p all points, and what was left out: \p left_out points. */
Diagnostic keptPartText(std::size_t all, std::size_t left_out, const SurfaceParts& found, const SurfaceSettings& settings,
                        std::size_t kept);

} // namespace pcl_spiral
