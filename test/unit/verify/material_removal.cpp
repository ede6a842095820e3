// SPDX-License-Identifier: BSD-3-Clause
// Stock and gouge from a raw cloud: exact peaks on plane, cylinder and sphere, planted faults, the class.
#include <pcl_spiral/verify/material_removal.h>

#include "support/passes.h"
#include "support/reference.h"
#include "support/removed_material.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace material_removal_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double R = 10.0, h = 0.05, degree = 0.017453292519943295;

pcl_spiral::RemovalReport
measured(const AnalyticSurface& surface, const CheckedPath& path, std::size_t points, double chord_error = 0.0)
{
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(toCloud(sampleUniform(surface, points, 1).points));
  removal.setInputToolpath(toolpath(path));
  removal.setToolRadius(R);
  removal.setScallopHeight(h);
  removal.setChordError(chord_error);
  pcl::PointCloud<pcl::PointXYZI> stock;
  removal.compute(stock);
  EXPECT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
  EXPECT_EQ(stock.size(), points);
  return removal.getReport();
}

SurfacePtr
plane()
{
  return flat(Region({rectangle(58.0, 60.0)}));
}

/** Passes along y on the plane at the exact step. */
CheckedPath
planePasses(const AnalyticSurface& surface, int missing = 99)
{
  std::vector<double> us;
  for (int i = -15; i <= 15; ++i)
    if (i != missing)
      us.push_back(i * exactStepOver(R, h, 0.0));
  return straightPasses(surface, us, 32.0, 2.0);
}

} // namespace

TEST(MaterialRemoval, PeakOnThePlaneIsExact)
{
  const SurfacePtr surface = plane();
  const auto f = measured(*surface, planePasses(*surface), 10000);
  EXPECT_NEAR(f.scallop.max.value / h, 1.0, 0.005);
  EXPECT_NEAR(f.scallop.p50 / h, 1.0, 0.005);
  EXPECT_NEAR(f.scallop.p999 / h, 1.0, 0.005);
  EXPECT_NEAR(f.stock.p50 / h, 0.25, 0.02); // stock grows with the square of the distance from the pass
  EXPECT_LT(f.gouge.value, 1e-5);
  EXPECT_EQ(f.stock.uncut, 0u);
  EXPECT_EQ(f.scallop.share_above, 0.0);
  EXPECT_GT(f.scallop.samples, 3000u);
  EXPECT_NEAR(f.area, 58.0 * 60.0, 0.004 * 58.0 * 60.0);
  EXPECT_NEAR(f.rim_length, 2.0 * (58.0 + 60.0), 1.0);
}

TEST(MaterialRemoval, PeakOnTheCylinderIsExact)
{
  for (const double radius : {50.0, 15.0}) {
    const SurfacePtr surface = cylinder(radius, Region({rectangle(16.0, 40.0)}));
    const double angle = exactStepOver(R, h, 1.0 / radius) / radius;
    std::vector<double> us;
    for (int i = -8; i <= 8; ++i)
      us.push_back(radius * std::sin(i * angle));
    const auto f = measured(*surface, straightPasses(*surface, us, 25.0, 5.0), 20000);
    EXPECT_NEAR(f.scallop.max.value / h, 1.0, 0.005) << radius;
    EXPECT_NEAR(f.scallop.p50 / h, 1.0, 0.005) << radius;
  }
}

TEST(MaterialRemoval, PeakOnTheSphereIsExactOutsideAndInside)
{
  for (const bool convex : {true, false}) {
    const double radius = 50.0, kappa = convex ? 1.0 / radius : -1.0 / radius;
    const SurfacePtr surface = convex ? ball(radius, Region({circle({0, 0}, 30.0)})) : bowl(radius, 30.0);
    const double angle = exactStepOver(R, h, kappa) / radius;
    std::vector<double> radii;
    for (double a = 0.25 * angle; a < std::asin(33.0 / radius); a += angle)
      radii.push_back(radius * std::sin(a));
    const CheckedPath path = circularPasses(*surface, radii, [](double r) { return 24 + static_cast<int>(25.0 * r); });
    const auto f = measured(*surface, path, 30000);
    EXPECT_NEAR(f.scallop.max.value / h, 1.0, 0.005) << convex;
    EXPECT_NEAR(f.scallop.p50 / h, 1.0, 0.005) << convex;
    EXPECT_NEAR(f.rim_length, 2.0 * M_PI * 30.0, 0.3);
    EXPECT_NEAR(f.area / surface->area(), 1.0, 0.004);
    // Straight moves link the circles: on the convex side their chords cut in.
    EXPECT_NEAR(f.gouge.value, convex ? (radius + R) * (1.0 - std::cos(0.5 * angle)) : 0.0, 2e-5);
  }
}

TEST(MaterialRemoval, ASpiralOnADiscLeavesWhatItShouldAtItsBestLength)
{
  const double small = 0.01, disc = 100.0, pitch = exactStepOver(R / 2.0, small, 0.0);
  const SurfacePtr surface = flat(Region({circle({0, 0}, disc)}));
  PassBuilder builder(*surface);
  for (double t = 0.0, r = 0.0; r < disc; t += std::min(0.3, std::sqrt(8.0 * 2e-4 / std::max(r, 0.1)))) {
    r = pitch * t / (2.0 * M_PI);
    builder.add({std::min(r, disc) * std::cos(t), std::min(r, disc) * std::sin(t)}, 0.0);
  }
  const double last = std::atan2(builder.path().contacts.back().y(), builder.path().contacts.back().x());
  for (int i = 1; i <= 3000; ++i)
    builder.add({disc * std::cos(last + 2.0 * M_PI * i / 3000), disc * std::sin(last + 2.0 * M_PI * i / 3000)}, 1.0);
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(toCloud(sampleUniform(*surface, 30000, 1).points));
  removal.setInputToolpath(toolpath(builder.path()));
  removal.setToolRadius(R / 2.0);
  removal.setScallopHeight(small);
  pcl::PointCloud<pcl::PointXYZI> stock;
  removal.compute(stock);
  const auto& f = removal.getReport();
  EXPECT_NEAR(f.scallop.p999 / small, 1.0, 0.01);
  EXPECT_NEAR(f.efficiency, 1.0, 0.01);
  EXPECT_NEAR(f.efficiency, (disc / pitch + 1.0) / (disc / pitch + 2.0), 0.003); // plus one turn along the rim
  EXPECT_NEAR(f.area, M_PI * disc * disc, 0.002 * M_PI * disc * disc);
}

TEST(MaterialRemoval, APartOfAPathIsNoMoreEfficientThanAWhole)
{
  const double disc = 100.0, pitch = exactStepOver(R, h, 0.0);
  const SurfacePtr surface = flat(Region({circle({0, 0}, disc)}));
  for (const double share : {0.02, 0.3, 0.7}) {
    PassBuilder builder(*surface);
    for (double t = 0.0, r = 0.0; r < share * disc; t += std::min(0.3, std::sqrt(8.0 * 2e-4 / std::max(r, 0.1)))) {
      r = pitch * t / (2.0 * M_PI);
      builder.add({r * std::cos(t), r * std::sin(t)}, 0.0);
    }
    const auto f = measured(*surface, builder.path(), 40000);
    EXPECT_LE(f.efficiency, 1.0) << share;
    EXPECT_GT(f.efficiency, share > 0.1 ? 0.9 : 0.0) << share;
    EXPECT_NEAR(f.area, M_PI * disc * disc, 0.005 * M_PI * disc * disc);
  }
}

TEST(MaterialRemoval, AMissingPassIsFoundInItsPlace)
{
  const SurfacePtr surface = plane();
  const auto f = measured(*surface, planePasses(*surface, 5), 10000);
  const double step = exactStepOver(R, h, 0.0);
  EXPECT_NEAR(f.scallop.max.value, R - std::sqrt(R * R - step * step), 1e-3 * h);
  EXPECT_NEAR(f.scallop.max.position.x(), 5.0 * step, 0.01);
  EXPECT_GT(f.scallop.p99, 2.0 * h);
  EXPECT_GT(f.scallop.share_above, 0.03);
}

TEST(MaterialRemoval, FiveMicrometresOfGougeOverAMillimetreAreFound)
{
  const SurfacePtr surface = plane();
  CheckedPath path = planePasses(*surface);
  const std::size_t at = nearestContact(path, {3.0, 7.0, 0.0});
  const Eigen::Vector3d place = path.contacts[at];
  const Eigen::Vector3d feed = (path.contacts[at + 1] - place).normalized();
  const std::vector<double> along{-0.51, -0.5, 0.5, 0.51}, depth{0.0, 0.005, 0.005, 0.0};
  const auto gap = static_cast<std::ptrdiff_t>(at);
  path.contacts.erase(path.contacts.begin() + gap);
  path.normals.resize(path.normals.size() + 3, Eigen::Vector3d::UnitZ());
  for (std::size_t k = 4; k-- > 0;)
    path.contacts.insert(path.contacts.begin() + gap, place + along[k] * feed - depth[k] * Eigen::Vector3d::UnitZ());
  const auto f = measured(*surface, path, 2000); // 1.3 mm between points
  EXPECT_NEAR(f.gouge.value, 0.005, 1e-5);
  EXPECT_LT((f.gouge.position - place).norm(), 0.52);
  EXPECT_GE(f.gouge.index, at);
  EXPECT_LE(f.gouge.index, at + 3);
}

TEST(MaterialRemoval, OnePointOffIsFoundByItsStock)
{
  const SurfacePtr surface = plane();
  CheckedPath path = planePasses(*surface);
  const std::size_t at = nearestContact(path, {-8.0, 4.0, 0.0});
  path.contacts[at].z() += 0.02;
  const double step = exactStepOver(R, h, 0.0);
  double low = 0.0, high = step; // where balls at (0, R + 0.02) and (step, R) meet
  for (int i = 0; i < 60; ++i) {
    const double y = 0.5 * (low + high);
    const bool raised = R + 0.02 - std::sqrt(R * R - y * y) < R - std::sqrt(R * R - (step - y) * (step - y));
    (raised ? low : high) = y;
  }
  const auto f = measured(*surface, path, 2000);
  EXPECT_NEAR(f.scallop.max.value / (R + 0.02 - std::sqrt(R * R - low * low)), 1.0, 0.005);
  EXPECT_LT((f.scallop.max.position - path.contacts[at]).norm(), step);
}

TEST(MaterialRemoval, ATiltedNormalGouges)
{
  const SurfacePtr surface = plane();
  CheckedPath path = planePasses(*surface);
  const std::size_t at = nearestContact(path, {0.0, -12.0, 0.0});
  path.normals[at] = Eigen::Vector3d(std::sin(5 * degree), 0.0, std::cos(5 * degree));
  const auto f = measured(*surface, path, 2000);
  EXPECT_NEAR(f.gouge.value, R * (1.0 - std::cos(5 * degree)), 1e-5);
  EXPECT_LT((f.gouge.position - path.contacts[at]).norm(), 1.0);
  EXPECT_LE(std::max(f.gouge.index, at) - std::min(f.gouge.index, at), 1u);
}

TEST(MaterialRemoval, ReversedNormalsGougeByTheWholeBall)
{
  const SurfacePtr surface = plane();
  CheckedPath path = planePasses(*surface);
  for (Eigen::Vector3d& n : path.normals)
    n = -n;
  const auto f = measured(*surface, path, 2000);
  EXPECT_NEAR(f.gouge.value, 2.0 * R, 1e-3);
  ASSERT_EQ(f.warnings.size(), 1u);
  EXPECT_NE(f.warnings[0].text().find("normals"), std::string::npos);
}

TEST(MaterialRemoval, APathThatIsAllTooDeepLeavesNoRidge)
{
  const SurfacePtr surface = plane();
  CheckedPath path = planePasses(*surface);
  for (std::size_t i = 0; i < path.size(); ++i)
    path.contacts[i] -= 0.2 * path.normals[i];
  const auto f = measured(*surface, path, 2000);
  EXPECT_NEAR(f.gouge.value, 0.2, 1e-3);
  ASSERT_GT(f.scallop.samples, 0u);
  EXPECT_NEAR(f.scallop.max.value, h - 0.2, 0.005 * h);
}

TEST(MaterialRemoval, WhatIsNeverCutIsCounted)
{
  const SurfacePtr surface = plane();
  const CheckedPath all = planePasses(*surface);
  CheckedPath path;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all.contacts[i].x() < 0.0) {
      path.contacts.push_back(all.contacts[i]);
      path.normals.push_back(all.normals[i]);
    }
  const auto f = measured(*surface, path, 10000);
  // From the last pass the ball reaches sqrt(2 R 20 h) far.
  const double band = exactStepOver(R, h, 0.0), limit = 20 * h;
  const double reach = -band + std::sqrt(2 * R * limit - limit * limit);
  EXPECT_NEAR(f.stock.uncutShare(), (29.0 - band - reach) / (58.0 - 2 * band), 0.02);
  EXPECT_GT(f.stock.first_uncut.position.x(), reach - 0.1);
  EXPECT_NEAR(f.stock.max.value, 20 * h, 1e-6);
}

TEST(MaterialRemoval, AgreesWithTheIndependentCheckOnACurvedSurface)
{
  const SurfacePtr surface = quadric(200.0, -120.0, Region({circle({0, 0}, 30.0)}));
  std::vector<double> us;
  for (int i = -15; i <= 15; ++i)
    us.push_back(2.1 * i);
  const CheckedPath path = straightPasses(*surface, us, 32.0, 4.0);
  const auto f = measured(*surface, path, 30000);
  test::RemovalSettings settings;
  settings.tool_radius = R;
  settings.scallop_height = h;
  settings.samples = 20000;
  const auto exact = removedMaterial(*surface, path, settings);
  EXPECT_NEAR(f.stock.p50, exact.stock.p50, 0.01 * h);
  EXPECT_NEAR(f.stock.p90, exact.stock.p90, 0.01 * h);
  EXPECT_NEAR(f.stock.p99, exact.stock.p99, 0.01 * h);
  EXPECT_NEAR(f.scallop.p50, exact.ridge.p50, 0.01 * h);
  EXPECT_NEAR(f.scallop.p99, exact.ridge.p99, 0.01 * h);
  EXPECT_NEAR(f.scallop.max.value, exact.ridge.max.value, 0.01 * h);
  EXPECT_NEAR(f.gouge.value, exact.gouge.value, 0.01 * h);
}

TEST(MaterialRemoval, IndicesAndCloudsThatDoNotFitTheSurfaceAreRefused)
{
  const SurfacePtr surface = quadric(200.0, -120.0, Region({circle({0, 0}, 30.0)}));
  const auto cloud = toCloud(sampleUniform(*surface, 5000, 3).points);
  const auto path = toolpath(straightPasses(*surface, {-3, 0, 3}, 32.0, 3.0));
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  Surface::ConstPtr made;
  scanned.compute(made);
  const auto reference = std::make_shared<ReferenceSurface>(made);
  const auto outcome = [&](bool by_reference, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& given, const pcl::Indices& indices) {
    MaterialRemoval<pcl::PointXYZ> removal;
    removal.setQuiet(true);
    removal.setInputCloud(given);
    if (!indices.empty())
      removal.setIndices(pcl::IndicesPtr(new pcl::Indices(indices)));
    if (by_reference)
      removal.setReferenceSurface(reference);
    else
      removal.setInputSurface(made);
    removal.setInputToolpath(path);
    removal.setToolRadius(R);
    removal.setScallopHeight(h);
    pcl::PointCloud<pcl::PointXYZI> stock;
    removal.compute(stock);
    EXPECT_EQ(stock.empty(), !removal.getStatus().ok());
    EXPECT_TRUE(removal.getStatus().ok() || removal.getStatus().code() == StatusCode::InvalidInput);
    return removal.getStatus().ok() ? std::to_string(stock.size()) : removal.getStatus().message();
  };
  const auto other = toCloud(sampleUniform(*surface, 4000, 3).points);
  for (const bool by_reference : {false, true}) {
    EXPECT_EQ(outcome(by_reference, cloud, {}), "5000");
    EXPECT_EQ(outcome(by_reference, cloud, {0, 5, 4999}), "3");
    EXPECT_EQ(outcome(by_reference, nullptr, {}), "5000");
    for (const pcl::index_t outside : {5000, 50000000, -1})
      EXPECT_NE(outcome(by_reference, cloud, {0, 5, outside}).find("is outside the cloud of 5000 points"), std::string::npos);
    EXPECT_NE(outcome(by_reference, other, {}).find("4000 points, but the surface to judge by was made of a cloud of 5000"),
              std::string::npos);
  }
}

TEST(MaterialRemoval, TheNumberOfThreadsChangesNothing)
{
  const SurfacePtr surface = quadric(200.0, -120.0, Region({circle({0, 0}, 30.0)}));
  const CheckedPath path = straightPasses(*surface, {-20, -17, -15, -12, -9, -6, -4, -2, 0, 2, 5, 8, 11, 14}, 32.0, 3.0);
  const auto cloud = toCloud(sampleUniform(*surface, 10000, 3).points);
  pcl::PointCloud<pcl::PointXYZI> first;
  pcl_spiral::RemovalReport figures;
  for (const int threads : {1, 2, 3}) {
    MaterialRemoval<pcl::PointXYZ> removal;
    removal.setInputCloud(cloud);
    removal.setInputToolpath(toolpath(path));
    removal.setToolRadius(R);
    removal.setScallopHeight(h);
    removal.setNumberOfThreads(threads);
    pcl::PointCloud<pcl::PointXYZI> stock;
    removal.compute(stock);
    const auto& f = removal.getReport();
    if (threads == 1) {
      first = stock;
      figures = f;
      continue;
    }
    ASSERT_EQ(stock.size(), first.size());
    for (std::size_t i = 0; i < stock.size(); ++i)
      ASSERT_TRUE(stock[i].intensity == first[i].intensity || std::isnan(first[i].intensity));
    EXPECT_EQ(f.scallop.max.value, figures.scallop.max.value);
    EXPECT_EQ(f.scallop.max.index, figures.scallop.max.index);
    EXPECT_EQ(f.scallop.p50, figures.scallop.p50);
    EXPECT_EQ(f.gouge.value, figures.gouge.value);
    EXPECT_EQ(f.gouge.index, figures.gouge.index);
    EXPECT_EQ(f.efficiency, figures.efficiency);
  }
}

} // namespace material_removal_test
