// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The regions that a planner goes through.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/planning/part_choice.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** \p regions with names, if there are several; one if none is given. */
std::vector<PlanRegion> namedRegions(std::vector<PlanRegion> regions);

/** \p choice for one \p region. */
PartChoice choiceOf(PartChoice choice, const PlanRegion& region);

/** Moves polygon and place of an only region to the \p choice, where all look for them: given as a region they mean no more. */
void chooseOnly(std::vector<PlanRegion>& regions, PartChoice& choice);

/** Progress of region \p i of \p count. */
ProgressCallback progressOf(const ProgressCallback& whole, std::size_t i, std::size_t count);

/** What is \p said of the region of that \p name; if it is empty, there is one. */
Diagnostic textOfRegion(const std::string& name, const Diagnostic& said);

/** \p warnings with the name of their \p region; as they are if it has none. */
Diagnostics ofRegion(const std::string& region, Diagnostics warnings);

/** Refuses what a mesh cannot have: its own faces say what is cut. */
Status checkPartOfMesh(const PartChoice& choice, const std::vector<PlanRegion>& regions);

} // namespace pcl_spiral
