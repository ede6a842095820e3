// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of cleaning/stray_removal.h.
 */
#pragma once

#include <pcl_spiral/cleaning/stray_removal.h>
