// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The passes of several regions as one result.
 */
#pragma once

#include "planning.h"

#include <vector>

/** The passes of \p regions in their order, and the sums and worst values of their figures. Warnings name their region.
 *  \throw pcl_spiral::FileError if two regions have points in common */
Result joined(const Job& job, std::vector<Result> regions);
