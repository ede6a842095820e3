// SPDX-License-Identifier: BSD-3-Clause
// GeodesicPath for a PCL user: published distances, both starts, moved clouds, threads, bad input.
#include "support/geodesic_oracle.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include "geodesic/dijkstra_tree.h"
#include <pcl_spiral/geodesic/geodesic_path.h>

#include <gtest/gtest.h>

#include <cmath>

namespace geodesic_path_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

constexpr double a = 1650.0, b = 860.0;
// GeographicLib's GeodSolve, latitude 60 longitude 0 to latitude 0 longitude 0, 30 ... 180, mm.
constexpr double published[] = {749.802870802,  1072.315413128, 1683.675783644, 2306.561014625,
                                2827.778170366, 3171.441917434, 3291.158860704};

Polyline
rimOfSpheroid()
{
  Polyline targets;
  for (int k = 0; k < 7; ++k)
    targets.push_back(test::onSpheroid(a, b, 0, 30 * k));
  return targets;
}

SurfaceGraph
graphOf(const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  std::vector<Eigen::Vector3f> points;
  for (const auto& p : cloud)
    points.push_back(p.getVector3fMap());
  SurfaceGraph graph;
  EXPECT_TRUE(graph.build(points, {}).ok());
  return graph;
}

TEST(GeodesicPath, PublishedDistancesFromBothStarts)
{
  const auto cloud = test::toCloud(test::sampleUniform(*test::spheroidCap(a, b), 200000, 41).points);
  const auto surface = test::spheroidCap(a, b);
  const Vector3d source = test::onSpheroid(a, b, 60, 0);
  const Polyline targets = rimOfSpheroid();
  const SurfaceGraph graph = graphOf(*cloud);
  DijkstraTree tree;
  ASSERT_TRUE(tree.compute(graph, source));
  GeodesicPath<pcl::PointXYZ> geodesic;
  geodesic.setInputCloud(cloud);
  geodesic.setSourcePoint(source);
  geodesic.setTargetPoints(targets);
  std::vector<Polyline> paths[2];
  for (const GeodesicStart start : {GeodesicStart::Field, GeodesicStart::Graph}) {
    geodesic.setStart(start);
    auto& found = paths[start == GeodesicStart::Graph];
    geodesic.compute(found);
    ASSERT_TRUE(geodesic.getStatus().ok()) << geodesic.getStatus().message();
    EXPECT_EQ(geodesic.getStatus().message(), "done");
    ASSERT_EQ(found.size(), 7u);
    for (std::size_t k = 0; k < 7; ++k) {
      const double length = geodesic.getLengths()[k];
      EXPECT_NEAR(length, published[k], 1e-3);
      EXPECT_LT(length, pcl_spiral::length(tree.path(targets[k])));
      EXPECT_EQ(found[k].front(), source);
      EXPECT_EQ(found[k].back(), targets[k]);
      const auto exact = test::exactGeodesic(*surface, source, targets[k], found[k][1] - source, length);
      ASSERT_LT(exact.miss, 1e-6);
      const double sideways = test::sidewaysDistance(*surface, found[k], exact.points);
      std::printf("  longitude %3zu: length %+.6f, sideways %.5f mm, graph path longer by %.2f %%\n", 30 * k, length - published[k],
                  sideways, 100.0 * (pcl_spiral::length(tree.path(targets[k])) / published[k] - 1.0));
      EXPECT_LT(sideways, 0.01);
    }
  }
  for (std::size_t k = 0; k < 7; ++k)
    for (std::size_t i = 0; i < paths[0][k].size(); ++i)
      EXPECT_LT((paths[0][k][i] - paths[1][k][i]).norm(), 0.005);
}

TEST(DijkstraTree, EveryPathIsTheShortestOverEdges)
{
  const auto surface = test::ovalSaddle();
  const SurfaceGraph graph = graphOf(*test::toCloud(test::sampleUniform(*surface, 5000, 42).points));
  const Triangulation& mesh = graph.triangulation();
  DijkstraTree tree;
  const Vector3d source = graph.position(1234);
  ASSERT_TRUE(tree.compute(graph, source));
  EXPECT_EQ(tree.distance(1234), 0.0);
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h) {
    const double edge = (graph.position(mesh.origin(h)) - graph.position(mesh.target(h))).norm();
    EXPECT_LE(std::abs(tree.distance(mesh.origin(h)) - tree.distance(mesh.target(h))), edge + 1e-9);
  }
  for (std::uint32_t i = 0; i < graph.size(); i += 13) {
    const Polyline path = tree.path(graph.position(i));
    EXPECT_EQ(path.front(), source);
    EXPECT_NEAR(length(path), tree.distance(i), 1e-9);
  }
  EXPECT_TRUE(tree.path(Vector3d(0, 0, 1e4)).empty());
  EXPECT_FALSE(tree.compute(graph, Vector3d(0, 0, 1e4)));
}

class OnSaddle : public ::testing::Test {
protected:
  void SetUp() override
  {
    sampled_ = test::sampleUniform(*surface_, 30000, 43);
    geodesic_.setInputCloud(test::toCloud(sampled_.points));
    geodesic_.setSourcePoint(surface_->lift({-60, -40}));
    for (const auto& u : {Eigen::Vector2d(90, 40), Eigen::Vector2d(60, -60), Eigen::Vector2d(-60, 70)})
      targets_.push_back(surface_->lift(u));
    geodesic_.setTargetPoints(targets_);
  }

  const test::SurfacePtr surface_ = test::ovalSaddle();
  test::Sampled sampled_;
  Polyline targets_;
  GeodesicPath<pcl::PointXYZ> geodesic_;
};

TEST_F(OnSaddle, IntegratedGeodesics)
{
  std::vector<Polyline> paths;
  geodesic_.compute(paths);
  ASSERT_TRUE(geodesic_.getStatus().ok());
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const double length = geodesic_.getLengths()[k];
    const auto exact = test::exactGeodesic(*surface_, paths[k].front(), targets_[k], paths[k][1] - paths[k][0], length);
    ASSERT_LT(exact.miss, 1e-6);
    EXPECT_NEAR(length, exact.length, 1e-4);
    EXPECT_LT(test::sidewaysDistance(*surface_, paths[k], exact.points), 0.005);
  }
}

TEST_F(OnSaddle, SameAfterARigidMotion)
{
  std::vector<Polyline> paths, moved_paths;
  geodesic_.compute(paths);
  const std::vector<double> lengths = geodesic_.getLengths();
  const Eigen::Isometry3d motion = test::randomMotion(44, 300.0);
  test::Sampled moved = sampled_;
  for (const std::size_t i : test::shuffled(moved.points.size(), 45))
    moved.points[i] = motion * sampled_.points[i];
  Polyline targets;
  for (const Vector3d& target : targets_)
    targets.push_back(motion * target);
  geodesic_.setInputCloud(test::toCloud(moved.points));
  geodesic_.setSourcePoint(motion * paths[0].front());
  geodesic_.setTargetPoints(targets);
  geodesic_.compute(moved_paths);
  ASSERT_TRUE(geodesic_.getStatus().ok()) << geodesic_.getStatus().message();
  for (std::size_t k = 0; k < paths.size(); ++k) {
    EXPECT_NEAR(geodesic_.getLengths()[k], lengths[k], 1e-4);
    for (std::size_t i = 0; i < paths[k].size(); ++i)
      EXPECT_LT((motion * paths[k][i] - moved_paths[k][i]).norm(), 1e-3);
  }
}

TEST_F(OnSaddle, SameBytesForAnyThreads)
{
  std::vector<Polyline> one, three;
  geodesic_.setNumberOfThreads(1);
  geodesic_.compute(one);
  geodesic_.setNumberOfThreads(3);
  geodesic_.compute(three);
  EXPECT_EQ(one, three);
}

TEST_F(OnSaddle, IndicesAndUnusablePoints)
{
  std::vector<Polyline> paths, same;
  geodesic_.compute(paths);
  auto cloud = test::toCloud(sampled_.points);
  pcl::IndicesPtr indices(new pcl::Indices);
  for (std::size_t i = 0; i < sampled_.points.size(); ++i)
    indices->push_back(static_cast<pcl::index_t>(i));
  cloud->push_back((*cloud)[7]); // a duplicate
  cloud->push_back(pcl::PointXYZ(std::nanf(""), 0, 0));
  geodesic_.setInputCloud(cloud);
  geodesic_.compute(same);
  EXPECT_EQ(paths, same);
  cloud->push_back(pcl::PointXYZ(0, 0, 40)); // off the surface, not among the indices
  geodesic_.setIndices(indices);
  geodesic_.compute(same);
  EXPECT_EQ(paths, same);
  geodesic_.setSourceIndex(100);
  geodesic_.setTargetIndices({200, 300});
  geodesic_.compute(same);
  ASSERT_EQ(same.size(), 2u);
  EXPECT_EQ(same[1].front(), (*cloud)[100].getVector3fMap().cast<double>());
  EXPECT_EQ(same[1].back(), (*cloud)[300].getVector3fMap().cast<double>());
}

TEST_F(OnSaddle, CloudsWithNormalsOnTheGivenSide)
{
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
  cloud->header.frame_id = "part";
  auto normals = test::toNormals(sampled_.normals);
  for (auto& n : *normals) // the other side of the surface
    n.getNormalVector3fMap() *= -1.0f;
  for (const Vector3d& p : sampled_.points) {
    cloud->emplace_back();
    cloud->back().getVector3fMap() = p.cast<float>();
  }
  GeodesicPath<pcl::PointNormal> geodesic;
  geodesic.setInputCloud(cloud);
  geodesic.setInputNormals(normals);
  geodesic.setSourcePoint(surface_->lift({-60, -40}));
  geodesic.setTargetPoints(targets_);
  std::vector<pcl::PointCloud<pcl::PointNormal>> paths;
  geodesic.compute(paths);
  ASSERT_TRUE(geodesic.getStatus().ok());
  ASSERT_EQ(paths.size(), 3u);
  EXPECT_EQ(paths[0].header.frame_id, "part");
  EXPECT_EQ(paths[0].size(), 129u);
  for (const auto& p : paths[0]) {
    const Vector3d x = p.getVector3fMap().cast<double>();
    EXPECT_LT(std::abs(surface_->signedDistance(x)), 1e-3);
    EXPECT_LT(surface_->normal(x).dot(p.getNormalVector3fMap().cast<double>()), -0.9999);
  }
}

TEST_F(OnSaddle, SaysWhatIsWrong)
{
  std::vector<Polyline> paths;
  const auto fails = [&](StatusCode code, const std::string& word) {
    geodesic_.compute(paths);
    EXPECT_EQ(geodesic_.getStatus().code(), code);
    EXPECT_NE(geodesic_.getStatus().message().find(word), std::string::npos) << geodesic_.getStatus().message();
    for (const Polyline& path : paths)
      EXPECT_TRUE(path.empty());
  };
  geodesic_.setTolerance(0.0);
  fails(StatusCode::InvalidArgument, "tolerance");
  geodesic_.setTolerance(0.001);
  geodesic_.setLevels({});
  fails(StatusCode::InvalidArgument, "levels");
  geodesic_.setLevels({64, 32});
  fails(StatusCode::InvalidArgument, "level 1");
  geodesic_.setLevels({16, 64});
  geodesic_.setSourcePoint(Vector3d(0, 0, 500));
  fails(StatusCode::InvalidArgument, "source");
  geodesic_.setSourceIndex(-3);
  fails(StatusCode::InvalidArgument, "source");
  geodesic_.setSourceIndex(0);
  geodesic_.setTargetPoints({});
  fails(StatusCode::InvalidArgument, "targets");
  geodesic_.setTargetPoints({Vector3d(0, 0, 500)});
  fails(StatusCode::Failed, "target 0");
  geodesic_.setInputNormals(test::toNormals({Vector3d::UnitZ()}));
  fails(StatusCode::InvalidInput, "normals");
  geodesic_.setInputNormals(nullptr);
  geodesic_.setInputCloud(pcl::PointCloud<pcl::PointXYZ>::Ptr(new pcl::PointCloud<pcl::PointXYZ>));
  fails(StatusCode::InvalidInput, "empty");
  pcl::PointCloud<pcl::PointXYZ>::Ptr nothing(new pcl::PointCloud<pcl::PointXYZ>);
  nothing->resize(100, pcl::PointXYZ(std::nanf(""), 0, 0));
  geodesic_.setInputCloud(nothing);
  geodesic_.setSourcePoint(Vector3d(0, 0, 0));
  fails(StatusCode::InvalidInput, "is finite");
}

TEST(GeodesicPath, KeepsThePathsThatAreThereAndNamesTheOther)
{
  const auto surface = test::flat(test::Region({test::ell(200, 90)}));
  const Eigen::Vector2d low = surface->region().lower();
  GeodesicPath<pcl::PointXYZ> geodesic;
  geodesic.setInputCloud(test::toCloud(test::sampleUniform(*surface, 20000, 46).points));
  geodesic.setSourcePoint(Vector3d(low.x() + 190, low.y() + 45, 0));
  geodesic.setTargetPoints({{low.x() + 10, low.y() + 10, 0}, {low.x() + 45, low.y() + 190, 0}});
  std::vector<Polyline> paths;
  geodesic.compute(paths);
  EXPECT_EQ(geodesic.getStatus().code(), StatusCode::Failed);
  EXPECT_NE(geodesic.getStatus().message().find("target 1"), std::string::npos);
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_NEAR(geodesic.getLengths()[0], std::hypot(180, 35), 1e-3);
  EXPECT_FALSE(paths[0].empty());
  EXPECT_TRUE(paths[1].empty());
  EXPECT_TRUE(std::isnan(geodesic.getLengths()[1]));
}

} // namespace

} // namespace geodesic_path_test
