// The simulated scan against the spheroid it is taken from.
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

  std::string
  file(const std::string& name) const
  {
    return (folder_ / name).string();
  }
  int
  run(const std::string& options) const
  {
    const std::string program = "'" PCL_SPIRAL_EXAMPLES_DIR "/pcl_spiral_simulate_scan' ";
    return WEXITSTATUS(std::system((program + options + " >/dev/null 2>" + file("said")).c_str()));
  }
  Cloud
  scan(const std::string& options) const
  {
    Cloud cloud;
    EXPECT_EQ(run("-o " + file("scan.pcd") + " " + options), 0);
    EXPECT_EQ(pcl::io::loadPCDFile(file("scan.pcd"), cloud), 0);
    return cloud;
  }
  std::string
  bytes(const std::string& name) const
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
  EXPECT_EQ(lines.size(), 269u); // every 2 mm within the rim; the outermost two only graze it
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
      continue; // where the beam meets the surface obliquely, the distance is shorter than the error
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
  for (const std::string wrong : {"--rim 301", "--noise -1", "--line-spacing 0", "--outliers 1",
                                  "--radius nan", "--line-spacing 1e-9", "--bogus 1"}) {
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
  const Cloud cloud =
      scan("--part column --radius 30 --height 60 --line-spacing 1 --point-spacing 0.5 --noise 0 --outliers 0");
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
