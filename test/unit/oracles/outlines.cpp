// SPDX-License-Identifier: BSD-3-Clause
// The outlines: areas by formula, simple and counter-clockwise, wide enough, slightly varied.
#include "support/outlines.h"
#include "support/checked_path.h"
#include "support/outline_loops.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace outlines_test {

using namespace pcl_spiral::test;

namespace {

constexpr double pi = 3.14159265358979323846;

double
signedArea(const PlaneLoop& loop)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
    sum += 0.5 * (a.x() * b.y() - b.x() * a.y());
  }
  return sum;
}

/** Largest distance from the rim over a sample of the part. */
double
inradius(const AnalyticSurface& part)
{
  double deepest = 0.0;
  for (const Eigen::Vector3d& x : sampleUniform(part, 20000, 3).points)
    deepest = std::max(deepest, part.rimDistance(x));
  return deepest;
}

} // namespace

TEST(OutlineLoops, HaveTheAreasOfTheirFormulas)
{
  const double open = std::asin(14.0 / 45.0); // half the angle that a neck removes from a disc
  const double cap = 45.0 * 45.0 * (open - std::sin(open) * std::cos(open));
  const double neck = 28.0 * 2.0 * (65.0 - 45.0 * std::cos(open));
  EXPECT_NEAR(signedArea(dumbbell(45.0, 65.0, 14.0)), 2.0 * (pi * 45.0 * 45.0 - cap) + neck, 0.1);
  EXPECT_NEAR(signedArea(cross(220.0, 66.0)), 2.0 * 220.0 * 66.0 - 66.0 * 66.0, 1e-9);
  EXPECT_NEAR(signedArea(uShape(210.0, 200.0, 70.0)), 210.0 * 200.0 - 70.0 * 130.0, 1e-9);
  EXPECT_NEAR(signedArea(smoothStar(5, 75.0, 25.0)), pi * (75.0 * 75.0 + 0.5 * 25.0 * 25.0), 0.1);
  EXPECT_NEAR(signedArea(band(115.0, 82.0, 150.0)), 115.0 * 82.0 * 150.0 / 180.0 * pi + pi * 41.0 * 41.0, 0.5);
  const double slit = 8.0 * 105.0 + 0.5 * pi * 16.0; // minus a sliver at the rim
  EXPECT_NEAR(signedArea(slitDisc(105.0, 8.0)), pi * 105.0 * 105.0 - slit, 0.5);
  EXPECT_NEAR(signedArea(superellipse(120.0, 80.0, 2.0)), pi * 120.0 * 80.0, 0.1);
  EXPECT_GT(signedArea(superellipse(120.0, 80.0, 3.0)), 1.1 * pi * 120.0 * 80.0);
}

TEST(OutlineLoops, BentLoopsKeepTheirCornersWhereTheyAreMovedTo)
{
  const PlaneLoop fine = bent(cross(220.0, 66.0), 0.5, [](const Eigen::Vector2d& u) { return 2.0 * u; });
  EXPECT_NEAR(signedArea(fine), 4.0 * signedArea(cross(220.0, 66.0)), 1e-6);
  for (std::size_t i = 0; i < fine.size(); ++i)
    EXPECT_LE((fine[(i + 1) % fine.size()] - fine[i]).norm(), 1.0 + 1e-9);
}

TEST(Outlines, AreSurfacesOfTwentyPassesAndMore)
{
  for (const std::string& name : outlineNames()) {
    const SurfacePtr part = outlinedPart(name);
    for (const PlaneLoop& loop : part->region().loops())
      EXPECT_GT(signedArea(loop), 0.0) << name;
    double area = signedArea(part->region().loops().front());
    for (std::size_t i = 1; i < part->region().loops().size(); ++i)
      area -= signedArea(part->region().loops()[i]);
    const double by_rows = part->region().integrate([](const Eigen::Vector2d&) { return 1.0; });
    EXPECT_NEAR(by_rows / area, 1.0, 0.003) << name; // different if loops cross
    EXPECT_GT(inradius(*part) / exactStepOver(5.0, 0.1, 0.0), 20.0) << name;
  }
  EXPECT_THROW(outlinedPart("none"), std::out_of_range);
}

TEST(Outlines, VaryBySeedAndScaleAsAWhole)
{
  for (const std::string& name : outlineNames()) {
    const SurfacePtr drawn = outlinedPart(name), one = outlinedPart(name, 1), again = outlinedPart(name, 1);
    EXPECT_EQ(one->region().loops(), again->region().loops()) << name;
    EXPECT_EQ(one->region().loops().size(), drawn->region().loops().size()) << name;
    EXPECT_NE(one->region().upper(), outlinedPart(name, 2)->region().upper()) << name;
    const double ratio = one->area() / drawn->area();
    EXPECT_GT(ratio, 0.6) << name;
    EXPECT_LT(ratio, 1.45) << name;
    const SurfacePtr half = outlinedPart(name, 0, 0.5);
    EXPECT_NEAR(half->area() / drawn->area(), 0.25, 1e-6) << name;
    const auto [least, most] = drawn->principalCurvatures(drawn->lift({20.0, 30.0}));
    const auto [least_half, most_half] = half->principalCurvatures(half->lift({10.0, 15.0}));
    EXPECT_NEAR(least_half, 2.0 * least, 1e-9) << name;
    EXPECT_NEAR(most_half, 2.0 * most, 1e-9) << name;
  }
}

} // namespace outlines_test
