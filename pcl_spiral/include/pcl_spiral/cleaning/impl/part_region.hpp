// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/cleaning/part_region.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/search/impl/point_blocks.h>
#include <pcl_spiral/search/impl/usable_points.h>

#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/impl/pcl_base.hpp>

#include <cmath>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
PartRegion<PointT, PointNT>::check() const
{
  if (crop_ && !crop_->fault().empty())
    return {StatusCode::InvalidArgument, Diagnostic("the polygon of the crop is no area: ", crop_->fault())};
  for (const Prism& prism : keep_outs_)
    if (!prism.fault().empty())
      return {StatusCode::InvalidArgument, Diagnostic("the polygon of a keep-out is no area: ", prism.fault())};
  if (!(tool_radius_ >= 0.0) || !(margin_ >= 0.0))
    return {StatusCode::InvalidArgument, Diagnostic("the tool radius is ", tool_radius_, " {mm} and the margin ", margin_,
                                                    " {mm}: neither may be below 0 ({setToolRadius}, {setMargin})")};
  if (!(shank_length_ >= 0.0) || !(lean_ >= 0.0) || !(lean_ < 90.0))
    return {StatusCode::InvalidArgument, Diagnostic("the shank is ", shank_length_, " {mm} long and leans by ", lean_,
                                                    " {degrees}: give a length of 0 {mm} or more, and 0 to 90 {degrees} ({setShank})")};
  if (normals_ && normals_->size() != this->input_->size())
    return {StatusCode::InvalidInput, Diagnostic("there are ", normals_->size(), " normals for ", this->input_->size(),
                                                 " points: call {setInputNormals} with one a point, or with none")};
  return checkIndices(this->indices_.get(), this->input_->size());
}

template <typename PointT, typename PointNT>
void
PartRegion<PointT, PointNT>::setObstacles(const std::vector<Eigen::Vector3f>& points)
{
  obstacles_ = points.empty() ? nullptr : std::make_shared<PointBlocks>(points);
}

/** Whether a shank above \p centre that leans up to the lean from \p normal can come nearer to an obstacle than the margin. Its axis is
 *  at most s sin(lean) from the place s cos(lean) along the normal. */
template <typename PointT, typename PointNT>
bool
PartRegion<PointT, PointNT>::shankMeets(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal) const
{
  constexpr double step = 0.25, between = 0.01; // of the radius: between places of the axis, what a place between them can be nearer
  if (!obstacles_ || !(tool_radius_ > 0.0))
    return false;
  const double aside = std::sin(lean_ * degree), up = std::cos(lean_ * degree);
  const double farthest = margin_ + tool_radius_ + shank_length_ * (1.0 + aside);
  const Eigen::Vector3f from = centre.cast<float>();
  if (obstacles_->box().squaredDistance(from.data()) > static_cast<float>(farthest * farthest))
    return false;
  for (double s = 0.0; s <= shank_length_; s += step * tool_radius_) {
    const Eigen::Vector3d place = centre + s * up * normal;
    const double reach = margin_ + (1.0 + between) * tool_radius_ + s * aside;
    if ((obstacles_->position(obstacles_->nearest(place)) - place).squaredNorm() < reach * reach)
      return true;
  }
  return false;
}

/** Whether point \p i is to be cut; counts it otherwise. */
template <typename PointT, typename PointNT>
bool
PartRegion<PointT, PointNT>::keeps(std::size_t i)
{
  const PointT& point = (*this->input_)[i];
  if (!pcl::isFinite(point))
    return false;
  const Eigen::Vector3d p = point.getVector3fMap().template cast<double>();
  if ((crop_box_ && !crop_box_->contains(p)) || (crop_ && !crop_->contains(p))) {
    ++figures_.cropped;
    return false;
  }
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  if (normals_)
    normal = (*normals_)[i].getNormalVector3fMap().template cast<double>();
  const bool known = normal.squaredNorm() > 0.0;
  const Eigen::Vector3d centre = known ? Eigen::Vector3d(p + tool_radius_ * normal.normalized()) : p;
  const double least = margin_ + (known ? 1.0 : 2.0) * tool_radius_;
  for (const Prism& prism : keep_outs_)
    if (prism.distance(centre) <= least) {
      ++(prism.contains(p) ? figures_.kept_out : figures_.too_close);
      return false;
    }
  if (known && shankMeets(centre, normal.normalized())) {
    ++figures_.too_close;
    return false;
  }
  return true;
}

template <typename PointT, typename PointNT>
void
PartRegion<PointT, PointNT>::applyFilter(pcl::PointCloud<PointT>& output)
{
  const struct Mark {
    bool& is_set;
    ~Mark() { is_set = false; }
  } mark{into_cloud_ = true};
  StatusFilter<PointT>::applyFilter(output);
}

template <typename PointT, typename PointNT>
Status
PartRegion<PointT, PointNT>::choose(pcl::Indices& kept, pcl::Indices& removed)
{
  if (const Status status = check(); !status.ok())
    return status;
  if (into_cloud_ && !keep_outs_.empty() && !this->negative_)
    return {StatusCode::InvalidArgument,
            "there are keep-outs ({addKeepOut}), which a cloud does not carry on, so that a path over it would "
            "cross them: call filter with pcl::Indices, and give scan, indices and keep-outs to the planner "
            "({setInputCloud}, {setIndices}, {setSurroundings})"};
  for (const auto index : *this->indices_)
    (keeps(static_cast<std::size_t>(index)) ? kept : removed).push_back(index);
  return Status::success();
}

} // namespace pcl_spiral
