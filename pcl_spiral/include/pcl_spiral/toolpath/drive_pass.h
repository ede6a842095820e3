// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of common/drive_pass.h.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
