// SPDX-License-Identifier: BSD-3-Clause
// SpiralPlanner on a cap of a sphere with clamps, known exactly: the ball stays out of keep-outs, tries give their reasons, inputs of all
// kinds give the same path, and bad ones are refused with nothing left of an older plan.
#include <pcl_spiral/planning/spiral_planner.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace spiral_planner_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Planner = SpiralPlanner<pcl::PointXYZ>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double ball = 100.0, rim = 40.0, radius = 4.0, scallop = 0.05, top = 12.0; // mm

/** A square clamp about (x, 0), 8 mm wide; x beyond the rim: none. */
bool
inClamp(double clamp_x, double x, double y)
{
  return std::abs(x - clamp_x) < 4.0 && std::abs(y) < 4.0;
}

/** A cap of a sphere with its pole at \p middle, and the flat top of a clamp. */
void
addCap(const Vector3d& middle, double clamp_x, unsigned int seed, Cloud& cloud)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, 0.003);
  const auto add = [&](const Vector3d& p) {
    const Eigen::Vector3f f = (middle + p).cast<float>();
    cloud.emplace_back(f.x(), f.y(), f.z());
  };
  for (int i = 0; i < 9000; ++i) {
    const double r = rim * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    if (!inClamp(clamp_x, x, y))
      add({x, y, std::sqrt(ball * ball - r * r) - ball + noise(random)});
  }
  if (clamp_x < rim)
    for (double x = -4.0; x <= 4.0; x += 0.8)
      for (double y = -4.0; y <= 4.0; y += 0.8)
        add({clamp_x + x, y, top});
}

Cloud::Ptr
cap(double clamp_x = 1000.0)
{
  const auto cloud = pcl::make_shared<Cloud>();
  addCap(Vector3d::Zero(), clamp_x, 8, *cloud);
  return cloud;
}

Prism
square(double x, double half = 4.5)
{
  return Prism({{x - half, -half, 0.0}, {x + half, -half, 0.0}, {x + half, half, 0.0}, {x - half, half, 0.0}}, Vector3d::UnitZ());
}

template <typename AnyPlanner>
void
setTool(AnyPlanner& planner)
{
  planner.setToolRadius(radius);
  planner.setScallopHeight(scallop);
  planner.setQuiet(true);
}

/** Least distance of the ball from the clamp, by brute force along the moves; below 0 it enters. */
double
clearance(const Path& path, double clamp_x)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < path.size(); ++i)
    for (int k = 0; k < 8; ++k) {
      const auto centre = [&](const ToolpathPoint& p) {
        return Vector3d((p.getVector3fMap() + static_cast<float>(radius) * p.getNormalVector3fMap()).cast<double>());
      };
      const Vector3d c = centre(path[i - 1]) + k / 8.0 * (centre(path[i]) - centre(path[i - 1]));
      const double dx = std::max(std::abs(c.x() - clamp_x) - 4.0, 0.0), dy = std::max(std::abs(c.y()) - 4.0, 0.0);
      least = std::min(least, std::hypot(dx, dy) - radius);
    }
  return least;
}

bool
same(const Path& a, const Path& b)
{
  if (a.size() != b.size())
    return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].getVector3fMap() != b[i].getVector3fMap() || a[i].getAxisVector3fMap() != b[i].getAxisVector3fMap())
      return false;
  return true;
}

} // namespace

TEST(SpiralPlanner, TheBallStaysOutOfAKeepOutWhereverTheClampStands)
{
  for (const double x : {0.0, 12.0, 28.0, 31.0}) {
    Planner planner;
    planner.setInputCloud(cap(x));
    setTool(planner);
    planner.setPartAt({-20.0, 0.0, -2.0});
    planner.addKeepOut(square(x));
    Path path;
    planner.compute(path);
    ASSERT_TRUE(planner.getStatus().ok()) << x << ": " << planner.getStatus().message();
    EXPECT_GT(clearance(path, x), 0.0) << x;
    EXPECT_GT(planner.getPlan().part.kept_out.size(), 50U) << "the top of the clamp";
    ASSERT_FALSE(planner.getWarnings().empty());
    EXPECT_EQ(planner.getWarnings().front().settings(), std::vector<std::string>{"addKeepOut"}) << "how much is not cut";
    EXPECT_EQ(path.size(), planner.getPlan().path->size());
  }
}

TEST(SpiralPlanner, EachTryHasItsReason)
{
  std::size_t again = 0;
  for (const double x : {28.0, 29.5, 30.0, 31.0}) {
    Planner planner;
    planner.setInputCloud(cap(x));
    setTool(planner);
    planner.setPartAt({-20.0, 0.0, -2.0});
    planner.addKeepOut(square(x));
    Path path;
    planner.compute(path);
    const SpiralPlan& plan = planner.getPlan();
    ASSERT_FALSE(plan.attempts.empty());
    ASSERT_EQ(std::count_if(plan.attempts.begin(), plan.attempts.end(), [](const PlanAttempt& a) { return a.refusal.empty(); }) > 0,
              planner.getStatus().ok());
    for (std::size_t i = 1; i < plan.attempts.size(); ++i) {
      const PlanAttempt &before = plan.attempts[i - 1], &next = plan.attempts[i];
      EXPECT_TRUE(!before.refusal.empty() || !next.cut.empty()) << "nothing is tried again without a reason, but to cut more strips";
      EXPECT_TRUE(next.margin > before.margin || next.strip_width > before.strip_width || next.cut != before.cut);
    }
    double uncut = 0.0;
    for (const UncutStrip& strip : plan.part.strips)
      uncut += strip.area;
    EXPECT_EQ(plan.attempts.size() > 1, uncut > 0.0 || plan.attempts.back().margin > 0.0) << x;
    again += plan.attempts.size() > 1 ? 1 : 0;
  }
  EXPECT_GT(again, 0U) << "no case is tried again";
}

TEST(SpiralPlanner, WithoutTheKeepOutTheClampIsInTheWay)
{
  Planner planner;
  planner.setInputCloud(cap(31.0));
  setTool(planner);
  planner.setPartAt({-20.0, 0.0, -2.0});
  Path path;
  path.resize(3);
  planner.compute(path);
  EXPECT_FALSE(planner.getStatus().ok());
  EXPECT_TRUE(path.empty());
  ASSERT_FALSE(planner.getStatus().diagnostic().places().empty());
  const Vector3d place = planner.getStatus().diagnostic().places().front();
  EXPECT_TRUE(inClamp(31.0, place.x(), place.y()) || (place - Vector3d(31.0, 0.0, top)).norm() < 7.0) << place.transpose();
}

TEST(SpiralPlanner, AllPointTypesAndBaseClassesGiveTheSamePath)
{
  const Cloud::Ptr cloud = cap(0.0);
  Planner planner;
  planner.setInputCloud(cloud);
  setTool(planner);
  planner.addKeepOut(square(0.0));
  planner.setPartAt({-20.0, 0.0, -2.0});
  Path path;
  planner.compute(path);
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();

  const auto coloured = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  pcl::copyPointCloud(*cloud, *coloured);
  SpiralPlanner<pcl::PointXYZRGB, pcl::PointNormal> other;
  pcl::PCLBase<pcl::PointXYZRGB>& base = other;
  base.setInputCloud(coloured);
  setTool(other);
  other.addKeepOut(square(0.0));
  SpiralInput<pcl::PointXYZRGB, pcl::PointNormal>& settings = other;
  settings.setPartAt({-20.0, 0.0, -2.0});
  settings.setNumberOfThreads(1);
  Path same_path;
  other.compute(same_path);
  ASSERT_TRUE(other.getStatus().ok()) << other.getStatus().message();
  EXPECT_TRUE(same(path, same_path));
}

TEST(SpiralPlanner, WithoutAChoiceItIsTheGenerator)
{
  Planner planner;
  planner.setInputCloud(cap());
  setTool(planner);
  Path path, whole;
  planner.compute(path);
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  generator.setInputCloud(cap());
  setTool(generator);
  generator.compute(whole);
  ASSERT_TRUE(generator.getStatus().ok());
  EXPECT_TRUE(same(path, whole));
  EXPECT_EQ(planner.getPlan().attempts.size(), 1U);
  EXPECT_TRUE(planner.getPlan().clearBox().isEmpty());
}

TEST(SpiralPlanner, IndicesArePartAndTheOthersAreObstacles)
{
  const Cloud::Ptr cloud = cap(31.0);
  const pcl::IndicesPtr left(new pcl::Indices);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((*cloud)[i].x < 5.0f)
      left->push_back(static_cast<int>(i));
  Planner by_indices, by_crop;
  for (Planner* planner : {&by_indices, &by_crop}) {
    planner->setInputCloud(cloud);
    setTool(*planner);
  }
  by_indices.setIndices(left);
  by_crop.setCropBox({Vector3d(-50.0, -50.0, -50.0), Vector3d(5.0, 50.0, 50.0)});
  Path a, b;
  by_indices.compute(a);
  by_crop.compute(b);
  ASSERT_TRUE(by_indices.getStatus().ok()) << by_indices.getStatus().message();
  EXPECT_TRUE(same(a, b));
  EXPECT_EQ(by_indices.getPlan().part.beside.size(), cloud->size() - left->size());
  for (const ToolpathPoint& p : a)
    ASSERT_LT(p.x, 6.5f);
}

TEST(SpiralPlanner, RegionsAreCutInTheirOrderForAnyNumberOfThreads)
{
  const auto cloud = pcl::make_shared<Cloud>();
  addCap(Vector3d::Zero(), 1000.0, 8, *cloud);
  addCap({120.0, 10.0, 3.0}, 1000.0, 9, *cloud);
  Path first;
  for (const unsigned int threads : {1U, 2U}) {
    Planner planner;
    planner.setInputCloud(cloud);
    setTool(planner);
    planner.setNumberOfThreads(threads);
    planner.addRegion({std::nullopt, Vector3d(120.0, 10.0, 3.0), ""});
    planner.addRegion({std::nullopt, Vector3d(0.0, 0.0, 0.0), "the near one"});
    Path path;
    double share = 0.0;
    planner.setProgressCallback([&share](double done, const std::string&) {
      EXPECT_GE(done, share);
      share = done;
      return true;
    });
    planner.compute(path);
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    const SpiralPlan& plan = planner.getPlan();
    ASSERT_EQ(plan.regions.size(), 2U);
    EXPECT_EQ(plan.regions[0].region, "region 1");
    EXPECT_EQ(plan.regions[1].region, "the near one");
    ASSERT_EQ(passBegins(path).size(), 1U);
    EXPECT_GT(path.front().x, 70.0f);
    EXPECT_LT(path.back().x, 50.0f);
    EXPECT_EQ(path.size(), plan.regions[0].path->size() + plan.regions[1].path->size());
    EXPECT_TRUE(plan.clearBox().contains(Vector3d(120.0, 10.0, 2.8)));
    EXPECT_TRUE(first.empty() || same(first, path));
    first = path;
  }
}

TEST(SpiralPlanner, CancelledAtAnyStageNothingIsLeft)
{
  for (const double at : {0.0, 0.1, 0.3, 0.7}) {
    Planner planner;
    planner.setInputCloud(cap(0.0));
    setTool(planner);
    planner.setPartAt({-20.0, 0.0, -2.0});
    planner.addKeepOut(square(0.0));
    planner.setProgressCallback([at](double share, const std::string&) { return share < at; });
    Path path;
    planner.compute(path);
    EXPECT_EQ(planner.getStatus().code(), StatusCode::Cancelled) << at << ": " << planner.getStatus().message();
    EXPECT_TRUE(path.empty());
    EXPECT_TRUE(planner.getPlan().path->empty());
  }
}

TEST(SpiralPlanner, BadInputIsRefusedWithTheRemedyAndLeavesNoOlderPlan)
{
  Planner planner;
  Path path;
  const auto refused = [&](StatusCode code, const char* words) {
    planner.compute(path);
    EXPECT_EQ(planner.getStatus().code(), code) << planner.getStatus().message();
    EXPECT_NE(planner.getStatus().message().find(words), std::string::npos) << planner.getStatus().message();
    EXPECT_TRUE(path.empty() && planner.getPlan().path->empty() && planner.getPlan().regions.empty());
  };
  setTool(planner);
  refused(StatusCode::InvalidInput, "setInputCloud");
  planner.setInputCloud(cap());
  planner.compute(path);
  ASSERT_TRUE(planner.getStatus().ok());
  planner.setCropBox({Vector3d(500.0, 500.0, 0.0), Vector3d(600.0, 600.0, 1.0)});
  refused(StatusCode::InvalidArgument, "give a larger crop");
  planner.clearPart();
  planner.addKeepOut(Prism({{0.0, 0.0, 0.0}, {9.0, 0.0, 0.0}}, Vector3d::UnitZ()));
  refused(StatusCode::InvalidArgument, "polygon");
  planner.clearPart();
  const Prism all({{-60.0, -60.0, 0.0}, {60.0, -60.0, 0.0}, {60.0, 60.0, 0.0}, {-60.0, 60.0, 0.0}}, Vector3d::UnitZ());
  planner.addRegion({all, std::nullopt, "one"});
  planner.addRegion({all, std::nullopt, "two"});
  refused(StatusCode::InvalidInput, "one and two have ");
  planner.clearPart();
  const pcl::IndicesPtr outside(new pcl::Indices{1, 2, 3, 20000});
  planner.setIndices(outside);
  refused(StatusCode::InvalidInput, "20000");
  planner.setIndices(pcl::IndicesPtr());
  Surface::ConstPtr surface;
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cap());
  scanned.compute(surface);
  planner.setInputSurface(surface);
  refused(StatusCode::InvalidArgument, "SpiralToolpathGenerator");
}

TEST(SpiralPlanner, AMeshHasItsSideAndEdgesOfItsOwn)
{
  pcl::PolygonMesh box;
  Cloud corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i % 2 == 0 ? 0.0f : 30.0f, i / 2 % 2 == 0 ? 0.0f : 30.0f, i / 4 == 0 ? 0.0f : 30.0f);
  pcl::toPCLPointCloud2(corners, box.cloud);
  for (const std::vector<int>& face : std::vector<std::vector<int>>{{0, 2, 3},
                                                                    {0, 3, 1},
                                                                    {4, 5, 7},
                                                                    {4, 7, 6},
                                                                    {0, 1, 5},
                                                                    {0, 5, 4},
                                                                    {2, 6, 7},
                                                                    {2, 7, 3},
                                                                    {0, 4, 6},
                                                                    {0, 6, 2},
                                                                    {1, 3, 7},
                                                                    {1, 7, 5}}) {
    box.polygons.emplace_back();
    box.polygons.back().vertices.assign(face.begin(), face.end());
  }
  SurfaceMesh::ConstPtr mesh;
  ASSERT_TRUE(SurfaceMesh::make(box, {}, mesh).ok());
  Planner planner;
  setTool(planner);
  planner.setInputMesh(mesh);
  Path path;
  planner.compute(path);
  EXPECT_EQ(planner.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_NE(planner.getStatus().message().find("is closed"), std::string::npos) << planner.getStatus().message();
  planner.addKeepOut(square(0.0));
  planner.compute(path);
  EXPECT_EQ(planner.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_NE(planner.getStatus().message().find("addKeepOut belongs to scans"), std::string::npos) << planner.getStatus().message();
}

} // namespace spiral_planner_test
