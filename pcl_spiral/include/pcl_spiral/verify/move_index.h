/** \file
 *  Former place of MoveIndex.
 */
#pragma once

#include <pcl_spiral/search/move_index.h>
