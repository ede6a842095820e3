// SPDX-License-Identifier: BSD-3-Clause
// Moving least squares against an exact sphere, cylinder and paraboloid, with and without noise.
#include <pcl_spiral/fit/impl/mls_surface.h>

#include <gtest/gtest.h>
#include <omp.h>

#include <random>

namespace mls_surface_test {

namespace {

using Eigen::Vector3d;

std::vector<Eigen::Vector3f>
cap(std::size_t n, double radius, double noise, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u;
  std::normal_distribution<double> g;
  std::vector<Eigen::Vector3f> points(n);
  for (auto& p : points) {
    const double z = 0.5 + 0.5 * u(random), a = 2 * M_PI * u(random), r = std::sqrt(1 - z * z);
    p = ((radius + noise * g(random)) * Vector3d(r * std::cos(a), r * std::sin(a), z)).cast<float>();
  }
  return points;
}

pcl_spiral::SurfaceGraph
graphOf(const std::vector<Eigen::Vector3f>& points)
{
  pcl_spiral::SurfaceGraph graph;
  EXPECT_TRUE(graph.build(points, {}).ok());
  return graph;
}

std::vector<Vector3d>
queriesOn(double radius, std::size_t n, double lowest = 0.55)
{
  std::mt19937_64 random(99);
  std::uniform_real_distribution<double> u;
  std::vector<Vector3d> queries(n);
  for (auto& q : queries) {
    const double z = lowest + (1 - lowest) * u(random), a = 2 * M_PI * u(random), r = std::sqrt(1 - z * z);
    q = radius * Vector3d(r * std::cos(a), r * std::sin(a), z);
  }
  return queries;
}

TEST(MlsSurface, SphereExactly)
{
  const double radius = 100.0;
  const auto graph = graphOf(cap(40000, radius, 0.0, 1));
  const pcl_spiral::MlsSurface surface(graph);
  EXPECT_EQ(surface.neighbours(), 32);
  auto queries = queriesOn(radius, 3000);
  for (auto& q : queries)
    q *= 1.005; // half a millimetre off
  std::vector<pcl_spiral::SurfaceFoot> feet;
  surface.project(queries, feet);
  for (std::size_t i = 0; i < feet.size(); ++i) {
    ASSERT_TRUE(feet[i].valid);
    EXPECT_NEAR(feet[i].position.norm(), radius, 1e-4);
    EXPECT_LT(feet[i].position.cross(queries[i].normalized()).norm(), 2e-4); // straight below
    EXPECT_LT(feet[i].normal.cross(queries[i].normalized()).norm(), 1e-3);
    EXPECT_GT(feet[i].normal.dot(queries[i]), 0.0);
    EXPECT_NEAR(feet[i].curvature1, 1.0 / radius, 2e-4);
    EXPECT_NEAR(feet[i].curvature2, 1.0 / radius, 2e-4);
  }
}

TEST(MlsSurface, CylinderCurvaturesAndDirections)
{
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  std::vector<Eigen::Vector3f> points(30000);
  for (auto& p : points) {
    const double a = u(random), x = 50 * u(random);
    p = Vector3d(x, 40 * std::sin(a), 40 * std::cos(a)).cast<float>();
  }
  const auto graph = graphOf(points);
  const pcl_spiral::MlsSurface surface(graph);
  for (const double a : {-0.8, -0.2, 0.0, 0.5}) {
    const auto foot = surface.project(Vector3d(3.0, 40 * std::sin(a), 40 * std::cos(a)));
    ASSERT_TRUE(foot.valid);
    EXPECT_NEAR(foot.curvature1, 1.0 / 40, 2e-4);
    EXPECT_NEAR(foot.curvature2, 0.0, 2e-4);
    EXPECT_LT(std::abs(foot.direction1.x()), 0.02);
    EXPECT_NEAR(foot.normalCurvature(Vector3d::UnitX()), 0.0, 2e-4);
  }
}

TEST(MlsSurface, NoiseIsMeasuredAndAveraged)
{
  const double radius = 400.0, sigma = 0.05;
  const auto graph = graphOf(cap(100000, radius, sigma, 3));
  const pcl_spiral::MlsSurface surface(graph);
  EXPECT_NEAR(surface.noise(), sigma, 0.05 * sigma);
  EXPECT_EQ(surface.neighbours(), 256);
  std::vector<pcl_spiral::SurfaceFoot> feet;
  surface.project(queriesOn(radius, 3000), feet);
  double squares = 0.0;
  for (const auto& foot : feet)
    squares += std::pow(foot.position.norm() - radius, 2);
  EXPECT_LT(std::sqrt(squares / feet.size()), 0.25 * sigma);
}

TEST(MlsSurface, FitNoiseIsThatOfTheFeet)
{
  using pcl_spiral::ProjectionMethod;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> u(-100.0, 100.0);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::vector<Eigen::Vector3f> points; // evenly spread: a square grid, every point moved by up to 0.3 of a cell
  for (int i = -100; i <= 100; ++i)
    for (int j = -100; j <= 100; ++j)
      points.push_back(Vector3d(i + 0.003 * u(random), j + 0.003 * u(random), noise(random)).cast<float>());
  const auto graph = graphOf(points);
  std::vector<Vector3d> queries(5000);
  for (auto& q : queries)
    q = Vector3d(0.9 * u(random), 0.9 * u(random), 0.0);
  for (const auto method : {ProjectionMethod::Quadratic, ProjectionMethod::RobustQuartic, ProjectionMethod::DirectionalCentroid}) {
    const pcl_spiral::MlsSurface surface(graph, 128, method);
    std::vector<pcl_spiral::SurfaceFoot> feet;
    surface.project(queries, feet);
    double squares = 0.0;
    for (const auto& foot : feet)
      squares += foot.position.z() * foot.position.z();
    EXPECT_NEAR(std::sqrt(squares / feet.size()), surface.fitNoise(), 0.06 * surface.fitNoise()) << static_cast<int>(method);
  }
}

namespace {

/** Waves of 0.2 mm, 15 mm long, a point every 1 mm; with noise \p sigma, and a share of outliers 0.2 to 8 mm off. */
std::vector<Eigen::Vector3f>
waves(double sigma, double echoes)
{
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<Eigen::Vector3f> points;
  for (int i = -100; i <= 100; ++i)
    for (int j = -100; j <= 100; ++j) {
      const double x = i + 0.6 * (uniform(random) - 0.5), y = j + 0.6 * (uniform(random) - 0.5);
      const double off = uniform(random) < echoes ? 8.0 * std::pow(uniform(random), 2) + 0.2 : sigma * normal(random);
      points.push_back(Eigen::Vector3d(x, y, 0.2 * std::sin(2.0 * M_PI * x / 15.0) + off).cast<float>());
    }
  return points;
}

/** Largest height of the feet off the waves, over places away from the rim. */
double
largestError(const pcl_spiral::SurfaceGraph& graph, pcl_spiral::ProjectionMethod method)
{
  const pcl_spiral::MlsSurface surface(graph, 96, method);
  std::vector<Vector3d> queries;
  for (double x = -80.0; x <= 80.0; x += 1.7)
    for (double y = -80.0; y <= 80.0; y += 7.3)
      queries.emplace_back(x, y, 0.2 * std::sin(2.0 * M_PI * x / 15.0));
  std::vector<pcl_spiral::SurfaceFoot> feet;
  surface.project(queries, feet);
  double largest = 0.0;
  for (const auto& foot : feet) {
    EXPECT_TRUE(foot.valid);
    largest = std::max(largest, std::abs(foot.position.z() - 0.2 * std::sin(2.0 * M_PI * foot.position.x() / 15.0)));
  }
  return largest;
}

} // namespace

TEST(MlsSurface, TheQuarticFollowsWhatTheQuadricSmoothsAway)
{
  using pcl_spiral::ProjectionMethod;
  const auto graph = graphOf(waves(0.0, 0.0));
  const double quadric = largestError(graph, ProjectionMethod::Quadratic);
  const double quartic = largestError(graph, ProjectionMethod::RobustQuartic);
  EXPECT_GT(quadric, 0.004);
  EXPECT_LT(quartic, 0.1 * quadric);
}

TEST(MlsSurface, FalseEchoesDoNotBendTheQuartic)
{
  using pcl_spiral::ProjectionMethod;
  const auto clean = graphOf(waves(0.02, 0.0)), dirty = graphOf(waves(0.02, 0.02));
  const double before = largestError(clean, ProjectionMethod::RobustQuartic);
  EXPECT_LT(before, 0.04);
  EXPECT_LT(largestError(dirty, ProjectionMethod::RobustQuartic), 1.5 * before);
  EXPECT_GT(largestError(dirty, ProjectionMethod::Quadratic), 5.0 * before);
}

TEST(MlsSurface, RefusesWhatIsNotOnTheSurface)
{
  const auto graph = graphOf(cap(20000, 100.0, 0.0, 4));
  const pcl_spiral::MlsSurface surface(graph);
  const double s = graph.spacing();
  EXPECT_FALSE(surface.project(Vector3d(0, 0, 100 + 10 * s)).valid);
  EXPECT_FALSE(surface.project(Vector3d(0, 0, std::nan(""))).valid);
  EXPECT_FALSE(surface.project(Vector3d(0, 0, 1e30)).valid);
  const double rim = std::acos(0.5), beyond = rim + 2.5 * s / 100.0, within = rim - 0.5 * s / 100.0;
  EXPECT_FALSE(surface.project(100 * Vector3d(std::sin(beyond), 0, std::cos(beyond))).valid);
  EXPECT_TRUE(surface.project(100 * Vector3d(std::sin(within), 0, std::cos(within))).valid);
}

TEST(MlsSurface, PublishedMethodHasItsKnownBias)
{
  const double radius = 100.0;
  const auto graph = graphOf(cap(40000, radius, 0.0, 5));
  const pcl_spiral::MlsSurface surface(graph, 32, pcl_spiral::ProjectionMethod::DirectionalCentroid);
  const double h = 0.5 * std::sqrt(32 / M_PI) * graph.spacing(); // half the radius of 32 neighbours
  double mean = 0.0;
  const auto queries = queriesOn(radius, 2000, 0.7);
  std::vector<pcl_spiral::SurfaceFoot> feet;
  surface.project(queries, feet);
  for (const auto& foot : feet) {
    ASSERT_TRUE(foot.valid);
    mean += (foot.position.norm() - radius) / feet.size();
  }
  EXPECT_NEAR(mean, -2.0 / radius * h * h / 4.0, 0.1 * 2.0 / radius * h * h / 4.0);
}

TEST(MlsSurface, ScanLinesFarApart)
{
  const double radius = 200.0;
  std::vector<Eigen::Vector3f> points;
  for (double y = -80.0; y <= 80.0; y += 4.0)
    for (double x = -80.0; x <= 80.0; x += 0.4)
      points.push_back(Vector3d(x, y, std::sqrt(radius * radius - x * x - y * y)).cast<float>());
  const auto graph = graphOf(points);
  const pcl_spiral::MlsSurface surface(graph);
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> u(-70.0, 70.0);
  std::vector<Vector3d> queries(3000);
  for (auto& q : queries) {
    const double x = u(random), y = u(random);
    q = Vector3d(x, y, std::sqrt(radius * radius - x * x - y * y));
  }
  std::vector<pcl_spiral::SurfaceFoot> feet;
  surface.project(queries, feet);
  for (const auto& foot : feet) {
    ASSERT_TRUE(foot.valid);
    EXPECT_NEAR(foot.position.norm(), radius, 1e-3);
  }
}

/** Beside a rim the quartic has two or three lines on one side: its slope and curvature across them are only
 *  rounding. */
TEST(MlsSurface, TheQuarticDoesNotBendAcrossFewScanLines)
{
  const double radius = 2000.0;
  const Vector3d away(-750.0, 990.0, 1240.0); // coordinates are rounded to 6e-5 there
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> u(-0.1, 0.1);
  for (const double across : {1.0, 2.0, 3.0, 3.7, 4.3, 5.0}) {
    std::vector<Eigen::Vector3f> points;
    const Eigen::Quaterniond turn = Eigen::Quaterniond(0.8, 0.3, -0.4, across / 5.0).normalized();
    for (double y = -30.0; y <= 30.0; y += across)
      for (double x = -40.0; x <= 40.0; x += 1.0) {
        const double along = x + u(random);
        const Vector3d p(along, y, std::sqrt(radius * radius - along * along - y * y) - radius);
        points.push_back((away + turn * p).cast<float>());
      }
    const auto graph = graphOf(points);
    const pcl_spiral::MlsSurface surface(graph, 0, pcl_spiral::ProjectionMethod::RobustQuartic);
    std::vector<Vector3d> queries;
    for (std::size_t i = 0; i < graph.size(); ++i)
      queries.push_back(graph.position(i));
    std::vector<pcl_spiral::SurfaceFoot> feet;
    surface.project(queries, feet);
    const Vector3d centre = away + turn * Vector3d(0.0, 0.0, -radius);
    double worst = 0.0, steepest = 0.0;
    std::size_t valid = 0;
    for (const pcl_spiral::SurfaceFoot& foot : feet) {
      if (!foot.valid)
        continue;
      ++valid;
      steepest = std::max(steepest, foot.normal.cross((foot.position - centre).normalized()).norm());
      for (const double curvature : {foot.curvature1, foot.curvature2})
        worst = std::max(worst, std::abs(std::abs(curvature) - 1.0 / radius));
    }
    EXPECT_GT(valid, feet.size() / 2);
    EXPECT_LT(worst, 20.0 / radius) << "1/mm, lines " << across << " mm apart"; // 0.01; a step of 2 mm removes 0.02 mm
    EXPECT_LT(steepest, 1e-3) << "rad, lines " << across << " mm apart";
  }
}

TEST(MlsSurface, SameBytesForAnyThreads)
{
  const auto graph = graphOf(cap(20000, 100.0, 0.01, 6));
  const auto queries = queriesOn(100.0, 2000);
  std::vector<pcl_spiral::SurfaceFoot> one, two;
  omp_set_num_threads(1);
  pcl_spiral::MlsSurface(graph).project(queries, one);
  omp_set_num_threads(2);
  pcl_spiral::MlsSurface(graph).project(queries, two);
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].position, two[i].position);
    ASSERT_EQ(one[i].normal, two[i].normal);
  }
}

} // namespace

} // namespace mls_surface_test
