// SPDX-License-Identifier: BSD-3-Clause
// Axes fitted to columns of known shape, moved at random.
#include "core/revolution_axis.h"

#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace revolution_axis_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

struct Cloud {
  std::vector<Vector3d> points, normals;
  std::vector<double> weights;
};

/** Column of the radius \p radius(z, angle) about z, normals by differences with \p noise radians,
 * then moved. */
Cloud
column(const std::function<double(double, double)>& radius, double height, double sector, double noise, const Eigen::Isometry3d& motion,
       std::uint64_t seed)
{
  Random random(seed);
  const auto place = [&](double z, double a) { return Vector3d(radius(z, a) * std::cos(a), radius(z, a) * std::sin(a), z); };
  Cloud cloud;
  for (int i = 0; i < 5000; ++i) {
    const double z = random.uniform(-0.5 * height, 0.5 * height), a = random.uniform(0.0, sector), h = 1e-5;
    Vector3d n = (place(z, a + h) - place(z, a - h)).cross(place(z + h, a) - place(z - h, a)).normalized();
    n += noise * Vector3d{random.normal(), random.normal(), random.normal()};
    cloud.points.push_back(motion * place(z, a));
    cloud.normals.push_back(motion.linear() * n.normalized());
    cloud.weights.push_back(1.0);
  }
  return cloud;
}

struct Error {
  double angle, offset;
  RevolutionAxis axis;
};

Error
errorOf(const Cloud& cloud, const Eigen::Isometry3d& motion)
{
  const auto axis = fitRevolutionAxis(cloud.points, cloud.normals, cloud.weights);
  EXPECT_TRUE(axis.has_value());
  if (!axis)
    return {};
  const Vector3d d = motion.linear().col(2);
  return {std::asin(std::min(1.0, axis->direction.cross(d).norm())), (axis->origin - motion.translation()).cross(d).norm(), *axis};
}

} // namespace

TEST(RevolutionAxis, OfColumnsOfManyShapes)
{
  struct Case {
    const char* name;
    std::function<double(double, double)> radius;
    double height, sector, noise, most_angle, most_offset;
  };
  const double all = 2.0 * M_PI;
  const Case cases[] = {
      {"tall", [](double, double) { return 10.0; }, 60.0, all, 0.01, 5e-4, 0.02},
      {"short and wide", [](double, double) { return 50.0; }, 4.0, all, 0.01, 6e-4, 0.03},
      {"waist", [](double z, double) { return 20.0 + 0.01 * z * z; }, 50.0, all, 0.01, 1e-3, 0.03},
      {"taper of 40 degrees", [](double z, double) { return 30.0 + 0.84 * z; }, 40.0, all, 0.01, 1e-3, 0.03},
      {"five flutes", [](double, double a) { return 20.0 + std::sin(5.0 * a); }, 40.0, all, 0.0, 1e-2, 0.3},
      {"third of a turn", [](double, double) { return 20.0; }, 60.0, all / 3.0, 0.005, 1e-3, 0.02},
      {"third of a waist", [](double z, double) { return 20.0 + 0.01 * z * z; }, 50.0, all / 3.0, 0.005, 2e-3, 0.05},
  };
  for (const Case& c : cases)
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Eigen::Isometry3d motion = randomMotion(seed, 300.0);
      const Error e = errorOf(column(c.radius, c.height, c.sector, c.noise, motion, seed), motion);
      std::printf("  %s: %.6f rad, %.4f mm; turning %.4f radial %.3f uncertainty %.4f\n", c.name, e.angle, e.offset, e.axis.turning,
                  e.axis.radial, e.axis.uncertainty);
      EXPECT_LT(e.angle, c.most_angle) << c.name;
      EXPECT_LT(e.offset, c.most_offset) << c.name;
      EXPECT_LT(e.axis.uncertainty, 0.4) << c.name;
      EXPECT_GT(e.axis.radial, 0.7) << c.name;
    }
}

/** From a distant axis across its own, a cylinder is a piece of a huge ring, and also runs round that axis. */
TEST(RevolutionAxis, ACylinderIsNoPieceOfAHugeRing)
{
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    for (const double noise : {0.0, 0.01, 0.05}) {
      const Eigen::Isometry3d motion = randomMotion(seed, 300.0);
      const Error e = errorOf(column([](double, double) { return 10.0; }, 60.0, 2.0 * M_PI, noise, motion, seed), motion);
      EXPECT_LT(e.angle, 5e-4 + 0.05 * noise) << seed << ", noise " << noise;
      EXPECT_LT(e.offset, 0.02 + 2.0 * noise) << seed << ", noise " << noise;
    }
}

TEST(RevolutionAxis, ABossOnTheSideCountsLess)
{
  const auto boss = [](double z, double a) {
    return 20.0 + (std::hypot(z, 20.0 * (a - 1.0)) < 6.0 ? 0.8 * (6.0 - std::hypot(z, 20.0 * (a - 1.0))) : 0.0);
  };
  const Eigen::Isometry3d motion = randomMotion(4, 100.0);
  const Error e = errorOf(column(boss, 60.0, 2.0 * M_PI, 0.005, motion, 4), motion);
  EXPECT_LT(e.angle, 1e-3);
  EXPECT_LT(e.offset, 0.05);
}

TEST(RevolutionAxis, IsUncertainOnSpheresAndPlates)
{
  Random random(5);
  for (const double noise : {0.0, 0.01}) {
    Cloud sphere, plate;
    for (int i = 0; i < 3000; ++i) {
      const Vector3d d = Vector3d(random.normal(), random.normal(), random.normal()).normalized();
      const Vector3d off = noise * Vector3d(random.normal(), random.normal(), random.normal());
      sphere.points.push_back(20.0 * d);
      sphere.normals.push_back((d + off).normalized());
      plate.points.emplace_back(random.uniform(-30.0, 30.0), random.uniform(-20.0, 20.0), 0.0);
      plate.normals.push_back((Vector3d::UnitZ() + off).normalized());
    }
    sphere.weights = plate.weights = std::vector<double>(3000, 1.0);
    const auto on_sphere = fitRevolutionAxis(sphere.points, sphere.normals, sphere.weights);
    EXPECT_TRUE(!on_sphere || on_sphere->uncertainty > 0.4) << on_sphere->uncertainty;
    const auto on_plate = fitRevolutionAxis(plate.points, plate.normals, plate.weights);
    if (on_plate)
      std::printf("  plate: radial %.3f uncertainty %.3f\n", on_plate->radial, on_plate->uncertainty);
    EXPECT_TRUE(!on_plate || on_plate->uncertainty > 0.4 || on_plate->radial < 0.7);
  }
  EXPECT_FALSE(fitRevolutionAxis({Vector3d::Zero()}, {Vector3d::UnitX()}, {1.0}));
}

} // namespace revolution_axis_test
