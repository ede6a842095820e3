// SPDX-License-Identifier: BSD-3-Clause
// Scans in every format: the same points from each, units and columns, and a clear error for each broken
// file.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/file_error.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace cloud_reader_test {

using namespace pcl_spiral;

namespace {

const std::vector<Eigen::Vector3f> points{{1.5f, -2.25f, 3.0f}, {4.0f, 5.5f, -6.0f}, {0.125f, 1e-3f, 700.5f}};

pcl::PointCloud<pcl::PointXYZ>
cloud()
{
  pcl::PointCloud<pcl::PointXYZ> result;
  for (const Eigen::Vector3f& p : points)
    result.emplace_back(p.x(), p.y(), p.z());
  return result;
}

void
expectPoints(const std::string& file, const ReadOptions& options = {}, float scale = 1.0f)
{
  const Scan scan = readCloud(file, options);
  ASSERT_EQ(scan.cloud->size(), points.size()) << file;
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LE(((*scan.cloud)[i].getVector3fMap() - scale * points[i]).norm(), 1e-7f * scale * points[i].norm()) << file << " point " << i;
}

/** The error message of reading; empty if there is no error. */
std::string
problem(const std::string& file, const ReadOptions& options = {})
{
  try {
    readCloud(file, options);
  }
  catch (const FileError& error) {
    return error.what();
  }
  return "";
}

class CloudReader : public ::testing::Test {
protected:
  std::string text(const std::string& name, const std::string& content)
  {
    writeText(folder_.path(name), content);
    return folder_.path(name);
  }
  void expectProblem(const std::string& name, const std::string& content, const std::string& words)
  {
    const std::string file = text(name, content), said = problem(file);
    EXPECT_NE(said.find(file), std::string::npos) << "names the file: " << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
  ScratchFolder folder_;
};

const std::string pcd_header = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\n"
                               "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ";
const std::string ply_vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string rows = "1.5 -2.25 3\n4 5.5 -6\n0.125 1e-3 700.5\n";

/** An organised cloud of 40 x 40 pixels with the default VIEWPOINT. \p at: of a pixel, with u and v from -1 to 1. */
template <typename Place>
std::string
organised(Place at)
{
  std::ostringstream text;
  text << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 40\nHEIGHT 40\nVIEWPOINT 0 0 0 1 0 0 0\n"
          "POINTS 1600\nDATA ascii\n";
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 40; ++column) {
      const Eigen::Vector3d place = at((column - 19.5) / 19.5, (row - 19.5) / 19.5);
      text << place.x() << ' ' << place.y() << ' ' << place.z() << '\n';
    }
  return text.str();
}

/** The point that a camera at the origin sees in the direction (u tan, v tan, 1) of a plane through (0, 0, 400) with normal \p n. */
Eigen::Vector3d
seen(double u, double v, const Eigen::Vector3d& n)
{
  const Eigen::Vector3d direction(0.4 * u, 0.4 * v, 1.0);
  return 400.0 * n.z() / n.dot(direction) * direction;
}

} // namespace

TEST_F(CloudReader, AnOrganisedCloudOfACameraIsSeenFromTheOrigin)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.0, Eigen::Vector3d(1.0, 2.0, 0.5).normalized()).toRotationMatrix();
  const Eigen::Vector3d oblique(0.8, 0.0, 0.6);
  for (const Eigen::Vector3d& n : {Eigen::Vector3d(0.0, 0.0, 1.0), oblique, Eigen::Vector3d(-0.3, 0.6, 0.74)})
    for (const bool turned : {false, true}) {
      const std::string content =
          organised([&](double u, double v) { return turned ? Eigen::Vector3d(turn * seen(u, v, n)) : seen(u, v, n); });
      const Scan scan = readCloud(text("camera.pcd", content));
      ASSERT_TRUE(scan.view_point.has_value()) << n.transpose();
      EXPECT_EQ(scan.view_point->norm(), 0.0);
    }
  const std::string missing = organised(
      [](double u, double v) { return u * v > 0.6 ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : seen(u, v, Eigen::Vector3d::UnitZ()); });
  EXPECT_TRUE(readCloud(text("missing.pcd", missing)).view_point.has_value());
}

TEST_F(CloudReader, AHeightMapIsNotSeenFromTheOrigin)
{
  for (const double height : {0.0, 1.0, 10.0})      // mm over z = 0
    for (const double aside : {0.0, 50.0, 400.0}) { // mm from the origin to the middle
      const std::string content = organised([&](double u, double v) {
        return Eigen::Vector3d(50.0 * u + aside, 50.0 * v + aside, height + 3.0 * std::cos(2.0 * u) * std::cos(v));
      });
      EXPECT_FALSE(readCloud(text("map.pcd", content)).view_point.has_value()) << height << ' ' << aside;
    }
  const std::string dome = organised([](double u, double v) { // the origin is its centre
    const double angle = M_PI * u, r = 25.0 * (1.0 + v);
    return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), std::sqrt(std::max(0.0, 2500.0 - r * r)));
  });
  EXPECT_FALSE(readCloud(text("dome.pcd", dome)).view_point.has_value());
}

TEST_F(CloudReader, FilesOfPcl)
{
  const std::string pcd = folder_.path("a.pcd"), ply = folder_.path("a.ply");
  pcl::io::savePCDFileASCII(pcd, cloud());
  expectPoints(pcd);
  pcl::io::savePCDFileBinary(pcd, cloud());
  expectPoints(pcd);
  pcl::io::savePCDFileBinaryCompressed(pcd, cloud());
  expectPoints(pcd);
  pcl::io::savePLYFileASCII(ply, cloud());
  expectPoints(ply);
  pcl::io::savePLYFileBinary(ply, cloud());
  expectPoints(ply);
}

TEST_F(CloudReader, TextInEveryDress)
{
  expectPoints(text("a.xyz", rows));
  expectPoints(text("b.xyz", "\xEF\xBB\xBF# a comment\n\n  1.5\t-2.25 3 7\r\n+4 5.5 -6 8\r\n0.125 1e-3 700.5 9"));
  expectPoints(text("c.csv", "z,x,y\n3,1.5,-2.25\n-6, 4, 5.5\n700.5,0.125,0.001\n"));
  expectPoints(text("d.csv", "\"X\";\"Y\";\"Z\";\"I\"\n1.5;-2.25;3;\n4;5.5;-6;1\n0.125;.001;700.5;1\n"));
  expectPoints(text("e.asc", "//X Y Z R G B\n1.5 -2.25 3 1 2 3\n4 5.5 -6 1 2 3\n0.125 0.001 700.5 1 2 3\n"));
  expectPoints(text("f.txt", "# z y x\n3 -2.25 1.5\n-6 5.5 4\n700.5 0.001 0.125\n"));
  ReadOptions options;
  options.columns = {"id", "z", "x", "y"};
  expectPoints(text("g.txt", "1 3 1.5 -2.25\n2 -6 4 5.5\n3 700.5 0.125 0.001\n"), options);
}

TEST_F(CloudReader, Meshes)
{
  expectPoints(text("a.obj", "o part\nv 1.5 -2.25 3\nv 4 5.5 -6 1.0\nvn 0 0 1\nv 0.125 0.001 700.5\nf 1 2 3\n"));
  expectPoints(text("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1.5 -2.25 3\nvertex 4 5.5 -6\n"
                             "vertex 0.125 0.001 700.5\nendloop\nendfacet\nendsolid a\n"));
  std::string binary(84 + 50, '\0');
  binary[80] = 1;
  for (std::size_t i = 0; i < 3; ++i)
    std::memcpy(&binary[84 + 12 + 12 * i], points[i].data(), 12);
  expectPoints(text("b.stl", binary));
  expectPoints(text("a.ply", "ply\nformat ascii 1.0\nelement camera 1\nproperty list uchar int k\n" + ply_vertices +
                                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n2 8 9\n" + rows + "3 0 1 2\n"));
}

TEST_F(CloudReader, BigEndianAndDoublePly)
{
  std::string bytes = "ply\nformat binary_big_endian 1.0\nelement face 1\nproperty list uchar short i\n"
                      "element vertex 3\nproperty double x\nproperty uchar red\nproperty float z\n"
                      "property double y\nend_header\n";
  bytes += std::string("\x02\0\1\0\2", 5);
  const auto put = [&bytes](auto value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    std::reverse(raw, raw + sizeof(value));
    bytes.append(raw, sizeof(value));
  };
  for (const Eigen::Vector3f& p : points) {
    put(static_cast<double>(p.x()));
    bytes += '\x7f';
    put(p.z());
    put(static_cast<double>(p.y()));
  }
  expectPoints(text("a.ply", bytes));
}

TEST_F(CloudReader, UnitsAndOriginInDoublePrecision)
{
  ReadOptions options;
  options.unit = LengthUnit::Metre;
  expectPoints(text("a.xyz", rows), options, 1000.0f);
  options.unit = LengthUnit::Inch;
  expectPoints(text("a.xyz", rows), options, 25.4f);

  const std::string far = text("far.xyz", "393775.001 3689071.002 3107.003\n393776.001 3689072.002 3108.003\n"
                                          "393775.501 3689071.002 3107.003\n");
  options.unit = LengthUnit::Metre;
  const Scan rounded = readCloud(far, options);
  ASSERT_EQ(rounded.warnings.size(), 1U) << "3.7e9 mm in single precision is a loss of 128 mm";
  EXPECT_NE(rounded.warnings[0].text().find("128 mm"), std::string::npos) << rounded.warnings[0];
  options.origin = {393775.0, 3689071.0, 3107.0};
  const Scan near = readCloud(far, options);
  EXPECT_TRUE(near.warnings.empty());
  EXPECT_NEAR((*near.cloud)[0].x, 1.0f, 1e-5f);
  EXPECT_NEAR((*near.cloud)[0].y, 2.0f, 1e-5f);
  EXPECT_NEAR((*near.cloud)[1].z, 1003.0f, 1e-4f);
}

TEST_F(CloudReader, TinyPartsHintAtTheUnit)
{
  const Scan scan = readCloud(text("a.xyz", "0 0 0\n0.5 0 0\n0 0.5 0\n"));
  ASSERT_EQ(scan.warnings.size(), 1U);
  EXPECT_NE(scan.warnings[0].text().find("ReadOptions::unit"), std::string::npos);
}

TEST_F(CloudReader, KeepsNotANumberPoints)
{
  const Scan scan = readCloud(text("a.xyz", "nan nan nan\n1 2 3\n1 2 3\n"));
  EXPECT_EQ(scan.cloud->size(), 3U);
  EXPECT_FALSE(scan.cloud->is_dense);
  EXPECT_TRUE(std::isnan((*scan.cloud)[0].x));
}

TEST_F(CloudReader, SaysWhatIsWrongWithTheFile)
{
  EXPECT_NE(problem(folder_.path("missing.pcd")).find("no such file"), std::string::npos);
  std::filesystem::create_directory(folder_.path("folder.pcd"));
  EXPECT_NE(problem(folder_.path("folder.pcd")).find("is a folder"), std::string::npos);
  for (const std::string& extension : cloudExtensions())
    expectProblem("empty" + extension, "", "is empty");
  expectProblem("a.dwg", "x", "'.dwg' is not known");
  expectProblem("noextension", "x", "is not known");
}

TEST_F(CloudReader, SaysWhatIsWrongInText)
{
  expectProblem("a.xyz", "1 2 3\n4 abc 6\n", "line 2: 'abc' is not a number");
  expectProblem("b.xyz", "1 2 3\n4 5 6\n7 8\n", "line 3: 2 columns");
  expectProblem("c.xyz", "# nothing\n\n", "no points (2 lines)");
  expectProblem("d.csv", "1,5;2,5;3,5\n", "point, not a comma");
  expectProblem("e.txt", "1,5 2,5 3,5\n", "point, not a comma");
  expectProblem("f.csv", "a,b,c\n1,2,3\n", "line 1: 'a' is neither a number nor a heading");
  expectProblem("g.csv", "x,y,height\n1,2,3\n", "has no 'z'; it has: x, y, height");
  expectProblem("h.xyz", "1 2\n3 4\n", "line 1: 2 column(s)");
  expectProblem("i.xyz", std::string("1 2 3\n\0\0\0", 9), "byte 6");
  expectProblem("j.obj", "v 1 2\n", "line 1");
  expectProblem("k.obj", "# none\n", "no vertices");
}

TEST_F(CloudReader, SaysWhatIsWrongInPcd)
{
  expectProblem("a.pcd", "hello", "line 1");
  expectProblem("b.pcd", "# .PCD v0.7\nVERSION 0.7\n", "no DATA");
  expectProblem("c.pcd", pcd_header + "ascii\n1 2 3\n4 5 6\n", "after 2 of 3 points");
  expectProblem("d.pcd", pcd_header + "ascii\n1 2 3\n4 x 6\n7 8 9\n", "line 12: 'x'");
  expectProblem("e.pcd", pcd_header + "ascii\n1 2 3\n4 6\n7 8 9\n", "line 12: 2 values");
  expectProblem("f.pcd", pcd_header + "binary\n1234567890", "cut off");
  expectProblem("g.pcd", pcd_header + "binary_compressed\nabc", "cut off");
  expectProblem("h.pcd", pcd_header + std::string("binary_compressed\n\x04\0\0\0\x24\0\0\0\xff\xff\xff\xff", 30), "unpacked");
  expectProblem("i.pcd", "FIELDS x y\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2\n", "has no 'z'; it has: x, y");
  expectProblem("j.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 400000000000\nHEIGHT 1\nDATA binary\n1", "cut off");
  expectProblem("k.pcd", "FIELDS x y z\nSIZE 3 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3\n", "SIZE 3");
  expectProblem("l.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nHEIGHT 1\nPOINTS 0\nDATA ascii\n", "no points");
}

TEST_F(CloudReader, SaysWhatIsWrongInPly)
{
  const std::string ascii = "ply\nformat ascii 1.0\n" + ply_vertices + "end_header\n";
  expectProblem("a.ply", "hello", "line 1");
  expectProblem("b.ply", ascii + "1 2 3\n4 abc 6\n7 8 9\n", "line 9: 'abc'");
  expectProblem("c.ply", ascii + "1 2 3\n4 5 6\n", "vertex 3 of 3");
  expectProblem("c2.ply", ascii.substr(0, ascii.size() - 1), "vertex 1 of 3"); // ends in its header, without a line end
  expectProblem("d.ply", ascii + "1 2 3\n4 5\n7 8 9\n", "line 9: 2 values");
  expectProblem("e.ply", "ply\nformat binary_little_endian 1.0\n" + ply_vertices + "end_header\n123456789", "cut off");
  expectProblem("f.ply",
                "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n",
                "no vertices");
  expectProblem("g.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n", "has no 'y'");
  expectProblem("h.ply",
                "ply\nformat binary_little_endian 1.0\nelement vertex 900000000000\nproperty float x\n"
                "property float y\nproperty float z\nend_header\n1",
                "cut off");
  expectProblem("i.ply", "ply\nformat ascii 1.0\nelement vertex 1\n", "no end_header");
  expectProblem("j.stl", "solid a\nfacet", "endsolid");
  expectProblem("k.stl", std::string(80, ' ') + std::string("\x09\0\0\0", 4), "cut off");
}

TEST_F(CloudReader, HeadersThatPromiseTooMuchAreRefusedBeforeMemoryIsTaken)
{
  const std::string fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n";
  expectProblem("a.pcd", fields + "WIDTH 999999999999999\nHEIGHT 1\nDATA binary\n1", "cut off");
  expectProblem("b.pcd", fields + "WIDTH 4294967296\nHEIGHT 4294967296\nDATA binary\n1",
                "WIDTH 4294967296 and HEIGHT 4294967296"); // their product is 0 in 64 bits
  expectProblem("c.pcd", fields + "COUNT 1 1 900000000000000\nWIDTH 99999\nHEIGHT 1\nDATA binary\n1", "COUNT 900000000000000");
  expectProblem("d.pcd", fields + "WIDTH 1e18\nHEIGHT 1\nDATA ascii\n1 2 3\n", "'1e18' is not a count");
  expectProblem("e.pcd", fields + "WIDTH 300000000\nHEIGHT 1\nDATA binary_compressed\n" + std::string("\x01\0\0\0\0\xa4\x93\xd6q", 9),
                "1 packed bytes cannot hold 3600000000");
  expectProblem("f.pcd", fields + "WIDTH 1\nHEIGHT 1\nDATA binary_compressed\n" + std::string("\0\0\0\0\x0c\0\0\0", 8), "0 packed bytes");
  const std::string binary = "ply\nformat binary_little_endian 1.0\n";
  expectProblem("g.ply",
                binary + "element vertex 999999999999999\nproperty float x\nproperty float y\nproperty float z\n"
                         "end_header\n1",
                "cut off");
  expectProblem("h.ply", binary + "element nothing 999999999999999\nend_header\n", "no vertices");
  expectProblem("i.ply", binary + "element face 999999999999999\nproperty list uint double k\nend_header\n\xff\xff\xff\xff", "cut off");
  expectProblem("j.stl", std::string(80, ' ') + "\xff\xff\xff\xff", "cut off");
}

TEST_F(CloudReader, HeadersThatContradictThemselves)
{
  const std::string fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n";
  expectProblem("a.pcd", fields + "COUNT 0 0 0\nWIDTH 1\nHEIGHT 1\nDATA binary\n1", "COUNT 0");
  expectProblem("b.pcd", fields + "COUNT 1 1 0\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2\n", "COUNT 0");
  expectProblem("c.pcd", fields + "WIDTH 3\nHEIGHT 2\nPOINTS 5\nDATA ascii\n1 2 3\n", "but POINTS 5");
  const std::string ascii = "ply\nformat ascii 1.0\nelement vertex 1\n";
  expectProblem("d.ply", ascii + "property float x\nproperty float y\nproperty list uchar float z\nend_header\n1 2 1 3\n",
                "a list for 'z'");
  const std::string lists = "property list uchar float k\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  expectProblem("e.ply", ascii + lists + "3 1 2 3\n", "line 9: 4 values");
  expectProblem("f.ply", ascii + lists + "nan 1 2 3\n", "a list of nan entries");
  expectProblem("g.ply", "ply\nformat ascii 1.0\nelement vertex 1.5\n", "'1.5' is not a count");
}

TEST_F(CloudReader, StlInEveryDress)
{
  std::string binary = "solid made by a program that writes binary files" + std::string(84 + 2 * 50, '\0');
  binary.resize(84 + 2 * 50);
  binary[80] = 2;
  for (std::size_t i = 0; i < 6; ++i) // the second triangle has the corners of the first
    std::memcpy(&binary[84 + 50 * (i / 3) + 12 + 12 * (i % 3)], points[i % 3].data(), 12);
  expectPoints(text("a.stl", binary));
  expectPoints(text("b.stl", "SOLID A\r\n FACET NORMAL 0 0 1\r\n  OUTER LOOP\r\n   VERTEX 1.5 -2.25 3\r\n"
                             "\tVERTEX 4 5.5 -6\r\n   VERTEX 0.125 1E-3 700.5\r\n  ENDLOOP\r\n ENDFACET\r\nENDSOLID\r\n"));
  expectProblem("c.stl", "solid a\nvertex 1 2\nendsolid\n", "line 2: a vertex needs x y z");
  expectProblem("d.stl", "solid a\nvertex 1 2 x\nendsolid\n", "line 2: 'x' is not a number");
  expectProblem("e.stl", "solid a\nendsolid a\n", "no triangles");
  expectProblem("f.stl", "solid a\nvertex 1 2 3\nendsolid a\nsolid b\nvertex 1 2 3\n", "'endsolid' is missing");
}

} // namespace cloud_reader_test
