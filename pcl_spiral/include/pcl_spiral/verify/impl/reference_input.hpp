#pragma once

#include <pcl_spiral/search/usable_points.h>
#include <pcl_spiral/verify/reference_input.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp> // for point types that PCL has not compiled

namespace pcl_spiral {

template <typename PointT>
Status
ReferenceInput<PointT>::prepare(CutterPath& path)
{
  if (!this->input_ || this->input_->empty())
    return {StatusCode::InvalidInput, "the reference cloud is missing or empty: call setInputCloud with points"};
  const auto& cloud = *this->input_;
  if (normals_ && normals_->size() != cloud.size())
    return {StatusCode::InvalidArgument, "the reference has " + std::to_string(cloud.size()) + " points but " +
                                             std::to_string(normals_->size()) + " normals were given; one a point"};
  if (const Status status = checkIndices(this->indices_.get(), cloud.size()); !status.ok())
    return status;
  if (const Status status = readCutterPath(toolpath_, path); !status.ok())
    return status;
  if (given_surface_) {
    surface_ = given_surface_;
    return Status::success();
  }
  if (progress_ && !progress_(0.0, "reference"))
    return {StatusCode::Cancelled, "cancelled"};
  UsablePoints usable = usablePoints(cloud, this->indices_.get());
  SurfaceGraphOptions options = graph_options_;
  if (normals_)
    options.given_normals = normalsOf(*normals_, usable.source);
  auto made = std::make_shared<ScannedReference>();
  if (const Status status = made->surface.build(std::move(usable.positions), std::move(options)); !status.ok())
    return status;
  made->source = std::move(usable.source);
  surface_ = made;
  return Status::success();
}

} // namespace pcl_spiral
