// SPDX-License-Identifier: BSD-3-Clause
// The work that the distance in step-overs takes, counted in visits of nodes, and how soon it ends when it is cancelled.
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include "support/surface_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace step_over_cost_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double tool_radius = 4.0;
constexpr double visits_a_call = 4096.0; // of the progress callback, by its description

/** A disc with points at random places: some are close together, so that the mesh has thin triangles. */
SurfaceMade
unevenDisc(double noise)
{
  std::vector<Eigen::Vector3d> points = sampleUniform(*flat(Region({circle({0, 0}, 25.0)})), 400, 3).points;
  Random random(3);
  for (Eigen::Vector3d& p : points)
    p += Eigen::Vector3d(0.9 * random.normal(), 0.9 * random.normal(), noise * random.normal());
  return surfaceOf(points);
}

/** Visits of each node of the field, mean over the nodes. */
double
meanVisits(const SurfaceMade& made, double scallop, StepOverDistance& field)
{
  std::size_t calls = 0;
  const Status status =
      measureStepOvers(*made.surface, made.loops, {tool_radius, scallop, 0.0}, field, [&](double share, const std::string&) {
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
        ++calls;
        return true;
      });
  EXPECT_TRUE(status.ok()) << status.message();
  return visits_a_call * static_cast<double>(calls) / static_cast<double>(field.mesh.size());
}

/** Largest difference between the distances and those of the plane from the outline, mm. */
double
largestError(const SurfaceMade& made, double scallop, const StepOverDistance& field)
{
  const Polyline& rim = made.loops.at(0).curve;
  const double step = *stepOver(tool_radius, 0.0, scallop);
  double worst = 0.0;
  for (std::size_t v = 0; v < field.mesh.size(); v += 7) {
    const Eigen::Vector3d& p = field.mesh.positions[v];
    double least = 1e30;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Eigen::Vector3d &a = rim[i], d = rim[(i + 1) % rim.size()] - a;
      least = std::min(least, (p - a - std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) * d).norm());
    }
    worst = std::max(worst, std::abs(field.distance[v] * step - least));
  }
  return worst;
}

} // namespace

TEST(StepOverCost, ThinTrianglesAreNotCorrectedWithoutEnd)
{
  const SurfaceMade made = unevenDisc(0.45);
  StepOverDistance field;
  const double wide = meanVisits(made, 0.02, field);
  const std::size_t nodes = field.mesh.size();
  const double narrow = meanVisits(made, 0.005, field);
  EXPECT_GT(field.mesh.size(), 2 * nodes);
  EXPECT_GE(wide, 1.0 - visits_a_call / static_cast<double>(nodes)); // every node is visited
  EXPECT_LT(wide, 3.0);                                              // by three marches: on the mesh as it is, and behind either cut
  EXPECT_LT(narrow, 1.1 * wide);                                     // the cost grows as the nodes do
}

TEST(StepOverCost, DistancesStayThoseOfThePlane)
{
  const SurfaceMade made = unevenDisc(0.0);
  StepOverDistance field;
  // A round front is early by e^2/8r over an edge e, from the rim to radius r together by e/8 of e/r, and edges are cut where it turns by
  // more than 20 degrees over one, r < 2.9 e: 4 % of the spacing, and 4 % of the edges once cut. The rim has edges, too.
  for (const double scallop : {0.02, 0.005}) { // a share of the spacing, not of a step-over
    meanVisits(made, scallop, field);
    EXPECT_LT(largestError(made, scallop, field), made.surface->spacing() / 7.0);
  }
}

TEST(StepOverCost, ItEndsAtTheFirstCallThatCancels)
{
  const SurfaceMade made = unevenDisc(0.45);
  StepOverDistance field;
  const auto runUntil = [&](std::size_t last) {
    std::size_t calls = 0;
    const Status status = measureStepOvers(*made.surface, made.loops, {tool_radius, 0.002, 0.0}, field,
                                           [&](double, const std::string&) { return ++calls < last; });
    return std::make_pair(status.code(), calls);
  };
  const auto [whole, all] = runUntil(1000000);
  ASSERT_EQ(whole, StatusCode::Ok);
  ASSERT_GT(all, 20u);
  for (const std::size_t last : {std::size_t{1}, std::size_t{2}, std::size_t{3}, all / 2, all}) {
    const auto [code, calls] = runUntil(last);
    EXPECT_EQ(code, StatusCode::Cancelled) << last;
    EXPECT_EQ(calls, last);
  }
}

} // namespace step_over_cost_test
