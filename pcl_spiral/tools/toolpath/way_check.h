// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether the ball or its shank enters what is not to be cut.
 */
#pragma once

#include "job.h"
#include "outputs.h"

/** Warns of single points beside the part in the way, which are taken for false echoes.
 *  \throw pcl_spiral::FileError if the ball enters a keep-out, or cuts into the scan beside it or beside the crop */
void checkWay(const Job& job, Result& result);
