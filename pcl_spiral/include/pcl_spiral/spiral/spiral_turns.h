// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of makeTurns: spiral/spiral_path.h.
 */
#pragma once

#include <pcl_spiral/spiral/spiral_path.h>
