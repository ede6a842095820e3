// SPDX-License-Identifier: BSD-3-Clause
// Cutters moved down onto single triangles, against a search in two dimensions.
#include "core/triangle_touch.h"

#include "support/searched_triangle.h"

#include <gtest/gtest.h>

namespace triangle_touch_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(TriangleTouch, IsTheHighestPlaceOfTheTriangle)
{
  Random random(1);
  std::size_t touched = 0;
  for (int i = 0; touched < 10000; ++i) {
    const CutterProfile cutter(randomCutter(random));
    const Matrix3d c = randomTriangle(cutter.radius(), random);
    const TouchedTriangle t = TriangleTouch(cutter).touch(c);
    constexpr double steep = 1e8;
    const double expected = searched(c, cutter, steep);
    if (expected < -1e5 || !t.found) { // beyond the cutter, or by less than a thousandth of a micrometre
      EXPECT_TRUE(!t.found || expected > -1e5) << i;
      EXPECT_TRUE(t.found || expected < 50.0 - 1e-9 * steep) << i << ' ' << expected;
      continue;
    }
    ++touched;
    ASSERT_NEAR(t.height, expected, 1e-6) << i << '\n' << c;
    ASSERT_NEAR(t.weights.sum(), 1.0, 1e-12);
    ASSERT_GE(t.weights.minCoeff(), 0.0);
    const Vector3d p = c * t.weights;
    ASSERT_LE(p.head<2>().norm(), cutter.radius() * (1.0 + 1e-9));
  }
}

TEST(TriangleTouch, AWiderCutterIsTheOneOfSoMuchMoreRadius)
{
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    CutterShape shape = randomCutter(random);
    const CutterProfile cutter(shape);
    const Matrix3d c = randomTriangle(shape.radius, random);
    const double wider = random.uniform(0.0, 1.0);
    shape.radius += wider;
    const TouchedTriangle a = TriangleTouch(cutter).touch(c, wider), b = TriangleTouch(CutterProfile(shape)).touch(c);
    ASSERT_EQ(a.found, b.found);
    if (a.found)
      ASSERT_NEAR(a.height, b.height, 1e-7) << i;
  }
}

} // namespace triangle_touch_test
