// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Surfaces and loops of sampled clouds, as input of the stages.
 */
#pragma once

#include "support/sampling.h"

#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/surface/surface.h>

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace pcl_spiral::test {

/** A surface and its outlines. */
struct SurfaceMade {
  std::shared_ptr<const Surface> surface;
  std::vector<BoundaryLoop> loops;
};

inline SurfaceMade
surfaceOf(const std::vector<Eigen::Vector3d>& points)
{
  SurfacePoints given;
  for (const Eigen::Vector3d& p : points)
    given.positions.push_back(p.cast<float>());
  Surface::Parts parts;
  std::vector<std::int8_t> why;
  EXPECT_TRUE(makeSurface(std::move(given), {}, {}, parts, why).ok());
  SurfaceMade made;
  made.surface = std::make_shared<const Surface>(std::move(parts));
  EXPECT_TRUE(findBoundaryLoops(*made.surface, BoundaryOptions(), made.loops).ok());
  return made;
}

inline SurfaceMade
surfaceOf(const AnalyticSurface& part, std::size_t count, std::uint64_t seed)
{
  return surfaceOf(sampleUniform(part, count, seed).points);
}

} // namespace pcl_spiral::test
