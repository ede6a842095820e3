// SPDX-License-Identifier: BSD-3-Clause
// Points that fill space are refused before any graph is built of them, with how they lie; noisy, folded and sparse surfaces are not.
#include <pcl_spiral/surface/impl/smoothing_remedy.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace hopeless_scans_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

constexpr int count = 12000;

/** count points made by \p make from a random source. */
std::vector<Eigen::Vector3f>
drawn(const std::function<Vector3d(const std::function<double()>&, const std::function<double()>&)>& make)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  std::normal_distribution<double> normal;
  const std::function<double()> unit = [&] { return even(random); }, gauss = [&] { return normal(random); };
  std::vector<Eigen::Vector3f> points;
  while (points.size() < count)
    points.push_back(make(unit, gauss).cast<float>());
  return points;
}

struct Outcome {
  Status status;
  int passes = 0; ///< graphs built
};

Outcome
made(const std::vector<Eigen::Vector3f>& points, const SurfaceSettings& settings = {})
{
  SurfacePoints given;
  given.positions = points;
  Surface::Parts parts;
  std::vector<std::int8_t> why;
  Outcome outcome;
  outcome.status = makeSurface(std::move(given), settings, {}, parts, why);
  outcome.passes = parts.counts.passes;
  return outcome;
}

void
expectRefusedEarly(const std::vector<Eigen::Vector3f>& points, const SurfaceSettings& settings = {})
{
  const Outcome outcome = made(points, settings);
  ASSERT_FALSE(outcome.status.ok());
  EXPECT_EQ(outcome.passes, 0) << outcome.status.message();
  for (const char* words :
       {"not a single sheet", "Half of the points lie within", "% of these above it", "mm at (", "crop the scan to the part"})
    EXPECT_NE(outcome.status.message().find(words), std::string::npos) << outcome.status.message();
  EXPECT_TRUE(outcome.status.diagnostic().settings().empty()) << "none was tried: " << outcome.status.message();
}

Vector3d
wave(double x, double y)
{
  return {x, y, 4.0 * std::sin(x / 15.0) * std::cos(y / 18.0)};
}

const double spacing = 100.0 / std::sqrt(count); // of the points of a square of 100 mm

} // namespace

TEST(HopelessScans, NoiseFarAboveTheSpacing)
{
  expectRefusedEarly(drawn([](const auto& unit, const auto&) { return Vector3d(50.0 * unit(), 50.0 * unit(), 5.0 * unit()); }));
  expectRefusedEarly(drawn([](const auto& unit, const auto& gauss) {
    return Vector3d(wave(50.0 * unit(), 50.0 * unit()) + 5.0 * spacing * gauss() * Vector3d::UnitZ());
  }));
}

TEST(HopelessScans, RandomPoints)
{
  const auto points = drawn([](const auto& unit, const auto&) { return Vector3d(50.0 * unit(), 50.0 * unit(), 50.0 * unit()); });
  expectRefusedEarly(points);
  SurfaceSettings settings;
  settings.largest_part = true;
  expectRefusedEarly(points, settings);
  settings = {};
  settings.part_at = Vector3d(10.0, 10.0, 10.0);
  expectRefusedEarly(points, settings);
}

TEST(HopelessScans, TreesOverGround)
{
  expectRefusedEarly(drawn([](const auto& unit, const auto& gauss) {
    if (unit() < -0.3)
      return wave(50.0 * unit(), 50.0 * unit());
    const Vector3d tree(40.0 * std::round(1.4 * unit()), 40.0 * std::round(1.4 * unit()), 15.0);
    return Vector3d(tree + 4.0 * Vector3d(gauss(), gauss(), gauss()));
  }));
}

TEST(HopelessScans, ANoisySurfaceIsNotRefusedEarly)
{
  const auto noisy = [](double noise) {
    return drawn([noise](const auto& unit, const auto& gauss) {
      return Vector3d(wave(50.0 * unit(), 50.0 * unit()) + noise * spacing * gauss() * Vector3d::UnitZ());
    });
  };
  EXPECT_TRUE(made(noisy(0.3)).status.ok());
  EXPECT_GT(made(noisy(1.0)).passes, 0);
}

TEST(HopelessScans, ThinWallsAndTubesAreNotRefusedEarly)
{
  for (const double apart : {2.0, 5.0})
    EXPECT_GT(made(drawn([apart](const auto& unit, const auto&) {
                return Vector3d(wave(50.0 * unit(), 50.0 * unit()) + (unit() < 0.0 ? apart * spacing : 0.0) * Vector3d::UnitZ());
              })).passes,
              0)
        << apart;
  EXPECT_GT(made(drawn([](const auto& unit, const auto&) { // a wire: 8 points across
              const double angle = 3.14159 * unit();
              return Vector3d(2000.0 * unit(), std::cos(angle), std::sin(angle));
            }))
                .passes,
            0);
}

TEST(HopelessScans, APartBesideABushIsNotRefusedEarly)
{
  const auto points = drawn([](const auto& unit, const auto& gauss) {
    return unit() < -0.4 ? wave(50.0 * unit(), 50.0 * unit())
                         : Vector3d(Vector3d(150.0, 0.0, 20.0) + 20.0 * Vector3d(gauss(), gauss(), gauss()));
  });
  expectRefusedEarly(points);
  SurfaceSettings settings;
  settings.part_at = wave(0.0, 0.0);
  const Outcome chosen = made(points, settings);
  EXPECT_TRUE(chosen.status.ok()) << chosen.status.message();
}

TEST(HopelessScans, ManyPointsOverTheChosenPartAreRefused)
{
  const auto points = drawn([](const auto& unit, const auto& gauss) {
    return unit() < 0.4 ? wave(50.0 * unit(), 50.0 * unit())
                        : Vector3d(Vector3d(0.0, 0.0, 60.0) + 12.0 * Vector3d(gauss(), gauss(), gauss()));
  });
  SurfaceSettings settings;
  settings.part_at = wave(0.0, 0.0);
  const Outcome chosen = made(points, settings);
  EXPECT_FALSE(chosen.status.ok());
  EXPECT_NE(chosen.status.message().find("are isolated"), std::string::npos) << chosen.status.message();
}

TEST(HopelessScans, NoiseOfAnotherPartIsNotThatOfThePart)
{
  const auto rough = [](double height) { return Vector3d(0.0, 0.0, 1.2 * spacing * height); };
  const auto twoSheets = [](double height) { return Vector3d(0.0, 0.0, height > 0.0 ? spacing : 0.0); };
  for (const std::function<Vector3d(double)>& other :
       {std::function<Vector3d(double)>(rough), std::function<Vector3d(double)>(twoSheets)}) {
    const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    const auto add = [&](const Eigen::Vector3f& p) { cloud->emplace_back(p.x(), p.y(), p.z()); };
    for (const Eigen::Vector3f& p : drawn([](const auto&unit, const auto&) { return wave(50.0 * unit(), 50.0 * unit()); }))
      add(p);
    for (const Eigen::Vector3f& p : drawn([&](const auto&unit, const auto&gauss) {
           return Vector3d(Vector3d(150.0 + 50.0 * unit(), 50.0 * unit(), 0.0) + other(gauss()));
         }))
      add(p);
    ScannedSurface<pcl::PointXYZ> scanned;
    scanned.setInputCloud(cloud);
    scanned.setQuiet(true);
    Surface::ConstPtr surface;
    scanned.compute(surface);
    EXPECT_NE(scanned.getStatus().message().find("separate parts"), std::string::npos) << scanned.getStatus().message();
    EXPECT_NE(scanned.getStatus().message().find("(setPartAt)"), std::string::npos) << scanned.getStatus().message();
    scanned.setPartAt(Vector3d::Zero());
    scanned.compute(surface);
    EXPECT_TRUE(scanned.getStatus().ok()) << scanned.getStatus().message();
  }
}

TEST(HopelessScans, NoRemedySmoothsMoreThanEightSpacings)
{
  EXPECT_NE(smoothingRemedy(0.39, 1.0).text().find("pcl_mls_smoothing in.pcd out.pcd -radius 7.8"), std::string::npos);
  for (const double noise : {0.41, 1.0, 5.0}) {
    const std::string remedy = smoothingRemedy(noise, 1.0).text();
    EXPECT_EQ(remedy.find("pcl_mls_smoothing"), std::string::npos) << remedy;
    EXPECT_EQ(remedy.find("radius"), std::string::npos) << remedy;
    for (const char* words : {"folds", "scan more densely", "one sheet at a time"})
      EXPECT_NE(remedy.find(words), std::string::npos) << remedy;
  }
}

TEST(HopelessScans, FoldsAreNotSmoothedAway)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const Eigen::Vector3f& p : drawn([](const auto&unit, const auto&) { // folds four spacings wide, two high
         const double x = 50.0 * unit(), y = 50.0 * unit();
         return Vector3d(x, y, 2.0 * spacing * std::sin(2.0 * M_PI * x / (4.0 * spacing)));
       }))
    cloud->emplace_back(p.x(), p.y(), p.z());
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  scanned.setQuiet(true);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  const std::string message = scanned.getStatus().message();
  ASSERT_FALSE(scanned.getStatus().ok());
  EXPECT_EQ(message.find("pcl_mls_smoothing"), std::string::npos) << message;
  EXPECT_NE(message.find("folds of the part with too few points"), std::string::npos) << message;
}

TEST(HopelessScans, TightBendsAreShownByADenserScan)
{
  const auto status = [](double step) { // waves with a period of 12 mm, 60 degrees steep: radius 1.1 mm at their crests
    std::mt19937 random(1);
    std::uniform_real_distribution<double> jitter(-0.3, 0.3);
    const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    const int half = static_cast<int>(12.0 / step);
    for (int i = -half; i < half; ++i)
      for (int k = -half; k < half; ++k) {
        const double x = step * (i + jitter(random)), y = step * (k + jitter(random)), wave = 2.0 * M_PI / 12.0;
        cloud->push_back(
            {static_cast<float>(x), static_cast<float>(y), static_cast<float>(std::tan(M_PI / 3.0) / wave * std::sin(wave * x))});
      }
    ScannedSurface<pcl::PointXYZ> scanned;
    scanned.setInputCloud(cloud);
    Surface::ConstPtr surface;
    scanned.compute(surface);
    return scanned.getStatus();
  };
  const Status sparse = status(0.8);
  ASSERT_FALSE(sparse.ok());
  EXPECT_NE(sparse.message().find("for tight bends, scan more densely"), std::string::npos) << sparse.message();
  EXPECT_TRUE(status(0.4).ok()) << status(0.4).message();
}

} // namespace hopeless_scans_test
