// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The figures of a judged path: the one list that JSON, HTML page, terminal and verdicts read.
 */
#pragma once

#include "verify/figure_table.h"
#include <pcl_spiral/verify/verification.h>

namespace pcl_spiral {

/** Every figure of \p verification, in the order of JSON, with its limit from \p limits. */
FigureTable figuresOf(const Verification& verification, const Limits& limits = {});

} // namespace pcl_spiral
