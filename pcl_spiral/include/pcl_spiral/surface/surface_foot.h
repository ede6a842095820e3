// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of fit/surface_foot.h.
 */
#pragma once

#include <pcl_spiral/fit/surface_foot.h>
