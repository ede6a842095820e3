// SPDX-License-Identifier: BSD-3-Clause
// Radial lines of clouds with known lines: radii, meridians, corners; and refusals.
#include "support/plane_lines.h"
#include "support/sampling.h"

#include <pcl_spiral/spiral/radial_lines.h>

#include <gtest/gtest.h>

namespace radial_lines_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Lines = RadialLines<pcl::PointXYZ>;

test::Sampled
plane(std::vector<test::PlaneLoop> loops, std::size_t count = 5000)
{
  return test::sampleUniform(*test::flat(test::Region(std::move(loops))), count, 51);
}

/** Largest distance of a line's curve from the straight line between two points. */
double
bow(const RadialLine& line, const Vector3d& a, const Vector3d& b)
{
  double most = 0.0;
  for (int k = 0; k <= 400; ++k) {
    const Vector3d p = line.curve.positionAt(line.length() * k / 400.0);
    most = std::max(most, (p - a).cross((b - a).normalized()).norm());
  }
  return most;
}

/** Pairs of segments of different lines that cross in plan, farther than \p clear from \p centre. */
std::size_t
crossings(const std::vector<RadialLine>& lines, const Vector3d& centre, double clear)
{
  const auto side = [](const Vector3d& a, const Vector3d& b, const Vector3d& p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()) > 0.0;
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 2; k < lines[i].feet.size(); k += 2)
        for (std::size_t l = 2; l < lines[j].feet.size(); l += 2) {
          const Vector3d &a = lines[i].feet[k - 2].position, &b = lines[i].feet[k].position;
          const Vector3d &c = lines[j].feet[l - 2].position, &d = lines[j].feet[l].position;
          if ((a - centre).norm() < clear || (c - centre).norm() < clear)
            continue;
          count += side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
        }
  return count;
}

void
expectSplines(const std::vector<RadialLine>& lines, double tolerance)
{
  for (const RadialLine& line : lines) {
    EXPECT_LE(line.deviation, tolerance);
    double worst = 0.0;
    for (std::size_t k = 0; k < line.feet.size(); k += 7) { // nearest place on the curve, by a search round the foot
      const double s = line.stationSpacing() * static_cast<double>(k);
      double nearest = 1e300;
      for (double t = -0.5; t <= 0.5; t += 0.01)
        nearest = std::min(nearest, (line.curve.positionAt(s + t * line.stationSpacing()) - line.feet[k].position).norm());
      worst = std::max(worst, nearest);
    }
    EXPECT_LE(worst, tolerance + 0.005 * line.stationSpacing());
    EXPECT_LE((line.curve.positionAt(0.0) - line.feet.front().position).norm(), 1e-9);
    EXPECT_LE((line.curve.positionAt(line.length()) - line.feet.back().position).norm(), 1e-9);
  }
}

TEST(RadialLines, RadiiOfADisc)
{
  const auto cloud = test::toCloud(plane({test::circle({0, 0}, 60.0)}).points);
  Lines radial;
  radial.setInputCloud(cloud);
  std::vector<RadialLine> lines;
  radial.compute(lines);
  ASSERT_TRUE(radial.getStatus().ok()) << radial.getStatus().message();
  EXPECT_LT(radial.getCenter().norm(), 1.0); // found
  EXPECT_EQ(radial.getLoops().size(), 1u);

  auto loops = radial.getLoops();
  loops[0].curve = test::ring(60.0, 720); // the true outline
  loops[0].corners.clear();
  radial.setBoundaryLoops(loops);
  radial.setCenter({0, 0, 0});
  radial.setStartPoint({70, 0, 0});
  radial.compute(lines);
  ASSERT_TRUE(radial.getStatus().ok()) << radial.getStatus().message();
  EXPECT_FALSE(radial.usedHarmonic());
  ASSERT_GE(lines.size(), 32u);
  EXPECT_EQ(lines[0].rim_share, 0.0);
  double worst = 0.0;
  for (const RadialLine& line : lines) {
    const double angle = 2.0 * M_PI * line.rim_share;
    const Vector3d end(60.0 * std::cos(angle), 60.0 * std::sin(angle), 0.0);
    EXPECT_LT((line.feet.back().position - end).norm(), 1e-3);
    EXPECT_EQ(line.feet.front().position.norm(), 0.0);
    EXPECT_NEAR(line.length(), 60.0, 2e-3);
    worst = std::max(worst, bow(line, Vector3d::Zero(), end));
    if (line.level == 0)
      EXPECT_NEAR(std::remainder(32.0 * line.rim_share, 1.0), 0.0, 1e-9); // equal angles
  }
  std::printf("  %zu lines, largest bow %.5f mm\n", lines.size(), worst);
  EXPECT_LT(worst, 0.01);
  EXPECT_EQ(crossings(lines, Vector3d::Zero(), 2.0), 0u);
  expectSplines(lines, radial.getFitTolerance());
}

TEST(RadialLines, MeridiansOfASpheroid)
{
  const auto cloud = test::toCloud(test::sampleUniform(*test::spheroidCap(165.0, 86.0), 8000, 52).points);
  Lines radial;
  radial.setInputCloud(cloud);
  radial.setCenter({0, 0, 86});
  std::vector<RadialLine> lines;
  radial.compute(lines);
  ASSERT_TRUE(radial.getStatus().ok()) << radial.getStatus().message();
  EXPECT_FALSE(radial.usedHarmonic()) << radial.getWhyHarmonic();
  double sideways = 0.0, longest = 0.0;
  for (const RadialLine& line : lines) {
    const Vector3d end = line.feet.back().position, across = Vector3d(-end.y(), end.x(), 0.0).normalized();
    for (int k = 0; k <= 100; ++k)
      sideways = std::max(sideways, std::abs(line.curve.positionAt(0.01 * k * line.length()).dot(across)));
    longest = std::max(longest, line.length());
    EXPECT_NEAR(line.length(), 202.0480866, 4.0); // to the rim of the cloud, up to a spacing (3 mm) off the true one
  }
  std::printf("  %zu lines, farthest from a meridian %.4f mm\n", lines.size(), sideways);
  EXPECT_LT(sideways, 0.3);
  EXPECT_EQ(crossings(lines, Vector3d(0, 0, 86), 4.0), 0u);
  expectSplines(lines, radial.getFitTolerance());
}

TEST(RadialLines, AnnulusBetweenItsLoops)
{
  const auto cloud = test::toCloud(plane({test::circle({0, 0}, 80.0), test::circle({0, 0}, 30.0)}).points);
  Lines radial;
  radial.setInputCloud(cloud);
  std::vector<RadialLine> lines;
  radial.compute(lines);
  ASSERT_TRUE(radial.getStatus().ok()) << radial.getStatus().message();
  EXPECT_GT(radial.getInner().size(), 10u);
  for (const RadialLine& line : lines) {
    const Vector3d start = line.feet.front().position, end = line.feet.back().position;
    EXPECT_NEAR(start.norm(), 30.0, 1.5);
    EXPECT_NEAR(end.norm(), 80.0, 1.5);
    EXPECT_LT(bow(line, start, end), 0.02);                              // straight: a geodesic
    EXPECT_GT(start.normalized().dot(end.normalized()), std::cos(0.08)); // and radial, up to the roughness of the rims
  }
  EXPECT_EQ(crossings(lines, Vector3d::Zero(), 0.0), 0u);
  radial.setCenter({50, 0, 0});
  radial.compute(lines);
  EXPECT_EQ(radial.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_TRUE(lines.empty());
}

TEST(RadialLines, EveryCornerOfASquareHasItsLine)
{
  Lines radial;
  radial.setInputCloud(test::toCloud(plane({test::rectangle(100.0, 100.0)}).points));
  std::vector<RadialLine> lines;
  for (const LineMethod method : {LineMethod::Geodesic, LineMethod::Harmonic}) {
    radial.setLineMethod(method);
    radial.compute(lines);
    ASSERT_TRUE(radial.getStatus().ok()) << radial.getStatus().message();
    EXPECT_EQ(radial.usedHarmonic(), method == LineMethod::Harmonic);
    std::size_t corners = 0;
    for (const RadialLine& line : lines) {
      corners += line.corner;
      if (line.corner) {
        const Vector3d end = line.feet.back().position;
        EXPECT_NEAR(std::abs(end.x()), 50.0, 1.5);
        EXPECT_NEAR(std::abs(end.y()), 50.0, 1.5);
      }
    }
    EXPECT_EQ(corners, 4u);
    EXPECT_EQ(crossings(lines, radial.getCenter(), 3.0), 0u);
  }
}

TEST(RadialLines, MoveWithTheCloud)
{
  const auto sampled = test::sampleUniform(*test::quadric(200.0, -150.0, test::Region({test::ellipse(50, 40)})), 5000, 53);
  const Vector3d centre(0, 0, 0), start(60, 5, 0);
  const Eigen::Isometry3d motion = test::randomMotion(54, 40.0);
  test::Sampled moved = sampled;
  for (std::size_t i = 0; i < moved.points.size(); ++i) {
    moved.points[i] = motion * sampled.points[i];
    moved.normals[i] = motion.linear() * sampled.normals[i];
  }
  std::vector<RadialLine> lines, others;
  for (const bool after : {false, true}) {
    Lines radial;
    radial.setInputCloud(test::toCloud(after ? moved.points : sampled.points));
    radial.setInputNormals(test::toNormals(after ? moved.normals : sampled.normals));
    radial.setCenter(after ? Vector3d(motion * centre) : centre);
    radial.setStartPoint(after ? Vector3d(motion * start) : start);
    radial.compute(after ? others : lines);
    ASSERT_TRUE(radial.getStatus().ok()) << radial.getStatus().message();
  }
  ASSERT_EQ(lines.size(), others.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k < lines[i].feet.size(); k += 4)
      worst = std::max(worst, (motion * lines[i].feet[k].position - others[i].feet[k].position).norm());
  std::printf("  %zu lines, apart after a rigid motion by %.2g mm\n", lines.size(), worst);
  EXPECT_LT(worst, 0.01);
}

TEST(RadialLines, RefusesWithNoLines)
{
  const auto cloud = test::toCloud(plane({test::circle({0, 0}, 60.0)}, 3000).points);
  const auto refused = [&](const std::function<void(Lines&)>& change, StatusCode code, const std::string& word) {
    Lines radial;
    radial.setInputCloud(cloud);
    change(radial);
    std::vector<RadialLine> lines(3);
    radial.compute(lines);
    EXPECT_EQ(radial.getStatus().code(), code) << word;
    EXPECT_NE(radial.getStatus().message().find(word), std::string::npos) << radial.getStatus().message();
    EXPECT_TRUE(lines.empty()) << word;
  };
  const auto argument = StatusCode::InvalidArgument, input = StatusCode::InvalidInput;
  for (const std::string word : {"the centre (75", "three spacings", "or no centre"})
    refused([](Lines& r) { r.setCenter({75, 0, 0}); }, argument, word);
  refused([](Lines& r) { r.setCenter(Vector3d::Constant(std::nan(""))); }, argument, "finite");
  refused([](Lines& r) { r.setTolerance(0.0); }, argument, "tolerance");
  refused([](Lines& r) { r.setFitTolerance(-1.0); }, argument, "tolerance");
  refused([](Lines& r) { r.setNumberOfThreads(-2); }, argument, "threads");
  refused([](Lines& r) { r.setInputCloud(nullptr); }, input, "setInputCloud");
  refused([](Lines& r) { r.setInputCloud(test::toCloud({{0, 0, 0}, {1, 0, 0}})); }, input, "50");
  refused([](Lines& r) { r.setInputNormals(test::toNormals({Vector3d(0, 0, 1)})); }, input, "normals");
  refused([](Lines& r) { r.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{0, 3000})); }, input, "3000");
  refused([](Lines& r) { r.setBoundaryMode(BoundaryMode::TwoBoundaries); }, argument, "two boundaries");
  refused([](Lines& r) { r.setProgressCallback([](double, const std::string&) { return false; }); }, StatusCode::Cancelled, "cancelled");

  BoundaryLoop circle;
  circle.curve = circle.points = test::ring(60.0, 200);
  const auto with = [&](const std::function<void(BoundaryLoop&)>& change) {
    return [&circle, change](Lines& r) {
      BoundaryLoop loop = circle;
      change(loop);
      r.setBoundaryLoops({loop});
    };
  };
  refused(with([](BoundaryLoop& l) { std::reverse(l.curve.begin(), l.curve.end()); }), input, "on its right");
  refused(with([](BoundaryLoop& l) { l.curve = test::ring(90.0, 200); }), input, "mm from the cloud");
  refused(with([](BoundaryLoop& l) { l.curve.resize(2); }), input, "2 curve points");
  refused(with([](BoundaryLoop& l) { l.corners = {200}; }), input, "corner 200");
  refused(with([](BoundaryLoop& l) { l.type = LoopType::Inner; }), input, "outer");
}

TEST(RadialLines, AFailureLeavesNothing)
{
  Lines radial;
  radial.setQuiet(true);
  radial.setInputCloud(test::toCloud(plane({test::circle({0, 0}, 60.0)}, 3000).points));
  RadialLineSet set;
  radial.compute(set);
  ASSERT_TRUE(radial.getStatus().ok()) << radial.getStatus().message();
  EXPECT_FALSE(radial.getRim().empty());
  EXPECT_EQ(radial.getRim(), set.rim);
  radial.setCenter({75, 0, 0});
  radial.compute(set);
  EXPECT_FALSE(radial.getStatus().ok());
  EXPECT_TRUE(set.lines.empty());
  EXPECT_TRUE(set.rim.empty());
  EXPECT_TRUE(radial.getRim().empty());
  EXPECT_TRUE(radial.getLoops().empty());
  EXPECT_TRUE(radial.getWhyHarmonic().empty());
}

} // namespace

} // namespace radial_lines_test
