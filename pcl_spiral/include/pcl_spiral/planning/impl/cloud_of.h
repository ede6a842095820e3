// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A cloud as one of another point type.
 */
#pragma once

#include <pcl/common/io.h>
#include <pcl/point_cloud.h>

#include <type_traits>

namespace pcl_spiral {

/** \p cloud as a cloud of \p Other; null if it is. */
template <typename Other, typename Own>
typename pcl::PointCloud<Other>::ConstPtr
cloudOf(const pcl::shared_ptr<const pcl::PointCloud<Own>>& cloud)
{
  if constexpr (std::is_same_v<Other, Own>)
    return cloud;
  else {
    if (!cloud)
      return nullptr;
    const auto other = pcl::make_shared<pcl::PointCloud<Other>>();
    pcl::copyPointCloud(*cloud, *other);
    return other;
  }
}

} // namespace pcl_spiral
