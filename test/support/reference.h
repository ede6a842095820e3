// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Clouds and paths on exact surfaces, for the classes that check paths.
 */
#pragma once

#include "support/checked_path.h"
#include "support/sampling.h"

#include <pcl_spiral/verify/impl/material_removal_engine.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <vector>

namespace pcl_spiral::test {

inline std::vector<Eigen::Vector3f>
asFloats(const Sampled& sampled)
{
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3d& p : sampled.points)
    points.push_back(p.cast<float>());
  return points;
}

inline CutterPath
cutterPath(const CheckedPath& path)
{
  return {path.contacts, path.normals, {}};
}

inline pcl::PointCloud<ToolpathPoint>::Ptr
toolpath(const CheckedPath& path)
{
  pcl::PointCloud<ToolpathPoint>::Ptr cloud(new pcl::PointCloud<ToolpathPoint>);
  for (std::size_t i = 0; i < path.size(); ++i) {
    ToolpathPoint p;
    p.getVector3fMap() = path.contacts[i].cast<float>();
    p.getNormalVector3fMap() = path.normals[i].cast<float>();
    p.getAxisVector3fMap() = path.normals[i].cast<float>();
    cloud->push_back(p);
  }
  return cloud;
}

/** Index of the contact nearest to a place. */
inline std::size_t
nearestContact(const CheckedPath& path, const Eigen::Vector3d& p)
{
  std::size_t best = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    if ((path.contacts[i] - p).norm() < (path.contacts[best] - p).norm())
      best = i;
  return best;
}

} // namespace pcl_spiral::test
