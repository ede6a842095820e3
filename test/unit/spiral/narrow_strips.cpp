// SPDX-License-Identifier: BSD-3-Clause
// The strips that a keep-out leaves beside the rim: against the exact width of a crescent between two circles.
#include "surface/narrow_strips.h"

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace narrow_strips_test {

using namespace pcl_spiral;
using Eigen::Vector2d;

namespace {

constexpr double outer = 40.0, inner = 20.0; // mm
const Vector2d centre(17.0, 0.0);            // of the inner circle: between the circles the crescent is 3 mm wide at +x

/** Points of a flat disc that \p within accepts. */
template <typename Within>
SurfaceGraph
disc(Within within)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-outer, outer);
  std::vector<Eigen::Vector3f> points;
  while (points.size() < 8000)
    if (const Vector2d p(unit(random), unit(random)); p.norm() < outer && within(p))
      points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0f);
  SurfaceGraph graph;
  EXPECT_TRUE(graph.build(points, {}).ok());
  return graph;
}

/** Width of the crescent along the ray from the middle of the inner circle through \p p. */
double
widthAt(const Vector2d& p)
{
  const Vector2d way = (p - centre).normalized();
  const double along = centre.dot(way);
  return -along + std::sqrt(along * along - centre.squaredNorm() + outer * outer) - inner;
}

} // namespace

TEST(NarrowStrips, TheThinEndOfACrescentIsNarrowAndTheRestIsNot)
{
  const SurfaceGraph graph = disc([](const Vector2d&) { return true; });
  std::vector<std::uint8_t> kept(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i)
    kept[i] = (graph.position(i).head<2>() - centre).norm() > inner;
  constexpr double width = 6.0;
  const std::vector<std::uint8_t> narrow = narrowStrips(graph, kept, width);
  int found = 0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const double here = widthAt(graph.position(i).head<2>());
    if (!kept[i])
      EXPECT_EQ(narrow[i], 0);
    else if (here < width - 3.0 * graph.spacing())
      EXPECT_EQ(narrow[i], 1) << here << " mm wide at " << graph.position(i).transpose();
    else if (here > width + 4.0 * graph.spacing())
      EXPECT_EQ(narrow[i], 0) << here << " mm wide at " << graph.position(i).transpose();
    found += narrow[i];
  }
  EXPECT_GT(found, 50);
}

TEST(NarrowStrips, WhatWasNarrowBeforeStays)
{
  const SurfaceGraph graph = disc([](const Vector2d& p) { return (p - centre).norm() > inner; });
  const std::vector<std::uint8_t> narrow = narrowStrips(graph, std::vector<std::uint8_t>(graph.size(), 1), 6.0);
  EXPECT_EQ(std::count(narrow.begin(), narrow.end(), 1), 0);
}

} // namespace narrow_strips_test
