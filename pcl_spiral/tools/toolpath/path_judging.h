// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Judges the path that was made (--verify).
 */
#pragma once

#include "outputs.h"

/** Judges the path by the scan or the mesh that it was made from, if the job asks for it. \throw pcl_spiral::FileError, Cancelled */
void judge(const Job& job, Result& result);

/** Whether the planner's surface has all points that the verification needs: none was filtered out. */
bool judgedByTheSameSurface(const pcl_spiral::SpiralSettings& settings);
