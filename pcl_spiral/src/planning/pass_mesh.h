// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A mesh as the part of passes.
 */
#pragma once

#include <pcl_spiral/planning/pass_plan.h>

namespace pcl_spiral {

/** What was found in the mesh of \p plan, as warnings. */
void warnOfMesh(PassPlan& plan);

/** Samples the mesh of \p plan for a cutter of \p radius, as the points that leads are checked against. */
Status sampleMesh(double radius, unsigned int threads, PassPlan& plan);

} // namespace pcl_spiral
