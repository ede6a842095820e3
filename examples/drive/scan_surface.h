/** \file
 *  From a scan to the surface that the drive path and the locations share.
 */
#pragma once

#include "planning.h"
#include "terminal/terminal.h"

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/surface/surface.h>

/** What a stage's failure is to the user. \throw UsageError, pcl_spiral::FileError, Cancelled */
void require(const Job& job, const pcl_spiral::Status& status);

/** How the surface is made, whichever stage makes it. */
template <typename Stage>
void
setSurface(const Job& job, Stage& stage)
{
  stage.setLargestPart(job.largest_part);
  stage.setThinning(job.thinning);
  stage.setNumberOfThreads(job.threads);
}

/** The scan less the points off its surface, which are told. */
void leaveOutStrays(const Job& job, Result& result);

/** The surface of the scan; null where the points form none. */
pcl_spiral::Surface::ConstPtr surfaceOf(const Job& job, ProgressBar& bar, const Result& result);
