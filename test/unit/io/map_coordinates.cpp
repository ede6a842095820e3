// SPDX-License-Identifier: BSD-3-Clause
// Coordinates of maps: the reader finds a round place near the points, and toolpath files hold the coordinates of the scan to the last
// digit.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

namespace map_coordinates_test {

using namespace pcl_spiral;

namespace {

const Eigen::Vector3d place(393775400.0, 3689071200.0, 3107003.0); ///< mm; x 393775.4 m, y 3689071.2 m
const Eigen::Vector3d whole(393775400.0, 3689071200.0, 3107000.0); ///< rounded to 100 mm

/** Points of a dome round the place, mm. */
std::vector<Eigen::Vector3d>
dome(double radius = 40.0)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 500; ++i) {
    const double r = radius * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    points.push_back(place + Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), -r * r / (5.0 * radius)));
  }
  return points;
}

std::string
textOf(const std::vector<Eigen::Vector3d>& points, double unit)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(10);
  for (const Eigen::Vector3d& p : points)
    text << p.x() / unit << ' ' << p.y() / unit << ' ' << p.z() / unit << '\n';
  return text.str();
}

class MapCoordinates : public ::testing::Test {
protected:
  MapCoordinates() { options_.find_origin = true; }

  Scan read(const std::string& text)
  {
    writeText(folder_.path("scan.xyz"), text);
    return readCloud(folder_.path("scan.xyz"), options_);
  }

  ScratchFolder folder_;
  ReadOptions options_;
};

pcl::PointCloud<ToolpathPoint>
path()
{
  pcl::PointCloud<ToolpathPoint> points;
  for (const Eigen::Vector3d& p : dome()) {
    points.emplace_back();
    points.back().getVector3fMap() = (p - whole).cast<float>();
    points.back().normal_z = points.back().axis_z = 1.0f;
    points.back().arc_length = static_cast<double>(points.size());
  }
  return points;
}

} // namespace

TEST_F(MapCoordinates, AreShiftedToARoundPlaceInAnyUnit)
{
  for (const LengthUnit unit : {LengthUnit::Metre, LengthUnit::Foot, LengthUnit::SurveyFoot, LengthUnit::Inch, LengthUnit::Millimetre}) {
    options_.unit = unit;
    const std::vector<Eigen::Vector3d> points = dome();
    const Scan scan = read(textOf(points, millimetres(unit)));
    EXPECT_EQ(scan.shift, whole);
    EXPECT_TRUE(scan.warnings.empty()) << scan.warnings[0];
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_LE(((*scan.cloud)[i].getVector3fMap().cast<double>() + scan.shift - points[i]).norm(), 5e-5);
  }
}

TEST_F(MapCoordinates, OnlyWhereRoundingMattersAndThePartIsSmall)
{
  std::vector<Eigen::Vector3d> points = dome();
  options_.unit = LengthUnit::Metre;
  points.push_back(Eigen::Vector3d::Zero()); // an invalid point of a scanner
  EXPECT_EQ(read(textOf(points, 1000.0)).shift, whole) << "a point elsewhere moves nothing";

  points = dome();
  for (Eigen::Vector3d& p : points)
    p.z() -= 3100000.0; // 7 m high: single precision keeps it
  EXPECT_EQ(read(textOf(points, 1000.0)).shift, Eigen::Vector3d(whole.x(), whole.y(), 0.0));
  for (Eigen::Vector3d& p : points)
    p -= Eigen::Vector3d(place.x(), place.y(), 0.0);
  EXPECT_TRUE(read(textOf(points, 1000.0)).shift.isZero());

  const Scan hull = read("0 0 0\n0 60 0\n50 0 0\n60 60 1\n60 0 3\n"); // metres about 0: nothing to gain
  EXPECT_TRUE(hull.shift.isZero());
  ASSERT_EQ(hull.warnings.size(), 1U);
  EXPECT_NE(hull.warnings[0].text().find("no origin avoids it"), std::string::npos) << hull.warnings[0];

  options_.find_origin = false;
  const Scan rounded = read(textOf(dome(), 1000.0));
  EXPECT_TRUE(rounded.shift.isZero());
  ASSERT_EQ(rounded.warnings.size(), 1U);
  EXPECT_NE(rounded.warnings[0].text().find("ReadOptions::find_origin"), std::string::npos) << rounded.warnings[0];
}

TEST_F(MapCoordinates, InAWrongUnitAreNotAskedForInches)
{
  for (const bool find : {true, false}) { // metres read as mm: 0.08 mm across
    options_.find_origin = find;
    const Scan scan = read(textOf(dome(), 1000.0));
    ASSERT_FALSE(scan.warnings.empty());
    EXPECT_NE(scan.warnings.back().text().find("at map coordinates, which are usually in metres or feet"), std::string::npos);
    for (const pcl_spiral::Diagnostic& warning : scan.warnings)
      EXPECT_EQ(warning.text().find("metres or inches"), std::string::npos) << warning;
  }
}

TEST_F(MapCoordinates, MeshAndViewPointMoveWithTheScan)
{
  writeText(folder_.path("mesh.ply"),
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "393775400 3689071200 3107003\n393775450 3689071200 3107003\n393775400 3689071250 3107003\n3 0 1 2\n");
  EXPECT_EQ(readMesh(folder_.path("mesh.ply"), options_).shift, whole);
  const std::string points = textOf(dome(), 1000.0);
  writeText(folder_.path("scan.pcd"), "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 500\nHEIGHT 1\n"
                                      "VIEWPOINT 393775.4 3689071.2 3112 1 0 0 0\nPOINTS 500\nDATA ascii\n" +
                                          points);
  options_.unit = LengthUnit::Metre;
  const Scan scan = readCloud(folder_.path("scan.pcd"), options_);
  EXPECT_EQ(scan.shift, whole);
  ASSERT_TRUE(scan.view_point.has_value());
  EXPECT_LE((*scan.view_point - Eigen::Vector3d(0.0, 0.0, 5000.0)).norm(), 1e-5);
}

TEST_F(MapCoordinates, ToolpathFilesHoldTheScansCoordinates)
{
  const pcl::PointCloud<ToolpathPoint> points = path();
  ToolpathMotion motion{3.0, 1000.0};
  motion.origin = whole;
  for (const std::string extension : {".csv", ".pcd", ".ply", ".vtp"}) {
    SCOPED_TRACE(extension);
    const std::string file = folder_.path("path" + extension);
    writeToolpath(file, points, motion);
    const ToolpathFile back = readToolpath(file, whole);
    ASSERT_EQ(back.path.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_LE((back.path[i].getVector3fMap() - points[i].getVector3fMap()).norm(), 5e-5f) << i;
    if (extension == ".csv") {
      ASSERT_EQ(back.tips.size(), points.size());
      EXPECT_LE((back.tips[7] - toolTip(points[7], 3.0)).norm(), 2e-6);
    }
  }
  const Eigen::Vector3d first = points[0].getVector3fMap().cast<double>() + whole;
  std::ostringstream field;
  field << std::fixed << std::setprecision(6) << first.x() << ',' << first.y() << ',' << first.z() << ',';
  EXPECT_NE(readText(folder_.path("path.csv")).find("\n0.000000,1.000000," + field.str()), std::string::npos) << field.str();
  const Scan vertices = readCloud(folder_.path("path.ply"), options_); // its x y z are double
  EXPECT_EQ(vertices.shift, whole);
  EXPECT_LE(((*vertices.cloud)[0].getVector3fMap() - points[0].getVector3fMap()).norm(), 5e-5f);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder_.path("path.vtp").c_str());
  reader->Update();
  EXPECT_NEAR(reader->GetOutput()->GetPoint(0)[1], first.y(), 1e-6);
  pcl::PointCloud<ToolpathPoint> by_pcl; // float: stays relative, and names the place in a comment
  ASSERT_EQ(pcl::io::loadPCDFile(folder_.path("path.pcd"), by_pcl), 0);
  EXPECT_EQ(by_pcl[0].x, points[0].x);
  EXPECT_NE(readText(folder_.path("path.pcd")).find("393775400 3689071200 3107000\n"), std::string::npos);
}

} // namespace map_coordinates_test
