// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Every option of pcl_spiral_toolpath.
 */
#pragma once

#include "job.h"
#include "terminal/option_table.h"

/** The options, bound to \p job. */
OptionTable optionTable(Job& job);
