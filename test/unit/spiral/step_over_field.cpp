// SPDX-License-Identifier: BSD-3-Clause
// Distances from the rims in step-overs, against formulas on discs, rings and strips.
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include "support/surface_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace step_over_field_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const StepOverOptions options{5.0, 0.1, 0.0};

double
step()
{
  return *stepOver(options.tool_radius, 0.0, options.scallop_height);
}

StepOverDistance
fieldOf(const SurfaceMade& made)
{
  StepOverDistance field;
  const Status status = measureStepOvers(*made.surface, made.loops, options, field);
  EXPECT_TRUE(status.ok()) << status.message();
  return field;
}

/** Distance of \p p from the fitted outlines, mm; from their parts on the side \p side of the x axis, if it is not 0. */
double
rimDistance(const SurfaceMade& made, const Vector3d& p, double side = 0.0)
{
  double least = 1e30;
  for (const BoundaryLoop& loop : made.loops)
    for (std::size_t i = 0; i < loop.curve.size(); ++i) {
      const Vector3d &a = loop.curve[i], d = loop.curve[(i + 1) % loop.curve.size()] - a;
      if (a.y() * side < 0.0)
        continue;
      const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (p - a - t * d).norm());
    }
  return least;
}

void
expectDistances(const SurfaceMade& made, double tolerance)
{
  const StepOverDistance field = fieldOf(made);
  double worst = 0.0, sum = 0.0;
  for (std::size_t v = 0; v < field.mesh.size(); ++v) {
    const double error = std::abs(field.distance[v] - rimDistance(made, field.mesh.positions[v]) / step());
    worst = std::max(worst, error);
    sum += error;
  }
  EXPECT_LT(worst, tolerance);
  EXPECT_LT(sum / static_cast<double>(field.mesh.size()), 0.5 * tolerance); // straight fronts are slightly late in a disc
  for (const std::vector<std::uint32_t>& rim : field.mesh.rims)
    for (const std::uint32_t v : rim)
      EXPECT_EQ(field.distance[v], 0.0);
}

} // namespace

TEST(StepOverField, ADiscsDistancesAreThoseOfThePlane)
{
  expectDistances(surfaceOf(*flat(Region({circle(Vector2d::Zero(), 50.0)})), 4000, 1), 0.25);
}

TEST(StepOverField, AllHolesCount)
{
  const SurfaceMade made =
      surfaceOf(*flat(Region({rectangle(160.0, 90.0), circle({-40.0, 5.0}, 14.0), circle({35.0, -8.0}, 18.0)})), 6000, 2);
  ASSERT_EQ(made.loops.size(), 3u);
  expectDistances(made, 0.25);
}

TEST(StepOverField, TheLeastLengthIsThatOfTheFormula)
{
  const SurfaceMade made = surfaceOf(*flat(Region({rectangle(100.0, 60.0)})), 4000, 3);
  const StepOverDistance field = fieldOf(made);
  const Polyline& rim = made.loops[0].curve; // is a share of the spacing inside the true rim
  double area = 0.0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vector3d &a = rim[i], &b = rim[(i + 1) % rim.size()];
    area += 0.5 * (a.x() * b.y() - b.x() * a.y());
  }
  const double least = area / step() + 0.5 * length(rim, true);
  EXPECT_NEAR(field.least_length, least, 0.002 * least);
  EXPECT_NEAR(field.largest, 30.0 / step(), 0.2);
}

TEST(StepOverField, TheBandAboutRidgesIsFine)
{
  const SurfaceMade made = surfaceOf(*flat(Region({rectangle(100.0, 60.0)})), 1500, 4);
  const StepOverDistance field = fieldOf(made);
  std::size_t beside_ridge = 0, fine = 0;
  for (std::size_t v = 0; v < field.mesh.size(); ++v) {
    const Vector3d& p = field.mesh.positions[v];
    if (std::abs(p.y()) < 0.5 && std::abs(p.x()) < 15.0) {
      ++beside_ridge;
      fine += field.is_fine[v];
    }
  }
  EXPECT_GT(beside_ridge, 100u);
  EXPECT_EQ(fine, beside_ridge);
}

TEST(StepOverField, RidgesAreLinesOfNodesAsHighAsTheFrontsMakeThem)
{
  // Points 1.6 step-overs apart: no triangle of theirs runs along the ridge, and its corners say nothing of its height.
  const SurfaceMade made = surfaceOf(*flat(Region({rectangle(100.0, 60.0)})), 600, 4);
  const StepOverDistance field = fieldOf(made);
  std::vector<double> on_ridge;
  for (std::size_t v = 0; v < field.mesh.size(); ++v) {
    const Vector3d& p = field.mesh.positions[v];
    if (std::abs(p.y()) > step() || std::abs(p.x()) > 15.0)
      continue;
    EXPECT_NEAR(field.distance[v], rimDistance(made, p) / step(), 0.1) << p.transpose(); // a front is late by less
    if (std::abs(rimDistance(made, p, 1.0) - rimDistance(made, p, -1.0)) < 0.04 * step())
      on_ridge.push_back(p.x());
  }
  std::sort(on_ridge.begin(), on_ridge.end());
  ASSERT_GT(on_ridge.size(), 2u);
  EXPECT_LT(on_ridge.front(), -14.0);
  EXPECT_GT(on_ridge.back(), 14.0);
  for (std::size_t i = 1; i < on_ridge.size(); ++i)
    EXPECT_LT(on_ridge[i] - on_ridge[i - 1], 0.5 * step()) << on_ridge[i];
}

TEST(StepOverField, AnOutlineOfAnotherScanIsRefusedWithItsPlace)
{
  SurfaceMade made = surfaceOf(*flat(Region({circle(Vector2d::Zero(), 50.0)})), 3000, 1);
  for (Vector3d& p : made.loops[0].curve)
    p *= 0.4;
  StepOverDistance field;
  const Status status = measureStepOvers(*made.surface, made.loops, options, field);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.message().find("outline through ("), std::string::npos) << status.message();
}

} // namespace step_over_field_test
