// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/drive/impl/drive_path_engine.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>

#include <utility>

namespace pcl_spiral {

template <typename PointT>
Status
DrivePath<PointT>::runOnMesh(DrivePasses& passes)
{
  if (const Status status =
          checkBesideMesh(this->surfaceSettings(), this->scanned_.getInputNormals() != nullptr, this->givenIndices() != nullptr);
      !status.ok())
    return status;
  if (const Status status = checkSettings(settings_); !status.ok())
    return status;
  if (const Status status = this->prepareMesh(MeshSettings()); !status.ok())
    return status;
  return planMeshDrive(this->mesh_, settings_, progress_, passes, report_);
}

template <typename PointT>
Status
DrivePath<PointT>::run(DrivePasses& passes)
{
  if (const Status status = checkThreads(this->getNumberOfThreads()); !status.ok())
    return status;
  const ThreadLimit limit(this->getNumberOfThreads());
  if (this->on_mesh_)
    return runOnMesh(passes);
  if (settings_.needsSurface())
    if (const Status status = this->checkInput(); !status.ok())
      return status;
  if (const Status status = checkSettings(settings_); !status.ok())
    return status;
  Surface::ConstPtr surface;
  if (settings_.needsSurface())
    if (const Status status = this->prepareSurface(surface, partOf(progress_, 0.0, 0.6)); !status.ok())
      return status;
  return planDrive(surface, settings_, partOf(progress_, 0.6, 1.0), passes, report_);
}

template <typename PointT>
void
DrivePath<PointT>::compute(DrivePasses& passes)
{
  passes.clear();
  report_ = DriveReport();
  DrivePasses made;
  if (this->computeBy("DrivePath", [&] { return run(made); }))
    passes = std::move(made);
}

} // namespace pcl_spiral
