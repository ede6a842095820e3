// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of cutter/tool_location.h.
 */
#pragma once

#include <pcl_spiral/cutter/tool_location.h>
