// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The surface of a scan, shared by drive paths and locations.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"
#include "terminal/terminal.h"

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/surface/surface.h>

/** Turns a stage's failure into an exception that names \p file. \throw UsageError, pcl_spiral::FileError, Cancelled */
void require(const std::string& file, const pcl_spiral::Status& status);

/** Settings of the surface for any stage that makes it. */
template <typename Stage>
void
setSurface(const PassJob& job, Stage& stage)
{
  stage.setLargestPart(job.largest_part && !job.choice.part_at);
  stage.setThinning(job.thinning);
  stage.setNumberOfThreads(job.threads);
}

/** Sets the part of a stage: the mesh, or the scan's points and the surface through them. */
template <typename Stage>
void
setPart(const PassJob& job, const PassResult& result, const pcl_spiral::Surface::ConstPtr& surface, Stage& stage)
{
  if (result.mesh) {
    stage.setInputMesh(result.mesh);
    stage.setNumberOfThreads(job.threads);
    return;
  }
  stage.setInputCloud(result.scan.cloud);
  stage.setInputSurface(surface); // null: the stage reports what is wrong
  setSurface(job, stage);
}

/** Reads the scan, without its outliers if asked for, and makes the surface through its points; null if they form
 *  none. \throw UsageError, pcl_spiral::FileError, Cancelled */
pcl_spiral::Surface::ConstPtr readScan(const PassJob& job, ProgressBar& bar, PassResult& result, pcl_spiral::StageClock& clock);

/** Refuses clusters that stand on \p surface, with ClusterHandling::LeaveOut removes them from the scan, and warns of those that stay.
 *  \return the surface of the scan as it is then \throw pcl_spiral::FileError */
pcl_spiral::Surface::ConstPtr heedClusters(const PassJob& job, ProgressBar& bar, const pcl_spiral::Surface::ConstPtr& surface,
                                           PassResult& result);
