// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of spiral/spiral_toolpath_generator.h.
 */
#pragma once

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
