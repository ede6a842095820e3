// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Former place of MoveIndex.
 */
#pragma once

#include <pcl_spiral/search/impl/move_index.h>
