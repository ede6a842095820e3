// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>
#include <pcl_spiral/verify/impl/reference_input.h>

#include <cmath>

namespace pcl_spiral {

template <typename PointT>
Status
ReferenceInput<PointT>::prepare(CutterPath& path)
{
  reference_.reset();
  if (const Status status = readCutterPath(toolpath_, path, passes_); !status.ok())
    return status;
  if (const Status status = this->checkShared(); !status.ok())
    return status;
  if (given_reference_) {
    reference_ = given_reference_;
    return Status::success();
  }
  if (progress_ && !progress_(0.0, "reference"))
    return {StatusCode::Cancelled, "cancelled"};
  if (this->on_mesh_)
    return prepareMeshReference(path);
  Surface::ConstPtr surface;
  if (const Status status = this->prepareSurface(surface); !status.ok())
    return status;
  if (const Status status = this->checkMeasured(*surface, "and a guess is no reference"); !status.ok())
    return status;
  reference_ = std::make_shared<ReferenceSurface>(surface);
  return Status::success();
}

template <typename PointT>
Status
ReferenceInput<PointT>::prepareMeshReference(const CutterPath& path)
{
  if (const Diagnostic setter = disagreement(this->surfaceSettings(), SurfaceSettings()); !setter.empty() || this->getInputNormals())
    return {StatusCode::InvalidArgument, Diagnostic((setter.empty() ? "{setInputNormals}" : setter),
                                                    " was called beside {setInputMesh}: it belongs to scans, and a mesh's side is "
                                                    "that of its faces; leave it, or turn them over ({MeshSettings::flip})")};
  if (!(sample_spacing_ >= 0.0) || !std::isfinite(sample_spacing_))
    return {StatusCode::InvalidArgument,
            Diagnostic("the sample spacing is ", sample_spacing_, " {mm}; set it above 0, or to 0 to have it chosen ({setSampleSpacing})")};
  if (const Status status = this->prepareMesh(mesh_settings_); !status.ok())
    return status;
  ReferenceMesh::ConstPtr samples;
  if (const Status status = ReferenceMesh::make(this->mesh_, path, sample_spacing_, samples); !status.ok())
    return status;
  return ReferenceSurface::make(samples, progress_, reference_);
}

} // namespace pcl_spiral
