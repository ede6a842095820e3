// SPDX-License-Identifier: BSD-3-Clause
// Equation (12) on surfaces of known curvature: even fans of neighbours, then the Gabriel neighbours of
// clouds.
#include "spiral/published/taubin_curvature.h"
#include "support/even_cloud.h"
#include "support/surfaces.h"

#include <pcl_spiral/search/impl/gabriel_edges.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace taubin_curvature_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

/** Points of a surface round one of its points, \p reach away in the tangent plane, at equal angles from
 * \p first. */
Polyline
fan(const test::AnalyticSurface& surface, const Vector3d& centre, double reach, int count, double first)
{
  const Vector3d n = surface.normal(centre), u = n.unitOrthogonal(), v = n.cross(u);
  Polyline points;
  for (int k = 0; k < count; ++k) {
    const double a = first + 2.0 * M_PI * k / count;
    points.push_back(surface.closest(centre + reach * (std::cos(a) * u + std::sin(a) * v)));
  }
  return points;
}

TEST(TaubinCurvature, SphereIsExactFromAnyNeighboursInTheMean)
{
  test::Random random(1);
  const double radius = 40.0;
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3d n = Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    Polyline neighbours;
    for (int k = 0; k < 6; ++k)
      neighbours.push_back(radius * (n + 0.1 * Vector3d(random.normal(), random.normal(), random.normal())).normalized());
    const auto outside = taubinCurvatures(radius * n, n, neighbours);
    const auto inside = taubinCurvatures(radius * n, -n, neighbours); // seen from inside: hollow
    ASSERT_TRUE(outside && inside);
    EXPECT_NEAR(0.5 * (outside->larger + outside->smaller), 1.0 / radius,
                1e-12); // every section has the same curvature
    EXPECT_NEAR(0.5 * (inside->larger + inside->smaller), -1.0 / radius, 1e-12);
    EXPECT_GE(outside->larger, outside->smaller);
    EXPECT_NEAR(outside->direction.dot(n), 0.0, 1e-12);
  }
}

TEST(TaubinCurvature, EvenFansGiveTheCurvaturesAndTheirDirection)
{
  const auto sphere = test::ball(50.0, test::Region({test::circle({0, 0}, 30.0)}));
  const auto cylinder = test::cylinder(30.0, test::Region({test::rectangle(40, 100)}));
  const auto saddle = test::quadric(250.0, -200.0, test::Region({test::rectangle(100, 100)}));
  const auto plane = test::flat(test::Region({test::rectangle(100, 100)}));
  struct Case {
    const test::AnalyticSurface& surface;
    Vector3d at, along; ///< the principal direction of the larger curvature; zero: none
  };
  for (const Case& c :
       {Case{*sphere, sphere->lift({12, -7}), Vector3d::Zero()}, Case{*cylinder, cylinder->lift({10, 3}), Vector3d(0, 1, 0)},
        Case{*saddle, saddle->lift({0, 0}), Vector3d(0, 1, 0)}, Case{*plane, plane->lift({3, 4}), Vector3d::Zero()}}) {
    const auto [smallest, largest] = c.surface.principalCurvatures(c.at);
    for (const int count : {5, 6, 8, 13})
      for (const double first : {0.0, 0.4}) {
        const auto found = taubinCurvatures(c.at, c.surface.normal(c.at), fan(c.surface, c.at, 0.2, count, first));
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->larger, largest, 1e-5);
        EXPECT_NEAR(found->smaller, smallest, 1e-5);
        if (&c.surface == cylinder.get()) // the larger one is across the axis
          EXPECT_NEAR(found->direction.dot(c.along), 0.0, 1e-3);
        else if (c.along.norm() > 0.0)
          EXPECT_NEAR(std::abs(found->direction.dot(c.along)), 1.0, 1e-3);
      }
  }
}

TEST(TaubinCurvature, GabrielNeighboursOfClouds)
{
  struct Case {
    const char* name;
    test::SurfacePtr surface;
    double bound; ///< of the median error of either curvature, 1/mm
  };
  const double k = 1.0 / 50.0;
  for (const Case& c : {Case{"sphere", test::ball(50.0, test::Region({test::circle({0, 0}, 30.0)})), 0.5 * k},
                        Case{"cylinder", test::cylinder(50.0, test::Region({test::rectangle(60, 60)})), 0.5 * k},
                        Case{"plane", test::flat(test::Region({test::rectangle(60, 60)})), 1e-6}}) {
    const SurfaceGraph graph = test::graphOf(test::evenPoints(*c.surface, 0.5, 10.0, 5));
    const NeighbourLists edges = ellipticGabrielEdges(graph.blocks().points(), {}, GabrielOptions());
    std::vector<double> errors, middle;
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
      const Vector3d p = graph.position(i);
      if (c.surface->rimDistance(p) < 5.0 * graph.spacing())
        continue;
      const auto found = taubinCurvatures(graph, edges, i);
      ASSERT_TRUE(found);
      const auto [smallest, largest] = c.surface->principalCurvatures(p);
      errors.push_back(std::max(std::abs(found->larger - largest), std::abs(found->smaller - smallest)));
      middle.push_back(found->larger + found->smaller - largest - smallest);
    }
    std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
    std::nth_element(middle.begin(), middle.begin() + middle.size() / 2, middle.end());
    std::printf("  %s: median error %.5f, largest %.5f, of the sum in the median %.6f (%zu points)\n", c.name, errors[errors.size() / 2],
                *std::max_element(errors.begin(), errors.end()), middle[middle.size() / 2], errors.size());
    EXPECT_LT(errors[errors.size() / 2], c.bound);
    EXPECT_LT(std::abs(middle[middle.size() / 2]), 0.05 * k);
  }
}

TEST(TaubinCurvature, NothingFromTwoDirections)
{
  EXPECT_FALSE(taubinCurvatures({0, 0, 0}, {0, 0, 1}, {{1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(taubinCurvatures({0, 0, 0}, {0, 0, 1}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 2}}));
}

} // namespace

} // namespace taubin_curvature_test
