#pragma once

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>
#include <pcl_spiral/verify/reference_input.h>

namespace pcl_spiral {

template <typename PointT>
Status
ReferenceInput<PointT>::prepare(CutterPath& path)
{
  reference_.reset();
  if (const Status status = readCutterPath(toolpath_, path); !status.ok())
    return status;
  if (const Status status = this->checkShared(); !status.ok())
    return status;
  if (given_reference_) {
    reference_ = given_reference_;
    return Status::success();
  }
  if (progress_ && !progress_(0.0, "reference"))
    return {StatusCode::Cancelled, "cancelled"};
  Surface::ConstPtr surface;
  if (const Status status = this->prepareSurface(surface); !status.ok())
    return status;
  if (surface->counts().guessed > 0)
    return {StatusCode::InvalidInput,
            textOf("the surface has ", surface->counts().guessed, " points that were put into gaps, and a guess is no reference: "
                   "give the surface as it was before GapBridging")};
  reference_ = std::make_shared<ReferenceSurface>(surface);
  return Status::success();
}

} // namespace pcl_spiral
