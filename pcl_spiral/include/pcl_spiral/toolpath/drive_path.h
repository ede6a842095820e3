// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of drive/drive_path.h.
 */
#pragma once

#include <pcl_spiral/drive/drive_path.h>
