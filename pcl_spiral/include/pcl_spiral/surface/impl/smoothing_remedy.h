// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The remedy for a scan with more noise than a surface may have.
 */
#pragma once

#include <pcl_spiral/common/impl/message.h>

#include <string>

namespace pcl_spiral {

/** What to do with points whose \p noise, mm, hides the surface. Thinning does not help: a point that stays keeps its noise. A local
 *  fit with a radius of 20 noises leaves about 0.07 spacings of noise, whatever the spacing is. */
inline std::string
smoothingRemedy(double noise)
{
  constexpr double radius = 20.0; // of the noise
  const std::string value = textOf(radius * noise);
  return "smooth the cloud first: 'pcl_mls_smoothing in.pcd out.pcd -radius " + value +
         "' (package pcl-tools), or pcl::MovingLeastSquares with that search radius, mm";
}

} // namespace pcl_spiral
