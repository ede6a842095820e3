// SPDX-License-Identifier: BSD-3-Clause
// Hollows tighter than the ball: the tightest of the whole path is named, how many there are, and a ball that fits.
#include <pcl_spiral/spiral/impl/tight_places.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace tight_places_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Path = pcl::PointCloud<ToolpathPoint>;

/** A dent -a exp(-d^2 / (2 s^2)) of radius s^2 / a at its bottom. */
struct Dent {
  double x, y, s, radius;
};

constexpr std::array<Dent, 3> dents{{{16.0, 0.0, 4.0, 7.0}, {-10.0, 14.0, 3.0, 4.0}, {-8.0, -15.0, 3.5, 5.5}}};
constexpr Dent tightest = dents[1];

/** A disc of radius 30 mm with the dents, and noise. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
dentedDisc(double noise)
{
  std::mt19937 random(22);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> normal(0.0, 1.0);
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i < 20000; ++i) {
    const double r = 30.0 * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    double z = noise * normal(random);
    for (const Dent& dent : dents)
      z -= dent.s * dent.s / dent.radius * std::exp(-(std::pow(x - dent.x, 2) + std::pow(y - dent.y, 2)) / (2.0 * dent.s * dent.s));
    cloud->push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  }
  return cloud;
}

Status
run(const pcl::PointCloud<pcl::PointXYZ>::Ptr& cloud, SpiralMethod method, double tool_radius)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(cloud);
  spiral.setMethod(method);
  spiral.setToolRadius(tool_radius);
  spiral.setScallopHeight(0.05);
  spiral.setTightHandling(TightHandling::Refuse);
  Path path;
  spiral.compute(path);
  return spiral.getStatus();
}

double
numberAfter(const std::string& message, const std::string& words)
{
  const std::size_t at = message.find(words);
  EXPECT_NE(at, std::string::npos) << words << " in: " << message;
  return at == std::string::npos ? 0.0 : std::strtod(message.c_str() + at + words.size(), nullptr);
}

class Tight : public ::testing::TestWithParam<SpiralMethod> {};

TEST_P(Tight, TheTightestIsNamedAndTheRemedyFits)
{
  for (const double noise : {0.0, 0.01}) {
    const auto cloud = dentedDisc(noise);
    const Status refused = run(cloud, GetParam(), 10.0);
    ASSERT_EQ(refused.code(), StatusCode::Failed);
    const std::string& message = refused.message();
    EXPECT_NEAR(numberAfter(message, "hollow with radius "), tightest.radius, 0.2 * tightest.radius) << message;
    EXPECT_NEAR(numberAfter(message, " mm at ("), tightest.x, 1.5) << message;
    EXPECT_NE(message.find("in 3 separate places"), std::string::npos) << message;
    EXPECT_GT(numberAfter(message, "the tightest of "), 10.0) << message;
    const double fitting = numberAfter(message, "or use a smaller tool (setToolRadius): a radius of ");
    EXPECT_GT(fitting, 0.6 * tightest.radius) << message;
    EXPECT_LT(fitting, tightest.radius) << message;
    const Status made = run(cloud, GetParam(), fitting);
    EXPECT_TRUE(made.ok()) << made.message();
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Tight, ::testing::Values(SpiralMethod::Radial, SpiralMethod::ConstantScallop));

TEST(TightPlaces, SeparatePlacesAreFartherApartThanTheTool)
{
  const auto foot = [](double x, double curvature) {
    SurfaceFoot at;
    at.valid = true;
    at.position = Vector3d(x, 0.0, 0.0);
    at.curvature2 = curvature;
    return at;
  };
  TightPlaces tight(2.0);
  tight.add(foot(0.0, -0.499));
  EXPECT_TRUE(tight.empty());
  for (int i = 0; i < 100; ++i)
    tight.add(foot(0.1 * i, -0.6)); // one place of ten millimetres
  EXPECT_EQ(tight.count(), 1U);
  tight.add(foot(50.0, -1.0));
  tight.add(foot(51.0, -1.0));
  EXPECT_EQ(tight.count(), 2U);
  EXPECT_EQ(tight.radius(), 1.0);
  EXPECT_EQ(tight.place().x(), 50.0) << "the first of equally tight ones";
  SurfaceFoot off = foot(200.0, -5.0);
  off.valid = false;
  tight.add(off);
  EXPECT_EQ(tight.feet().size(), 102U);
}

} // namespace

} // namespace tight_places_test
