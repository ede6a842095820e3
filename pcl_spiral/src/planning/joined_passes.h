// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The passes of several regions as one plan.
 */
#pragma once

#include <pcl_spiral/planning/pass_plan.h>

#include <vector>

namespace pcl_spiral {

/** The passes of \p regions in their order, and the sums and worst values of their figures, in \p all. Warnings name their region. Fails if
 *  two regions have points in common. */
Status joinPasses(const std::vector<PassPlan>& regions, PassPlan& all);

} // namespace pcl_spiral
