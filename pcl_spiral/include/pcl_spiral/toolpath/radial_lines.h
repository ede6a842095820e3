// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of spiral/radial_lines.h.
 */
#pragma once

#include <pcl_spiral/spiral/radial_lines.h>
