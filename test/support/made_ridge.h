// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Makes a ridge; the test fails if it cannot be made.
 */
#pragma once

#include <pcl_spiral/ridge/ridge_surface.h>

#include <gtest/gtest.h>

namespace pcl_spiral::test {

inline RidgeSurface::ConstPtr
madeRidge(const Polyline& rail, const Polyline& generator, const RidgeSettings& settings = {})
{
  RidgeSurface::ConstPtr surface;
  const Status status = RidgeSurface::make(rail, generator, settings, surface);
  EXPECT_TRUE(status.ok()) << status.message();
  return surface;
}

} // namespace pcl_spiral::test
