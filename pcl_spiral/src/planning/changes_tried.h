// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A refused input tried with single changes. Private to planning.
 */
#pragma once

#include "planning/single_change.h"

#include <functional>

namespace pcl_spiral {

/** Plans an input that was changed. */
using PlanChanged = std::function<Status(const PlanInput&, SpiralPlan&)>;

/** What to add to the \p refusal of \p input after \p attempts: the first change with which \p plan gives a path that passes all checks,
 *  with its length and what it leaves: a single one, else two together; or which changes were tried, and the place that another scan has
 *  to show. A path over less than a tenth of the points is no remedy. The search ends when it has taken about as long as
 *  PlanInput::remedy_tries paths, or when the progress callback of \p input asks for it. */
Diagnostic changeThatHelps(const PlanInput& input, const Status& refusal, const std::vector<PlanAttempt>& attempts,
                           const PlanChanged& plan);

/** Whether the path of \p plan cuts nothing that its scan shows: its points show what the ball passes between, and the ball stays out of
 *  all points of the whole scan but single false echoes. */
bool isClear(const SpiralPlan& plan);

} // namespace pcl_spiral
