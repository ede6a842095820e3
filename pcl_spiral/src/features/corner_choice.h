// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which corners of an outline are real. Private to features.
 */
#pragma once

#include "outline_draft.h"

namespace pcl_spiral {

/** Drop corners that a smooth side explains as well, and put corners where one explains a side's bend better. */
void chooseCorners(OutlineDraft& draft);

} // namespace pcl_spiral
