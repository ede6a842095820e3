// SPDX-License-Identifier: BSD-3-Clause
// Each setter has one owner: through any base class, and in any order, a setting counts as through the class itself.
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/geodesic/geodesic_path.h>
#include <pcl_spiral/ridge/ridge_lines.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/mls_projector.h>
#include <pcl_spiral/verify/deviation_estimation.h>
#include <pcl_spiral/verify/material_removal.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace base_setters_test {

namespace {

using namespace pcl_spiral;
using P = pcl::PointXYZ;
using Cloud = pcl::PointCloud<P>;

/** A scan of the bowl or hill z = bend (x^2 + y^2) of the given radius about the origin. */
Cloud::Ptr
scanOf(double radius, double bend = -0.004, unsigned int seed = 1)
{
  const Cloud::Ptr cloud(new Cloud);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  for (double i = -radius; i <= radius; i += 1.0)
    for (double j = -radius; j <= radius; j += 1.0) {
      const double x = i + jitter(random), y = j + jitter(random);
      if (std::hypot(x, y) < radius)
        cloud->emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(bend * (x * x + y * y)));
    }
  return cloud;
}

/** Whether the class of \p getter is \p Base: a class that declared the name anew would be named itself. */
template <typename Base, typename Class, typename Result, typename... Arguments>
constexpr bool
isOf(Result (Class::*)(Arguments...))
{
  return std::is_same_v<Class, Base>;
}

template <typename Stage, typename Base>
constexpr bool
ownsNone()
{
  return isOf<Base>(&Stage::setInputNormals) && isOf<Base>(&Stage::setTrustNormals) && isOf<Base>(&Stage::setViewPoint) &&
         isOf<Base>(&Stage::clearViewPoint) && isOf<Base>(&Stage::setFlipNormals) && isOf<Base>(&Stage::setThinning) &&
         isOf<Base>(&Stage::setOutlierRemoval) && isOf<Base>(&Stage::setLargestPart) && isOf<Base>(&Stage::setPartAt) &&
         isOf<Base>(&Stage::clearPartAt) && isOf<Base>(&Stage::setClusterHandling) && isOf<Base>(&Stage::setNumberOfThreads) &&
         isOf<Base>(&Stage::setQuiet);
}

using Input = SurfaceInput<pcl::PCLBase<P>, P>;
static_assert(ownsNone<SpiralToolpathGenerator<P>, Input>());
static_assert(ownsNone<RadialLines<P>, Input>());
static_assert(ownsNone<BoundaryLoops<P>, Input>());
static_assert(ownsNone<GapBridging<P>, Input>());
static_assert(ownsNone<GeodesicPath<P>, Input>());
static_assert(ownsNone<RidgeLines<P>, Input>());
static_assert(ownsNone<StepOverField<P>, Input>());
static_assert(ownsNone<ScallopLoops<P>, Input>());
static_assert(ownsNone<LoopLinking<P>, Input>());
static_assert(ownsNone<DrivePath<P>, Input>());
static_assert(ownsNone<CutterLocation<P>, Input>());
static_assert(ownsNone<DeviationEstimation<P>, Input>());
static_assert(ownsNone<MaterialRemoval<P>, Input>());
static_assert(ownsNone<MLSProjector<P, pcl::PointNormal>, SurfaceInput<pcl::CloudSurfaceProcessing<P, pcl::PointNormal>, P>>());

using Setter = std::function<void(Input&, SpiralToolpathGenerator<P>&)>;

/** The setters in the order given by \p order; those of the base class through the base class. */
pcl::PointCloud<ToolpathPoint>
pathBy(const std::vector<int>& order)
{
  static const std::vector<Setter> setters = {[](Input&, SpiralToolpathGenerator<P>& spiral) { spiral.setToolRadius(5.0); },
                                              [](Input&, SpiralToolpathGenerator<P>& spiral) { spiral.setScallopHeight(0.1); },
                                              [](Input& input, SpiralToolpathGenerator<P>&) { input.setFlipNormals(true); },
                                              [](Input& input, SpiralToolpathGenerator<P>&) { input.setThinning(1.5); },
                                              [](Input& input, SpiralToolpathGenerator<P>&) { input.setNumberOfThreads(1); },
                                              [](Input& input, SpiralToolpathGenerator<P>&) {
                                                input.setViewPoint({0.0, 0.0, 500.0});
                                              },
                                              [](Input& input, SpiralToolpathGenerator<P>&) { input.setInputCloud(scanOf(30.0)); }};
  SpiralToolpathGenerator<P> spiral;
  for (const int i : order)
    setters[static_cast<std::size_t>(i)](spiral, spiral);
  pcl::PointCloud<ToolpathPoint> path;
  spiral.compute(path);
  EXPECT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  EXPECT_LT(spiral.getReport().used_points, 0.8 * static_cast<double>(scanOf(30.0)->size())) << "the thinning counts";
  return path;
}

double
reach(const Polyline& points)
{
  double farthest = 0.0;
  for (const Eigen::Vector3d& p : points)
    farthest = std::max(farthest, p.head<2>().norm());
  return farthest;
}

/** compute of \p stage leaves neither its old status nor, by \p isEmpty, any output if the callback throws, at whichever call. */
template <typename Stage, typename Compute, typename IsEmpty>
void
throwsOut(const std::string& name, Stage& stage, Compute compute, IsEmpty isEmpty)
{
  int calls = 0, at = 0;
  stage.setProgressCallback([&](double, const std::string&) -> bool {
    if (++calls == at)
      throw std::runtime_error("mine");
    return true;
  });
  compute();
  EXPECT_TRUE(stage.getStatus().ok()) << name << ": " << stage.getStatus().message();
  EXPECT_FALSE(isEmpty()) << name;
  const int all = calls;
  ASSERT_GT(all, 1) << name;
  for (at = 1; at <= all; at += std::max(1, all / 12)) {
    calls = 0;
    EXPECT_THROW(compute(), std::runtime_error) << name << " at call " << at;
    EXPECT_EQ(stage.getStatus().code(), StatusCode::Failed) << name << " at call " << at;
    EXPECT_NE(stage.getStatus().message().find("exception"), std::string::npos) << name;
    EXPECT_TRUE(isEmpty()) << name << " at call " << at;
  }
}

} // namespace

TEST(BaseSetters, AnyOrderThroughTheBaseGivesTheSamePath)
{
  std::vector<int> order{0, 1, 2, 3, 4, 5, 6};
  const pcl::PointCloud<ToolpathPoint> first = pathBy(order);
  ASSERT_FALSE(first.empty());
  EXPECT_LT(first[0].normal_z, 0.0f) << "the flip counts";
  std::mt19937 random(11);
  for (int trial = 0; trial < 6; ++trial) {
    std::shuffle(order.begin(), order.end(), random);
    const pcl::PointCloud<ToolpathPoint> path = pathBy(order);
    ASSERT_EQ(path.size(), first.size());
    for (std::size_t i = 0; i < path.size(); ++i)
      ASSERT_TRUE(path[i].getVector3fMap() == first[i].getVector3fMap() && path[i].getAxisVector3fMap() == first[i].getAxisVector3fMap());
  }
}

TEST(BaseSetters, SettingsAsAWholeAndOneByOneAreTheSame)
{
  SpiralToolpathGenerator<P> spiral;
  SpiralSettings settings;
  settings.part_at = Eigen::Vector3d(1.0, 2.0, 3.0);
  settings.clusters = ClusterHandling::Ride;
  settings.thinning = 0.5;
  settings.threads = 1;
  settings.trust_normals = false;
  spiral.setSettings(settings);
  const Input& input = spiral;
  EXPECT_EQ(input.getPartAt(), settings.part_at);
  EXPECT_EQ(input.getClusterHandling(), ClusterHandling::Ride);
  EXPECT_EQ(input.getThinning(), 0.5);
  EXPECT_EQ(input.getNumberOfThreads(), 1u);
  EXPECT_FALSE(input.getTrustNormals());
  spiral.setOutlierRemoval(12, 2.5);
  spiral.clearPartAt();
  EXPECT_EQ(spiral.getSettings().outlier_neighbours, 12);
  EXPECT_EQ(spiral.getSettings().outlier_deviations, 2.5);
  EXPECT_FALSE(spiral.getSettings().part_at);
}

TEST(BaseSetters, ASurfaceThroughTheBaseReplacesTheField)
{
  ScannedSurface<P> scanned;
  Surface::ConstPtr large, small;
  scanned.setInputCloud(scanOf(40.0));
  scanned.compute(large);
  scanned.setInputCloud(scanOf(20.0, -0.004, 2));
  scanned.compute(small);
  StepOverField<P> maker;
  maker.setInputSurface(large);
  maker.setToolRadius(5.0);
  maker.setScallopHeight(0.1);
  StepOverDistance::ConstPtr field;
  maker.compute(field);
  ASSERT_TRUE(field);
  LoopLinking<P> linking;
  ScallopLoops<P> loops;
  for (FieldInput<P>* stage : {static_cast<FieldInput<P>*>(&linking), static_cast<FieldInput<P>*>(&loops)}) {
    stage->setToolRadius(5.0);
    stage->setScallopHeight(0.1);
    stage->setInputField(field);
    Input& input = *stage;
    input.setInputSurface(small);
    EXPECT_FALSE(stage->getInputField());
  }
  LinkedPath path;
  linking.compute(path);
  ASSERT_TRUE(linking.getStatus().ok()) << linking.getStatus().message();
  EXPECT_LT(reach(path.points), 21.0);
  ScallopLoopSet set;
  loops.compute(set);
  ASSERT_TRUE(loops.getStatus().ok()) << loops.getStatus().message();
  EXPECT_LT(reach(set.loops.front().points), 21.0);
}

TEST(BaseSetters, AnExceptionFromTheCallbackLeavesNoOldResult)
{
  const Cloud::Ptr scan = scanOf(25.0);
  SpiralToolpathGenerator<P> spiral;
  spiral.setInputCloud(scan);
  spiral.setToolRadius(5.0);
  spiral.setScallopHeight(0.1);
  pcl::PointCloud<ToolpathPoint> path;
  throwsOut(
      "SpiralToolpathGenerator", spiral, [&] { spiral.compute(path); }, [&] { return path.empty(); });
  ScannedSurface<P> scanned;
  scanned.setInputCloud(scan);
  Surface::ConstPtr surface;
  throwsOut(
      "ScannedSurface", scanned, [&] { scanned.compute(surface); }, [&] { return !surface; });
  BoundaryLoops<P> boundaries;
  boundaries.setInputCloud(scan);
  std::vector<BoundaryLoop> loops;
  throwsOut(
      "BoundaryLoops", boundaries, [&] { boundaries.compute(loops); }, [&] { return loops.empty(); });
  RadialLines<P> radial;
  radial.setInputCloud(scan);
  RadialLineSet lines;
  throwsOut(
      "RadialLines", radial, [&] { radial.compute(lines); }, [&] { return lines.lines.empty(); });
  StepOverField<P> field;
  field.setInputCloud(scan);
  field.setToolRadius(5.0);
  field.setScallopHeight(0.1);
  StepOverDistance::ConstPtr distance;
  throwsOut(
      "StepOverField", field, [&] { field.compute(distance); }, [&] { return !distance; });
  GapBridging<P> bridging;
  bridging.setInputCloud(scan);
  BridgedSurface bridged;
  throwsOut(
      "GapBridging", bridging, [&] { bridging.compute(bridged); }, [&] { return !bridged.surface; });
}

} // namespace base_setters_test
