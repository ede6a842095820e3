// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of spiral/axis_field.h.
 */
#pragma once

#include <pcl_spiral/spiral/axis_field.h>
