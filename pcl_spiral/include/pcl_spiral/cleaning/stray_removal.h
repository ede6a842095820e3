// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of cleaning/outlier_removal.h.
 */
#pragma once

#include <pcl_spiral/cleaning/outlier_removal.h>
