// SPDX-License-Identifier: BSD-3-Clause
// Every class used again: clouds of other sizes, other point types, indices, no cloud. It must never give an earlier result.
#include "support/reused_stage.h"
#include "support/test_machines.h"

#include <pcl_spiral/cleaning/outlier_removal.h>
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/features/centroid_boundary_estimation.h>
#include <pcl_spiral/geodesic/geodesic_path.h>
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/search/elliptic_gabriel_graph.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/mls_projector.h>
#include <pcl_spiral/surface/surface_preparation.h>
#include <pcl_spiral/verify/deviation_estimation.h>
#include <pcl_spiral/verify/lead_check.h>
#include <pcl_spiral/verify/material_removal.h>

#include <pcl/console/print.h>
#include <pcl/features/normal_3d.h>

#include <gtest/gtest.h>

namespace reused_stages_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double a = dome_radius, b = dome_height;

/** A path over the dome to judge: a ring of contacts. */
pcl::PointCloud<ToolpathPoint>::Ptr
ring()
{
  pcl::PointCloud<ToolpathPoint>::Ptr path(new pcl::PointCloud<ToolpathPoint>);
  for (int i = 0; i < 200; ++i) {
    const double angle = 2.0 * M_PI * i / 199, r = 40.0, z = b * std::sqrt(1.0 - r * r / (a * a));
    const Vector3d p(r * std::cos(angle), r * std::sin(angle), z), n = Vector3d(p.x() / (a * a), p.y() / (a * a), z / (b * b));
    ToolpathPoint point;
    point.getVector3fMap() = p.cast<float>();
    point.getNormalVector3fMap() = point.getAxisVector3fMap() = n.normalized().cast<float>();
    point.arc_length = 40.0 * angle;
    path->push_back(point);
  }
  return path;
}

template <typename Points>
void
addPoints(const Points& points, Values& values)
{
  for (const auto& p : points)
    values.insert(values.end(), {p.x, p.y, p.z});
}

// One adaptor per class: give takes a cloud, run computes and returns numbers, none on failure. Outputs are kept between runs.

template <typename PointT>
struct Scanned : ScannedSurface<PointT> {
  Values run()
  {
    this->compute(surface);
    Values values;
    for (std::size_t i = 0; surface && i < surface->size(); ++i)
      for (const double value : {surface->position(i).x(), surface->position(i).y(), surface->normal(i).z()})
        values.push_back(value);
    return values;
  }
  Surface::ConstPtr surface;
};

template <typename PointT>
struct Prepared : SurfacePreparation<PointT> {
  Values run()
  {
    this->filter(cloud);
    Values values;
    addPoints(cloud, values);
    return values;
  }
  pcl::PointCloud<PointT> cloud;
};

template <typename PointT>
struct Removal : OutlierRemoval<PointT> {
  Values run()
  {
    this->filter(cloud);
    Values values;
    addPoints(cloud, values);
    return values;
  }
  pcl::PointCloud<PointT> cloud;
};

template <typename PointT>
struct Graph : EllipticGabrielGraph<PointT> {
  Values run()
  {
    this->compute(lists);
    return lists.size() > 0 ? Values{static_cast<double>(lists.edgeCount())} : Values();
  }
  NeighbourLists lists;
};

template <typename PointT>
struct Loops : BoundaryLoops<PointT> {
  Values run()
  {
    this->compute(loops);
    Values values;
    for (const BoundaryLoop& loop : loops)
      addLine(loop.curve, values);
    return values;
  }
  std::vector<BoundaryLoop> loops;
};

template <typename PointT>
struct Bridged : GapBridging<PointT> {
  Values run()
  {
    this->compute(surface, loops);
    Values values;
    for (const BoundaryLoop& loop : loops)
      addLine(loop.curve, values);
    return values;
  }
  Surface::ConstPtr surface;
  std::vector<BoundaryLoop> loops;
};

template <typename PointT>
struct Geodesic : GeodesicPath<PointT> {
  Geodesic()
  {
    this->setSourcePoint({0.0, 0.0, b});
    this->setTargetPoints({Vector3d(40.0, 0.0, b * std::sqrt(1.0 - 0.25))});
  }
  Values run()
  {
    this->compute(paths);
    Values values;
    for (const Polyline& path : paths)
      addLine(path, values);
    return values;
  }
  std::vector<Polyline> paths;
};

template <typename PointT>
struct Lines : RadialLines<PointT> {
  Values run()
  {
    this->compute(set);
    Values values;
    for (const RadialLine& line : set.lines)
      values.push_back(line.length());
    addLine(set.rim, values);
    return values;
  }
  RadialLineSet set;
};

template <typename PointT>
struct Projected : MLSProjector<PointT, pcl::PointNormal> {
  Projected()
  {
    typename pcl::PointCloud<PointT>::Ptr queries(new pcl::PointCloud<PointT>);
    PointT p;
    p.x = 10.0f, p.y = 5.0f, p.z = static_cast<float>(b);
    queries->push_back(p);
    this->setQueryCloud(queries);
  }
  Values run()
  {
    this->process(feet);
    Values values;
    addPoints(feet, values);
    return values;
  }
  pcl::PointCloud<pcl::PointNormal> feet;
};

template <typename PointT>
struct Spiral : SpiralToolpathGenerator<PointT> {
  Spiral()
  {
    this->setToolRadius(8.0);
    this->setScallopHeight(0.2);
    this->setChordError(0.05);
  }
  Values run()
  {
    this->compute(path);
    Values values;
    addPoints(path, values);
    return values;
  }
  pcl::PointCloud<ToolpathPoint> path;
};

template <typename PointT>
struct Located : CutterLocation<PointT> {
  Located()
  {
    this->setCutter(CutterShape::ball(5.0));
    this->setDrivePath(*ring());
  }
  Values run()
  {
    this->compute(locations);
    Values values;
    for (const ToolLocation& location : locations)
      values.push_back(location.tip.z());
    return values;
  }
  ToolLocations locations;
};

template <typename PointT>
struct Driven : DrivePath<PointT> {
  Driven() { this->setStepOver(5.0); }
  Values run()
  {
    this->compute(passes);
    Values values;
    for (const DrivePass& pass : passes)
      for (const DrivePoint& point : pass.points)
        values.push_back(point.position.z());
    return values;
  }
  DrivePasses passes;
};

template <typename PointT>
struct Deviation : DeviationEstimation<PointT> {
  Deviation() { this->setInputToolpath(ring()); }
  Values run()
  {
    this->compute(out);
    Values values;
    for (const auto& p : out)
      values.push_back(p.intensity);
    return values;
  }
  pcl::PointCloud<pcl::PointXYZI> out;
};

template <typename PointT>
struct Removed : MaterialRemoval<PointT> {
  Removed()
  {
    this->setInputToolpath(ring());
    this->setToolRadius(5.0);
    this->setScallopHeight(0.1);
  }
  Values run()
  {
    this->compute(out);
    return out.empty() ? Values() : Values{this->getReport().area, this->getReport().path_length};
  }
  pcl::PointCloud<pcl::PointXYZI> out;
};

template <typename PointT>
struct Leads : LeadCheck<PointT> {
  Leads() { this->setCutter(CutterShape::ball(5.0)); }
  Values run()
  {
    ToolPoses poses; // a line over the top
    for (int i = 0; i <= 10; ++i) {
      const Vector3d place(2.0 * i - 10.0, 0.0, b + 1.0);
      poses.push_back({place, Vector3d::UnitZ(), place, Vector3d::UnitZ()});
    }
    MachineProgramGenerator generator;
    generator.setMachine(test::testMachines().front());
    generator.setInputPasses({poses});
    MachineProgram program;
    generator.compute(program);
    this->compute(program);
    return this->getStatus().ok() ? Values{static_cast<double>(this->getReport().moves)} : Values();
  }
};

template <typename PointT>
struct Flags : CentroidBoundaryEstimation<PointT, pcl::Normal> {
  Flags() { this->setKSearch(32); }
  Values run()
  {
    if (this->getInputCloud() && !this->getInputCloud()->empty()) {
      pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
      for (const PointT& p : *this->getInputCloud())
        normals->push_back(pcl::Normal(p.x, p.y, p.z));
      this->setInputNormals(normals);
    }
    this->compute(out);
    Values values;
    for (const pcl::Boundary& flag : out)
      values.push_back(flag.boundary_point);
    return values;
  }
  pcl::PointCloud<pcl::Boundary> out;
};

class ReusedStages : public testing::Test {
protected:
  ReusedStages() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
};

} // namespace

TEST_F(ReusedStages, Surface)
{
  checkReuse<Scanned>("ScannedSurface");
}
TEST_F(ReusedStages, Filters)
{
  checkReuse<Prepared>("SurfacePreparation");
  checkReuse<Removal>("OutlierRemoval");
}
TEST_F(ReusedStages, Boundaries)
{
  checkReuse<Flags>("CentroidBoundaryEstimation");
  checkReuse<Loops>("BoundaryLoops");
  checkReuse<Bridged>("GapBridging");
}
TEST_F(ReusedStages, Graph)
{
  checkReuse<Graph>("EllipticGabrielGraph");
}
TEST_F(ReusedStages, Geodesics)
{
  checkReuse<Geodesic>("GeodesicPath");
}
TEST_F(ReusedStages, Projector)
{
  checkReuse<Projected>("MLSProjector");
}
TEST_F(ReusedStages, Spiral)
{
  checkReuse<Lines>("RadialLines");
  checkReuse<Spiral>("SpiralToolpathGenerator");
}
TEST_F(ReusedStages, Cutter)
{
  checkReuse<Located>("CutterLocation");
  checkReuse<Driven>("DrivePath");
  checkReuse<Leads>("LeadCheck");
}
TEST_F(ReusedStages, Judges)
{
  checkReuse<Deviation>("DeviationEstimation");
  checkReuse<Removed>("MaterialRemoval");
}

TEST_F(ReusedStages, ThroughPclsBases)
{
  const auto cloud = cloudOf<pcl::PointXYZ>(dome(6000, 1));
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  for (const auto& p : *cloud)
    normals->push_back(pcl::Normal(p.x, p.y, p.z));
  CentroidBoundaryEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputNormals(normals);
  pcl::Feature<pcl::PointXYZ, pcl::Boundary>& feature = estimation;
  feature.setInputCloud(cloud);
  feature.setKSearch(32);
  pcl::PointCloud<pcl::Boundary> flags;
  feature.compute(flags);
  EXPECT_EQ(flags.size(), cloud->size());

  MLSProjector<pcl::PointXYZ, pcl::PointNormal> projector;
  pcl::CloudSurfaceProcessing<pcl::PointXYZ, pcl::PointNormal>& processing = projector;
  pcl::PointCloud<pcl::PointNormal> feet;
  processing.process(feet);
  EXPECT_TRUE(feet.empty());
  EXPECT_FALSE(projector.getStatus().ok()) << "no cloud, and no crash";
  processing.setInputCloud(cloud);
  processing.process(feet);
  ASSERT_EQ(feet.size(), cloud->size());
  EXPECT_TRUE(feet.is_dense);

  SurfacePreparation<pcl::PointXYZ> preparation(true);
  OutlierRemoval<pcl::PointXYZ> removal(true);
  cloud->emplace_back(0.0f, 0.0f, 300.0f);
  for (pcl::Filter<pcl::PointXYZ>* filter :
       {static_cast<pcl::Filter<pcl::PointXYZ>*>(&preparation), static_cast<pcl::Filter<pcl::PointXYZ>*>(&removal)}) {
    pcl::PointCloud<pcl::PointXYZ> kept;
    filter->setInputCloud(cloud);
    filter->filter(kept);
    EXPECT_EQ(kept.size() + filter->getRemovedIndices()->size(), cloud->size());
    ASSERT_FALSE(filter->getRemovedIndices()->empty());
    EXPECT_EQ(filter->getRemovedIndices()->back(), 6000);
  }
}

TEST_F(ReusedStages, SettingsOfMovingLeastSquaresAreTakenOrRefused)
{
  const auto cloud = cloudOf<pcl::PointXYZ>(dome(6000, 1));
  pcl::PointCloud<pcl::PointNormal> feet;
  using Projector = MLSProjector<pcl::PointXYZ, pcl::PointNormal>;
  const auto outcome = [&](auto change) {
    Projector projector;
    projector.setInputCloud(cloud);
    change(projector);
    projector.process(feet);
    return projector.getStatus();
  };
  EXPECT_TRUE(outcome([](Projector& p) { p.setSearchRadius(6.0); }).ok());
  EXPECT_TRUE(outcome([](Projector& p) { p.setPolynomialOrder(0); }).ok());
  const Status order = outcome([](Projector& p) { p.setPolynomialOrder(3); });
  EXPECT_NE(order.message().find("setPolynomialOrder"), std::string::npos) << order.message();
  const Status search = outcome([](Projector& p) { p.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>()); });
  EXPECT_NE(search.message().find("setSearchMethod"), std::string::npos) << search.message();
  const Status radius = outcome([](Projector& p) { p.setSearchRadius(1e-3); });
  EXPECT_NE(radius.message().find("setSearchRadius"), std::string::npos) << radius.message();
  Projector projector;
  projector.setInputCloud(cloud);
  projector.setSearchRadius(6.0);
  projector.process(feet);
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  EXPECT_NEAR(projector.getNeighboursUsed(), M_PI * 36.0 / (surface->spacing() * surface->spacing()), 0.5);
}

} // namespace reused_stages_test
