// SPDX-License-Identifier: BSD-3-Clause
// The simulated scans against the exact spheroid and the exact ridge.
#include <pcl_spiral/io/cloud_reader.h>

#include "support/made_ridge.h"
#include "support/ridges.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace simulate_scan_test {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
namespace fs = std::filesystem;

constexpr double radius = 300, height = 156;

/** Signed distance of a point to the spheroid, to first order: enough for millimetres. */
double
distance(const pcl::PointXYZ& p)
{
  const Eigen::Vector3d x = p.getVector3fMap().cast<double>();
  const Eigen::Vector3d s(x.x() / radius, x.y() / radius, x.z() / height);
  const Eigen::Vector3d gradient(s.x() / radius, s.y() / radius, s.z() / height);
  return (s.squaredNorm() - 1) / (2 * gradient.norm());
}

class SimulateScan : public testing::Test {
protected:
  SimulateScan() : folder_(fs::temp_directory_path() / ("pcl_spiral_scan_" + std::to_string(::getpid())))
  {
    fs::create_directories(folder_);
  }
  ~SimulateScan() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  int run(const std::string& options) const
  {
    const std::string program = "'" PCL_SPIRAL_SIMULATE_SCAN_PROGRAM "' ";
    return WEXITSTATUS(std::system((program + options + " >/dev/null 2>" + file("said")).c_str()));
  }
  Cloud scan(const std::string& options) const
  {
    Cloud cloud;
    EXPECT_EQ(run("-o " + file("scan.pcd") + " " + options), 0);
    EXPECT_EQ(pcl::io::loadPCDFile(file("scan.pcd"), cloud), 0);
    return cloud;
  }
  std::string bytes(const std::string& name) const
  {
    std::ifstream in(file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
};

TEST_F(SimulateScan, withoutNoiseEveryPointIsOnTheSpheroidInScanLines)
{
  const Cloud cloud = scan("--noise 0 --outliers 0 --shadow 0");
  std::set<float> lines;
  double widest = 0;
  for (const auto& p : cloud) {
    ASSERT_NEAR(distance(p), 0, 1e-4);
    ASSERT_LE(std::hypot(p.x, p.y), 270 + 1e-3);
    widest = std::max(widest, double(std::hypot(p.x, p.y)));
    lines.insert(p.x);
  }
  EXPECT_EQ(lines.size(), 269u); // every 2 mm inside the rim; the outermost two only touch it
  EXPECT_GT(widest, 269);
  EXPECT_GT(cloud.size(), 80000u);
}

TEST_F(SimulateScan, noiseOutliersAndShadowAreAsAsked)
{
  const Cloud cloud = scan("--noise 0.05 --outliers 0.01 --shadow 0");
  double sum = 0;
  std::size_t far = 0, near = 0;
  for (const auto& p : cloud) {
    if (std::hypot(p.x, p.y) > 60)
      continue; // where the beam is oblique to the surface, the distance is smaller than the error
    const double d = distance(p);
    (std::abs(d) > 0.5 ? far : near) += 1;
    sum += std::abs(d) > 0.5 ? 0 : d * d;
  }
  EXPECT_NEAR(std::sqrt(sum / near), 0.05, 0.003);
  EXPECT_NEAR(double(far) / (near + far), 0.01, 0.003);

  const std::size_t all = scan("--noise 0 --outliers 0 --shadow 0").size();
  const std::size_t some = scan("--noise 0 --outliers 0 --shadow 12").size();
  const double hidden = (all - some) * 2.0; // mm^2 at 2 mm by about 1 mm
  EXPECT_GT(hidden, 1.5 * M_PI * 36);       // seen by laser and camera: twice the object, partly overlapping
  EXPECT_LT(hidden, 3.5 * M_PI * 36);
}

TEST_F(SimulateScan, seedDecidesTheBytesAndFormatsAgree)
{
  ASSERT_EQ(run("-o " + file("a.pcd")), 0);
  ASSERT_EQ(run("-o " + file("b.pcd")), 0);
  ASSERT_EQ(run("-o " + file("c.pcd") + " --seed 2"), 0);
  ASSERT_EQ(run("-o " + file("a.ply")), 0);
  EXPECT_EQ(bytes("a.pcd"), bytes("b.pcd"));
  EXPECT_NE(bytes("a.pcd"), bytes("c.pcd"));
  Cloud pcd, ply;
  ASSERT_EQ(pcl::io::loadPCDFile(file("a.pcd"), pcd), 0);
  ASSERT_EQ(pcl::io::loadPLYFile(file("a.ply"), ply), 0);
  ASSERT_EQ(pcd.size(), ply.size());
  for (std::size_t i = 0; i < pcd.size(); ++i)
    ASSERT_EQ(pcd[i].getVector3fMap(), ply[i].getVector3fMap());
}

TEST_F(SimulateScan, refusesWhatItCannotDoAndLeavesNoFile)
{
  for (const std::string wrong :
       {"--rim 301", "--noise -1", "--line-spacing 0", "--outliers 1", "--radius nan", "--line-spacing 1e-9", "--bogus 1"}) {
    EXPECT_EQ(run("-o " + file("scan.pcd") + " " + wrong), 2) << wrong;
    EXPECT_FALSE(bytes("said").empty()) << wrong;
  }
  EXPECT_EQ(run("-o " + file("scan.xyz")), 2);
  EXPECT_EQ(run(""), 2);
  EXPECT_EQ(run("-o " + file("missing/scan.pcd")), 1);
  EXPECT_EQ(run("-o " + file("missing/scan.ply")), 1);
  for (const auto& entry : fs::directory_iterator(folder_))
    EXPECT_EQ(entry.path().filename(), "said");
}

} // namespace

TEST_F(SimulateScan, ColumnHasItsRadiusAllRound)
{
  const double mean = 30.0;
  const Cloud cloud = scan("--part column --radius 30 --height 60 --line-spacing 1 --point-spacing 0.5 --noise 0 --outliers 0");
  ASSERT_EQ(cloud.size(), 189U * 120U);
  double least = 1e9, largest = 0;
  for (const auto& p : cloud) {
    const double angle = std::atan2(p.y, p.x), r = std::hypot(p.x, p.y);
    const double lobes = 0.05 * std::sin(5 * angle + p.z * 2 * M_PI / 75), waist = 0.1 * std::sin(p.z * 2 * M_PI / 60);
    ASSERT_NEAR(r, mean * (1 + lobes + waist), 1e-4);
    least = std::min(least, r);
    largest = std::max(largest, r);
  }
  EXPECT_LT(least, 0.87 * mean);
  EXPECT_GT(largest, 1.13 * mean);
  EXPECT_EQ(run("-o " + file("a.pcd") + " --part cone"), 2);
}

namespace {

using pcl_spiral::test::dieRidge;

pcl_spiral::Polyline
lineIn(const std::string& file)
{
  pcl_spiral::Polyline line;
  const Cloud::ConstPtr cloud = pcl_spiral::readCloud(file).cloud;
  for (const auto& p : *cloud)
    line.push_back(p.getVector3fMap().cast<double>());
  return line;
}

/** Distances of every \p step -th point from the exact ridge. */
std::vector<double>
offRidge(const pcl_spiral::Polyline& points, std::size_t step)
{
  static const pcl_spiral::test::ExactRidge die = dieRidge();
  std::vector<double> off;
  for (std::size_t i = 0; i < points.size(); i += step) {
    double least = 1e9;
    for (const double guess : {0.1, 0.4, 0.8}) {
      double t = points[i].x() / 600.0, w = guess;
      least = std::min(least, die.distance(points[i], t, w));
    }
    off.push_back(least);
  }
  return off;
}

} // namespace

TEST_F(SimulateScan, RidgeIsTheExactOneWithItsNoise)
{
  ASSERT_EQ(run("--part ridge -o " + file("ridge.pcd") + " --noise 0 --outliers 0"), 0);
  for (const char* name : {"ridge.pcd", "ridge_rail.pcd", "ridge_generator.pcd"})
    for (const double d : offRidge(lineIn(file(name)), 23))
      ASSERT_LT(d, 1e-4) << name;
  const pcl_spiral::Polyline scan = lineIn(file("ridge.pcd"));
  EXPECT_GT(scan.size(), 60000u); // 0.5 mm apart
  EXPECT_LT(scan.size(), 75000u);
  double farthest = 0.0;
  for (const Eigen::Vector3d& p : scan)
    farthest = std::max(farthest, p.x());
  EXPECT_GT(farthest, 590.0);
  ASSERT_EQ(run("--part ridge -o " + file("noisy.pcd") + " --noise 0.05 --outliers 0.01"), 0);
  double squares = 0.0;
  std::size_t near = 0, far = 0;
  for (const double d : offRidge(lineIn(file("noisy.pcd")), 7)) {
    (d > 1.0 ? far : near) += 1;
    squares += d > 1.0 ? 0.0 : d * d;
  }
  EXPECT_NEAR(std::sqrt(squares / near), 0.05, 0.003);
  EXPECT_NEAR(double(far) / (near + far), 0.01, 0.003);
}

TEST_F(SimulateScan, LinesOfTheRidgeMakeIt)
{
  ASSERT_EQ(run("--part ridge -o " + file("ridge.ply") + " --seed 3"), 0);
  const auto rail = lineIn(file("ridge_rail.ply")), generator = lineIn(file("ridge_generator.ply"));
  EXPECT_EQ(rail.size(), 300u);
  EXPECT_EQ(generator.size(), 60u);
  const auto ridge = pcl_spiral::test::madeRidge(rail, generator);
  ASSERT_TRUE(ridge);
  EXPECT_NEAR(ridge->report().rail_error, 0.02, 0.005);
  pcl_spiral::Polyline places;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 6; ++j)
      places.push_back(ridge->position(ridge->rail().length() * i / 40, ridge->generator().length() * j / 6));
  for (const double d : offRidge(places, 1))
    EXPECT_LT(d, 0.1);
}

TEST_F(SimulateScan, SeedDecidesTheBytesOfARidgeAndForeignOptionsAreRefused)
{
  ASSERT_EQ(run("--part ridge -o " + file("a.pcd") + " --line-spacing 2"), 0);
  ASSERT_EQ(run("--part ridge -o " + file("b.pcd") + " --line-spacing 2"), 0);
  ASSERT_EQ(run("--part ridge -o " + file("c.pcd") + " --line-spacing 2 --seed 2"), 0);
  for (const std::string part : {"", "_rail", "_generator"}) {
    EXPECT_EQ(bytes("a" + part + ".pcd"), bytes("b" + part + ".pcd"));
    EXPECT_NE(bytes("a" + part + ".pcd"), bytes("c" + part + ".pcd"));
  }
  for (const std::string option : {"--radius 3", "--height 3", "--rim 3", "--shadow 0", "--standoff 100"}) {
    EXPECT_EQ(run("--part ridge -o " + file("d.pcd") + " " + option), 2) << option;
    EXPECT_NE(bytes("said").find("does not apply to --part ridge"), std::string::npos);
  }
  fs::create_directories(file("e_generator.pcd")); // so that the third file cannot be written
  EXPECT_EQ(run("--part ridge -o " + file("e.pcd") + " --line-spacing 2"), 1);
  for (const char* none : {"d.pcd", "d_rail.pcd", "e.pcd", "e_rail.pcd"})
    EXPECT_FALSE(fs::exists(file(none))) << none;
}

} // namespace simulate_scan_test
