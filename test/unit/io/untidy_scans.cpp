// SPDX-License-Identifier: BSD-3-Clause
// Scans and meshes as people have them: words that are wrapped anywhere, titles and counts, quotes, marks of encodings, empty fields,
// continued lines, and pipes. The same points come from each; what cannot be read is refused with what to do.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/io/polygon_reader.h>

#include "common/shell_word.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <pcl/conversions.h>

#include <sys/stat.h>

#include <cstring>
#include <fstream>
#include <thread>

namespace untidy_scans_test {

using namespace pcl_spiral;

namespace {

const std::vector<Eigen::Vector3f> points{{1.5f, -2.25f, 3.0f}, {4.0f, 5.5f, -6.0f}, {0.125f, 1e-3f, 700.5f}};
const std::string rows = "1.5 -2.25 3\n4 5.5 -6\n0.125 1e-3 700.5\n";
const std::string ascii = "ply\nformat ascii 1.0\n";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string mark = "\xEF\xBB\xBF";

class UntidyScans : public ::testing::Test {
protected:
  std::string text(const std::string& name, const std::string& content)
  {
    writeText(folder_.path(name), content);
    return folder_.path(name);
  }

  Scan expectPoints(const std::string& name, const std::string& content, const ReadOptions& options = {})
  {
    SCOPED_TRACE(name);
    return expectPointsOf(text(name, content), options);
  }

  Scan expectPointsOf(const std::string& file, const ReadOptions& options = {})
  {
    Scan scan;
    EXPECT_NO_THROW(scan = readCloud(file, options)) << file;
    if (!scan.cloud || scan.cloud->size() != points.size()) {
      ADD_FAILURE() << file << " has not the three points";
      return scan;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_LE(((*scan.cloud)[i].getVector3fMap() - points[i]).norm(), 1e-7f * points[i].norm()) << file << " point " << i;
    return scan;
  }

  /** The triangle of the three points. */
  void expectTriangle(const std::string& name, const std::string& content)
  {
    SCOPED_TRACE(name);
    MeshFile read;
    ASSERT_NO_THROW(read = readMesh(text(name, content)));
    ASSERT_EQ(read.mesh->polygons.size(), 1U);
    pcl::PointCloud<pcl::PointXYZ> vertices;
    pcl::fromPCLPointCloud2(read.mesh->cloud, vertices);
    ASSERT_EQ(vertices.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(vertices[read.mesh->polygons[0].vertices[i]].getVector3fMap(), points[i]);
  }

  void expectProblem(const std::string& name, const std::string& content, const std::string& words, const ReadOptions& options = {})
  {
    text(name, content);
    expectProblemOf([&] { readCloud(folder_.path(name), options); }, words);
  }

  template <typename Read>
  void expectProblemOf(const Read& read, const std::string& words)
  {
    try {
      read();
      ADD_FAILURE() << "was read, without: " << words;
    }
    catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << "'" << words << "' in: " << error.what();
    }
  }

  ScratchFolder folder_;
};

/** UTF-16, little endian. */
std::string
wide(const std::string& text)
{
  std::string result;
  for (const char c : text)
    result += std::string(1, c) + '\0';
  return result;
}

} // namespace

TEST_F(UntidyScans, AsciiPlyIsAStreamOfWords)
{
  const std::string three = ascii + "element vertex 3\n" + xyz, coloured = three + "property uchar red\nproperty uchar green\n";
  expectPoints("a.ply", coloured + "end_header\n1.5 -2.25 3\n10 20\n4 5.5 -6\n10 20\n0.125 0.001 700.5\n10 20\n");
  expectPoints("b.ply", three + "end_header\n1.5 -2.25 3 4 5.5 -6 0.125 0.001 700.5\n");        // all in one line
  expectPoints("c.ply", three + "end_header\n1.5\n-2.25\n3\n4\n5.5\n-6\n0.125\n\n.001\n700.5"); // one word per line
  expectPoints("d.ply", coloured + "end_header\r\n1.5 -2.25\t3 1\r\n2 4 5.5 -6 1 2\r\n\r\n 0.125 0.001 700.5 1 2 \r\n");
  expectPoints("e.ply", three + "property list uchar int k\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                                "1.5 -2.25 3 2\n7 8 4 5.5 -6 0 0.125 0.001\n700.5 1\n9 3 0 1\n2\n");
  expectPoints("f.ply", ascii + "element camera 2\nproperty float f\nproperty list uchar float k\nelement vertex 3\n" + xyz +
                            "end_header\n50 2 1\n1 60\n0\n1.5 -2.25\n3 4 5.5 -6 0.125 0.001 700.5\n");
  expectPoints("g.ply", three + "end_header\r1.5 -2.25\r3 4 5.5\r-6 0.125\r0.001 700.5\r");
}

TEST_F(UntidyScans, FacesOfAsciiPlyAreWordsToo)
{
  const std::string header =
      ascii + "element vertex 3\n" + xyz + "element face 1\nproperty uchar red\nproperty list uchar int vertex_indices\nend_header\n";
  expectTriangle("a.ply", header + rows + "7 3 0 1 2\n");
  expectTriangle("b.ply", header + rows + "7\n3\n0 1\n2\n");
  expectTriangle("c.ply", header + "1.5 -2.25 3 4 5.5 -6\n0.125 1e-3 700.5 7 3 0\n1 2");
  expectTriangle("d.ply", header + rows + "7 3 0 1 2 0.5 0.5\n"); // as before: a line with more than its header names
}

TEST_F(UntidyScans, AsciiPlyThatIsNeitherWordsNorLinesIsRefused)
{
  const std::string three = ascii + "element vertex 3\n" + xyz + "property uchar red\nend_header\n";
  expectPoints("a.ply", three + "1.5 -2.25 3 1 9\n4 5.5 -6 1 9\n0.125 0.001 700.5 1 9\n"); // as before
  expectProblem("b.ply", three + "1.5 -2.25 3\n1\n4 5.5 -6\n1\n0.125 0.001 700.5\n", "in vertex 3 of 3");
  expectProblem("c.ply", three + "1.5 -2.25 3\n1\n4 5.5 -6\n1\n0.125 x 700.5\n1\n", "line 13: 'x' is not a number");
  expectProblem("d.ply", three + "1.5 -2.25 3\n1\n4 5.5 -6\n1\n0.125 0.001 700.5 1\n5\n", "line 14: '5' comes after the last value");
  expectProblem("e.ply", three + "1.5 -2.25 3 1\n4 5.5 1\n0.125 0.001 700.5 1\n", "line 10: 3 values, but the header names 4");
}

TEST_F(UntidyScans, PcdFieldsOfCountZeroHaveNoValues)
{
  const std::string header = "FIELDS x _ y z rgb\nSIZE 4 1 4 4 4\nTYPE F U F F F\nCOUNT 1 0 1 1 0\nWIDTH 3\nHEIGHT 1\nDATA ";
  expectPoints("a.pcd", header + "ascii\n" + rows);
  std::string binary;
  for (const Eigen::Vector3f& p : points)
    binary.append(reinterpret_cast<const char*>(p.data()), 12);
  expectPoints("b.pcd", header + "binary\n" + binary);
  const std::string normals = "FIELDS normal_x normal_y normal_z x y z\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\nCOUNT ";
  EXPECT_FALSE(expectPoints("c.pcd", normals + "0 0 0 1 1 1\nWIDTH 3\nHEIGHT 1\nDATA ascii\n" + rows).normals);
  expectPoints("d.pcd", "FIELDS label x y z\nSIZE 2 4 4 4\nTYPE U F F F\nCOUNT 0 1 1 1\nWIDTH 3\nHEIGHT 1\nDATA binary\n" + binary);
  expectPoints("e.pcd", "FIELDS k x y z _\nSIZE 4 4 4 4 1\nTYPE F F F F U\nCOUNT 2 1 1 1 0\nWIDTH 3\nHEIGHT 1\nDATA ascii\n"
                        "1 1 1.5 -2.25 3\n1 1 4 5.5 -6\n1 1 0.125 0.001 700.5\n");
  expectProblem("f.pcd", normals + "1 1 1 1 0 1\nWIDTH 1\nHEIGHT 1\nDATA ascii\n0 0 1 1 2\n",
                "no values of 'y': the header gives it COUNT 0");
}

TEST_F(UntidyScans, CountsAboveThePointsAreTheirNumber)
{
  expectPoints("a.xyz", "3\n" + rows);
  expectPoints("b.asc", "//X Y Z R G B\n3\n1.5 -2.25 3 1 2 3\n4 5.5 -6 1 2 3\n0.125 0.001 700.5 1 2 3\n");
  expectPoints("c.csv", "3\nx,y,z\n1.5,-2.25,3\n4,5.5,-6\n0.125,0.001,700.5\n");
  expectPoints("d.csv", "x;y;z\r\n3\r\n1.5;-2.25;3\r\n4;5.5;-6\r\n0.125;0.001;700.5\r\n");
  expectPoints("e.txt", "1 3\n" + rows); // rows and columns of a range map
  EXPECT_TRUE(expectPoints("f.xyz", "# made by a scanner\n\n 3 \n" + rows).warnings.empty());
  expectProblem("g.xyz", "4\n" + rows, "line 1: this should be the number of points, 4, but 3 follow");
  expectProblem("h.xyz", "2\n" + rows, "ReadOptions::skip_lines 1");
  expectProblem("i.xyz", "1.5 2\n" + rows, "line 1: 2 column(s)");
}

TEST_F(UntidyScans, TitlesArePassedOverAndReported)
{
  const auto expectTold = [this](const std::string& name, const std::string& content, const std::string& words) {
    const Scan scan = expectPoints(name, content);
    ASSERT_EQ(scan.warnings.size(), 1U) << name;
    EXPECT_NE(scan.warnings[0].text().find(words), std::string::npos) << scan.warnings[0];
  };
  expectTold("a.xyz", "Scan of part 7, 2024-03-01\n" + rows, "line 1: 'Scan of part 7, 2024-03-01' is no point and was passed over");
  expectTold("b.csv", "Export of ScanStudio\nx,y,z\n1.5,-2.25,3\n4,5.5,-6\n0.125,0.001,700.5\n", "line 1: 'Export of ScanStudio'");
  expectTold("c.csv", "x,y,z\nmm,mm,mm\n1.5,-2.25,3\n4,5.5,-6\n0.125,0.001,700.5\n", "line 2: 'mm,mm,mm'");
  expectTold("d.asc", "Part A\nOperator: N.N.\n3 points\n" + rows, "line 1: 'Part A' and 2 more lines are no points");
  expectTold("e.txt", "-----\n3\n" + rows, "line 1: '-----'");
  expectTold("f.xyz", "Housing scan 7\n" + rows, "line 1: 'Housing scan 7'"); // as many words as columns
  expectTold("g.pts", "Export of a station\n3\n" + rows, "line 1: 'Export of a station'");
}

TEST_F(UntidyScans, WhatMayBeAPointOrAHeadingIsNoTitle)
{
  expectProblem("a.csv", "a,b,c\n1,2,3\n", "line 1: 'a' is neither a number nor a heading");
  expectProblem("b.xyz", "1.5 2.5 x3\n" + rows, "line 1: 'x3' is not a number");
  expectProblem("c.csv", "x,y,z\nabc,2,3\n1,2,3\n", "line 2: 'abc' is not a number");
  expectProblem("d.txt", "1,5 2,5 3,5\n" + rows, "write decimals with a point, not a comma");
  expectProblem("e.xyz", "Scan of housing\n" + rows, "if it is no point, skip it (ReadOptions::skip_lines 1)");
}

TEST_F(UntidyScans, LinesAreSkippedAsAsked)
{
  ReadOptions options;
  options.skip_lines = 2;
  EXPECT_TRUE(expectPoints("a.xyz", "Scan of housing\n1 2 3\n" + rows, options).warnings.empty());
  expectPoints("b.csv", "a,b,c\n\nx,z,y\n1.5,3,-2.25\n4,-6,5.5\n0.125,700.5,0.001\n", options);
  expectPoints("c.pts", "1 2 3\nb\n3\n" + rows, options);
  options.columns = {"z", "x", "y"};
  expectPoints("d.asc", "1\n2\n3 1.5 -2.25\n-6 4 5.5\n700.5 0.125 0.001\n", options);
  options.columns.clear();
  expectProblem("e.xyz", "1 2 3\nb\n1 2 x\n", "line 3: 'x'", options);
  expectProblem("f.xyz", "1 2 3\n4 5 6\n", "holds no points (2 lines, the first 2 skipped)", options);
  expectProblem("g.ply", ascii, "only lines of text files can be skipped", options);
  expectProblemOf([&] { readMesh(text("h.stl", "solid"), options); }, "only lines of text files can be skipped");
}

TEST_F(UntidyScans, QuotedNumbers)
{
  expectPoints("a.csv", "\"x\",\"y\",\"z\"\n\"1.5\",\"-2.25\",\"3\"\n\"4\",\"5.5\",\"-6\"\n\"0.125\",\"0.001\",\"700.5\"\n");
  expectPoints("b.csv", "\"1.5\";\"-2.25\";\"3\"\n\"4\";\"5.5\";\"-6\"\n\"0.125\";\"0.001\";\"700.5\"\n");
  expectPoints("c.txt", "'1.5' '-2.25' '3'\n'4' '5.5' '-6'\n'0.125' '1e-3' '700.5'\n");
  expectPoints("d.csv", "x, y, z\n1.5, \" -2.25 \", 3\n4, \"+5.5\", -6\n0.125, .001, \"700.5\"\n");
  expectPoints("e.csv", "\"3\"\n\"id\",\"x\",\"y\",\"z\"\n\"P1\",\"1.5\",\"-2.25\",\"3\"\n\"P2\",\"4\",\"5.5\",\"-6\"\n"
                        "\"P3\",\"0.125\",\"0.001\",\"700.5\"\n");
  expectPoints("f.pts", "\"3\"\n\"1.5\" \"-2.25\" \"3\"\n4,5.5,-6\n0.125;0.001;700.5\n");
  expectProblem("g.csv", "x,y,z\n\"1,5\",\"2,5\",\"3,5\"\n", "columns, but the lines before have 3");
  expectProblem("h.csv", "\"1.5\",\"b\",\"3\"\n1,2,3\n", "line 1: 'b' is not a number");
}

TEST_F(UntidyScans, MarkOfUtf8IsPassedOver)
{
  expectPoints("a.xyz", mark + rows);
  expectPoints("b.csv", mark + "x,y,z\n1.5,-2.25,3\n4,5.5,-6\n0.125,0.001,700.5\n");
  expectPoints("c.asc", mark + "3\n" + rows);
  expectPoints("d.pts", mark + "3\n" + rows);
  expectPoints("e.ply", mark + ascii + "element vertex 3\n" + xyz + "end_header\n" + rows);
  expectPoints("f.pcd", mark + "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 3\nHEIGHT 1\nDATA ascii\n" + rows);
  expectTriangle("g.obj", mark + "v 1.5 -2.25 3\nv 4 5.5 -6\nv 0.125 0.001 700.5\nf 1 2 3\n");
  expectTriangle("h.ply", mark + ascii + "element vertex 3\n" + xyz + "element face 1\nproperty list uchar int vertex_index\nend_header\n" +
                              rows + "3 0 1 2\n");
  expectPoints("i.obj", mark + "v 1.5 -2.25 3\nv 4 5.5 -6\nv 0.125 0.001 700.5\n");
  EXPECT_DOUBLE_EQ(readPolygon(text("j.txt", mark + "0 0\n30 0\n30 40\n")).width(), 50.0);
}

TEST_F(UntidyScans, StlBelowBlankLinesAndMarks)
{
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 1.5 -2.25 3\nvertex 4 5.5 -6\nvertex 0.125 0.001 700.5\nendloop\n"
                            "endfacet\nendsolid\n";
  expectTriangle("a.stl", mark + "solid part\n" + facet);
  expectTriangle("b.stl", "\n\nsolid part\n" + facet);
  expectTriangle("c.stl", "\r\n \t\r\n  SOLID part\r\n" + facet);
  expectTriangle("d.stl", mark + "\n\nsolid\n" + facet);
  expectTriangle("e.stl", std::string(300, '\n') + "solid part\n" + facet);
  expectTriangle("f.stl", std::string(300, ' ') + "\rsolid part\n" + facet);
  expectPoints("g.stl", mark + "\nsolid part\n" + facet);
}

TEST_F(UntidyScans, ContinuedLinesOfObj)
{
  expectTriangle("a.obj", "v 1.5 -2.25 \\\n3\nv 4 5.5 -6\nv 0.125 0.001 700.5\nf 1 2 3\n");
  expectTriangle("b.obj", "v \\\n1.5 \\\n-2.25 \\\n3\nv 4 5.5\\\n -6\nv 0.125 0.001 700.5\nf 1 2 3\n");
  expectTriangle("c.obj", "v 1.5 -2.25 3 \\\r\n 1 0 0\r\nv 4 5.5 \\\r\n-6\r\nv 0.125 0.001 700.5\r\nf 1 2 \\\r\n3\r\n"); // with a colour
  expectTriangle("d.obj", "v\\\n1.5 -2.25 3\nv 4 5.5 -6 # a comment \\\nv 0.125 0.001 700.5 \\ \n\nf\\\n1 2 3\n");
  expectTriangle("e.obj",
                 "vn 0 \\\n0 1\n# \\\nv 1.5 -2.25 3\nvt 0 \\\n 0\nv 4 5.5 -6\nv 0.125 0.001 \\\n700.5\nf 1/1/1 \\\n2/1/1 \\\n3/1/1\n");
  expectPoints("f.obj", "v 1.5 \\\n -2.25 3\nv 4 5.5 -6\nv 0.125 0.001 700.5\n");
  expectProblem("g.obj", "v 1 2 3\nv 1 \\\n2\n", "line 2: a vertex needs x y z");
}

TEST_F(UntidyScans, Utf16IsRefusedWithTheCommandThatConverts)
{
  const std::string converts = "is text in UTF-16, and text in UTF-8 is needed; convert it: iconv -f UTF-16 -t UTF-8 ";
  for (const std::string& name : {"a.xyz", "a.csv", "a.asc", "a.txt", "a.pts", "a.ply", "a.pcd", "a.obj", "a.stl"})
    expectProblem(name, "\xFF\xFE" + wide("solid 1 2 3\n"), converts + folder_.path(name) + " > ");
  expectProblem("big end.xyz", "\xFE\xFF" + std::string("\0001\0 \0002\0 \0003\0\n", 12),
                converts + "'" + folder_.path("big end.xyz") + "' > '" + folder_.path("big end_utf8.xyz") + "'");
  expectProblem("b.csv", wide("x,y,z\n1,2,3\n"), "is text in UTF-16LE");
  expectProblem("c.ply", '\0' + wide(ascii), "is text in UTF-16BE");
  expectProblemOf([this] { readPolygon(text("d.txt", "\xFF\xFE" + wide("0 0\n"))); }, "is text in UTF-16");
  expectProblemOf([this] { readMesh(text("e.obj", "\xFF\xFE" + wide("v 0 0 0\n"))); }, "is text in UTF-16");
}

TEST_F(UntidyScans, PipesOfEveryFormat)
{
  const auto throughPipe = [this](const std::string& name, const std::string& content, const auto& read) {
    SCOPED_TRACE(name);
    const std::string pipe = folder_.path(name);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << content; });
    read(pipe);
    writer.join();
  };
  const auto points_read = [this](const std::string& pipe) { expectPointsOf(pipe); };
  const std::string ply = ascii + "element vertex 3\n" + xyz + "end_header\n" + rows;
  const std::string pcd = "# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 3\nHEIGHT 1\nDATA ascii\n" + rows;
  const std::string obj = "# made\nv 1.5 -2.25 3\nv 4 5.5 -6\nv 0.125 0.001 700.5\n";
  const std::string stl = "solid\nvertex 1.5 -2.25 3\nvertex 4 5.5 -6\nvertex 0.125 0.001 700.5\nendsolid\n";
  throughPipe("a.ply", ply, points_read);
  throughPipe("b.xyz", rows, points_read);
  int number = 0; // without an extension the content tells the format
  for (const std::string& content : {ply, pcd, obj, stl, rows, "3\n" + rows, mark + rows, std::string(70000, '#') + "\n" + rows})
    throughPipe("pipe" + std::to_string(++number), content, points_read);
  throughPipe("c", std::string("\x01\0\x02", 3), [this](const std::string& pipe) {
    expectProblemOf([&] { readCloud(pipe); }, "has no name with an extension, and its content is none of .pcd");
  });
  throughPipe("d.ply", "", [this](const std::string& pipe) { expectProblemOf([&] { readCloud(pipe); }, "is a pipe that gave nothing"); });
  throughPipe("e", obj + "f 1 2 3\n", [](const std::string& pipe) { EXPECT_EQ(readMesh(pipe).mesh->polygons.size(), 1U); });
  ASSERT_EQ(::mkfifo(folder_.path("f.txt").c_str(), 0600), 0);
  expectProblemOf([this] { readPolygon(folder_.path("f.txt")); },
                  "is a pipe, and this file is read more than once; write it into a file first: cat " + folder_.path("f.txt") + " > FILE");
}

TEST_F(UntidyScans, NamesInCommandsAreWordsOfAShell)
{
  EXPECT_EQ(shellFile("part_1.las"), "part_1.las");
  EXPECT_EQ(shellFile("my scan.laz"), "'my scan.laz'");
  EXPECT_EQ(shellFile("it's.laz"), "'it'\\''s.laz'");
  EXPECT_EQ(shellFile("$(rm x).laz"), "'$(rm x).laz'");
  EXPECT_EQ(shellFile("-part.laz"), "./-part.laz");
  EXPECT_EQ(shellFile("Werkst\xC3\xBC"
                      "ck.laz"),
            "'Werkst\xC3\xBC"
            "ck.laz'");
  EXPECT_EQ(shellWord(""), "''");
  for (const std::string& extension : {".laz", ".e57"})
    expectProblem("my scan" + extension, "LASF",
                  "pdal translate '" + folder_.path("my scan" + extension) + "' '" + folder_.path("my scan.ply") + "' --writers");
}

} // namespace untidy_scans_test
