// SPDX-License-Identifier: BSD-3-Clause
// Passes joined on a surface given by a function: which passes, on which path, and which stay separate.
#include "mesh/row_links.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace row_links_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

constexpr double radius = 20.0;

/** A point on the sphere; normals and axes show that links contain complete drive points. */
std::optional<DrivePoint>
onSphere(const Vector3d& place)
{
  DrivePoint point;
  point.normal = place.normalized();
  point.position = radius * point.normal;
  point.axis = Vector3d(0.0, 0.6, 0.8);
  return point;
}

DrivePass
arc(double y, bool back)
{
  DrivePass pass;
  for (int i = -10; i <= 10; ++i)
    pass.points.push_back(*onSphere({0.5 * (back ? -i : i), y, 20.0}));
  return pass;
}

DrivePasses
rows(int count)
{
  DrivePasses passes;
  for (int k = 0; k < count; ++k)
    passes.push_back(arc(2.0 * k, k % 2 == 1));
  return passes;
}

} // namespace

TEST(RowLinks, RunOnTheSurfaceAtTheSpacingAsked)
{
  DrivePasses passes = rows(5);
  const RowLinks links = linkRows(passes, {4.0, 0.2, 0.7}, onSphere);
  EXPECT_EQ(links.made, 4U);
  EXPECT_EQ(links.not_made, 0U);
  ASSERT_EQ(passes.size(), 1U);
  EXPECT_EQ(passes[0].points.size(), 5U * 21U + 4U * 2U); // links of about 1.9 mm
  for (std::size_t i = 0; i + 1 < passes[0].points.size(); ++i) {
    const DrivePoint &a = passes[0].points[i], &b = passes[0].points[i + 1];
    EXPECT_NEAR(a.position.norm(), radius, 1e-12);
    EXPECT_NEAR((a.normal - a.position / radius).norm(), 0.0, 1e-12);
    EXPECT_NEAR(a.axis.y(), 0.6, 1e-12);
    EXPECT_LT((b.position - a.position).norm(), 0.7 + 1e-9);
    EXPECT_GT((b.position - a.position).norm(), 0.1);
  }
}

TEST(RowLinks, AreNotMadeOverPlacesThatAreNoSurface)
{
  DrivePasses passes = rows(4);
  const auto slit = [](const Vector3d& place) { // 0.3 mm wide, between the second and the third row
    return std::abs(onSphere(place)->position.y() - 2.9) < 0.15 ? std::nullopt : onSphere(place);
  };
  const RowLinks links = linkRows(passes, {4.0, 0.2, 5.0}, slit);
  EXPECT_EQ(links.made, 2U);
  EXPECT_EQ(links.not_made, 1U);
  ASSERT_EQ(passes.size(), 2U);
  EXPECT_EQ(passes[0].points.size(), 42U); // the spacing needs no point between them
}

TEST(RowLinks, AreNoLongerThanAskedNorLedOffNorMadeToRings)
{
  DrivePasses far = rows(3);
  EXPECT_EQ(linkRows(far, {1.5, 0.2, 0.7}, onSphere).made, 0U);
  EXPECT_EQ(far.size(), 3U);
  DrivePasses off = rows(3);
  const auto other = [](const Vector3d& place) { // another sheet, 5 mm below
    std::optional<DrivePoint> point = onSphere(place);
    point->position *= 0.75;
    return point;
  };
  EXPECT_EQ(linkRows(off, {4.0, 0.2, 0.7}, other).not_made, 2U);
  DrivePasses rings = rows(4);
  rings[1].closed = true;
  const RowLinks links = linkRows(rings, {4.0, 0.2, 0.7}, onSphere);
  EXPECT_EQ(links.made, 1U);
  EXPECT_EQ(links.not_made, 2U);
  EXPECT_TRUE(rings[1].closed);
  EXPECT_EQ(rings[1].points.size(), 21U);
  DrivePasses none;
  EXPECT_EQ(linkRows(none, {4.0, 0.2, 0.7}, onSphere).not_made, 0U);
}

} // namespace row_links_test
