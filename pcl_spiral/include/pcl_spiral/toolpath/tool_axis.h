// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of spiral/tool_axis.h.
 */
#pragma once

#include <pcl_spiral/spiral/tool_axis.h>
