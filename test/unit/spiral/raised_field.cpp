// SPDX-License-Identifier: BSD-3-Clause
// A field raised about fingers, against lines and circles.
#include "spiral/loops/raised_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace raised_field_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

const StepOverMetric metric(0.25 * Eigen::Matrix3d::Identity()); // step-overs of 2 mm

FieldPlace
place(double x, double y, double distance)
{
  return {Vector3d(x, y, 0.0), metric, distance};
}

/** A finger along x from -4 to 4 mm. */
RaisedField
finger(int level)
{
  return RaisedField(level, {{{Vector3d(-4.0, 0.0, 0.0), Vector3d(4.0, 0.0, 0.0)}, {metric, metric}}});
}

double
zeroBetween(const RaisedField& field, const FieldPlace& below, const FieldPlace& above)
{
  std::size_t last = NearestSegment::none;
  const double f_below = field.at(below, last), f_above = field.at(above, last);
  EXPECT_LT(f_below, 0.0);
  EXPECT_GE(f_above, 0.0);
  return field.zero(below, above, f_below, f_above);
}

} // namespace

TEST(RaisedField, FarBelowTheLevelAFingersEdgeIsARadiusFromItsAxis)
{
  const RaisedField field = finger(3);
  // Across the side, and past the end along the axis and at 45 degrees.
  const double across = zeroBetween(field, place(1.0, 3.0, 1.0), place(1.0, 0.0, 1.0));
  EXPECT_NEAR(3.0 * (1.0 - across), 2.0 * finger_radius, 1e-3);
  const double along = zeroBetween(field, place(6.0, 0.0, 1.0), place(4.0, 0.0, 1.0));
  EXPECT_NEAR(2.0 * (1.0 - along), 2.0 * finger_radius, 1e-3);
  const double aslant = zeroBetween(field, place(6.0, 2.0, 1.0), place(4.0, 0.0, 1.0));
  EXPECT_NEAR(2.0 * std::sqrt(2.0) * (1.0 - aslant), 2.0 * finger_radius, 1e-3);
}

TEST(RaisedField, FarFromAFingerTheEdgeIsThatOfTheField)
{
  const RaisedField field = finger(3);
  EXPECT_NEAR(zeroBetween(field, place(0.0, 6.0, 2.5), place(1.0, 6.0, 3.3)), 0.5 / 0.8, 1e-3);
}

TEST(RaisedField, IsNowhereBelowTheFieldOrTheFinger)
{
  const RaisedField field = finger(3);
  std::size_t last = NearestSegment::none;
  for (double y = -2.3; y <= 2.3; y += 0.05) // within its reach
    for (double distance = 1.5; distance <= 4.5; distance += 0.05) {
      const double over = distance - 3.0, of_finger = finger_radius - 0.5 * std::abs(y), f = field.at(place(0.0, y, distance), last);
      EXPECT_GE(f, std::max(over, of_finger) - 1e-12);
      EXPECT_LE(f, std::max(over, of_finger) + 0.25 / 4.0 + 1e-12);
    }
}

} // namespace raised_field_test
