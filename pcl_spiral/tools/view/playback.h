// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the window plays.
 */
#pragma once

#include "view_job.h"

#include <pcl_spiral/visualization/spiral_viewer.h>

/** The playback of \p filed, which was judged by \p reference. A path is made by the machine of the job, or by one without limits. \throw
 *  pcl_spiral::FileError as readMachine */
pcl_spiral::PlaybackScene playbackScene(const ViewJob& job, const pcl_spiral::ReferenceSurface& reference,
                                        const pcl_spiral::JudgedPath& judged, FiledPath filed);
