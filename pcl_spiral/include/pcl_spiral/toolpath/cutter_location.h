// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of cutter/cutter_location.h.
 */
#pragma once

#include <pcl_spiral/cutter/cutter_location.h>
