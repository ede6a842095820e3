// SPDX-License-Identifier: BSD-3-Clause
// Toolpath files: read back by the library's readers, by PCL and VTK, and by a simple parser of the header.
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace toolpath_files_test {

using namespace pcl_spiral;

namespace {

/** A spiral on a paraboloid with a tilted axis; its lengths are too large for a float with micrometres. */
pcl::PointCloud<ToolpathPoint>
spiral(std::size_t count)
{
  pcl::PointCloud<ToolpathPoint> path;
  path.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = 0.01 * static_cast<double>(i), angle = 2.0 * M_PI * turn, r = 0.4 * turn;
    const Eigen::Vector3d p(r * std::cos(angle), r * std::sin(angle), -0.001 * r * r);
    const Eigen::Vector3d n = Eigen::Vector3d(0.002 * p.x(), 0.002 * p.y(), 1.0).normalized();
    path[i].getVector3fMap() = p.cast<float>();
    path[i].getNormalVector3fMap() = n.cast<float>();
    path[i].getAxisVector3fMap() = (n + Eigen::Vector3d(0.2, -0.1, 0.0)).normalized().cast<float>();
    path[i].arc_length = 1.0e6 + 1.0 / 3.0 * static_cast<double>(i);
    path[i].turn = static_cast<float>(turn);
  }
  return path;
}

void
expectNear(const pcl::PointCloud<ToolpathPoint>& a, const pcl::PointCloud<ToolpathPoint>& b, double length, double direction)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(a[i].data[c], b[i].data[c], length);
      ASSERT_NEAR(a[i].data_n[c], b[i].data_n[c], direction);
      ASSERT_NEAR(a[i].data_axis[c], b[i].data_axis[c], direction);
    }
    ASSERT_NEAR(a[i].arc_length, b[i].arc_length, length);
    ASSERT_NEAR(a[i].turn, b[i].turn, length);
  }
}

const ToolpathMotion motion{10.0, 1500.0};

} // namespace

TEST(ToolpathFiles, RoundTrip)
{
  const ScratchFolder folder;
  const auto path = spiral(30011); // more than one block of rows, and a part of one
  for (const std::string& extension : toolpathExtensions()) {
    const std::string file = folder.path("path" + extension);
    writeToolpath(file, path, motion);
    const ToolpathFile back = readToolpath(file);
    const bool text = extension == ".csv"; // half of the last decimal, and the rounding of float
    expectNear(back.path, path, text ? 0.5e-6 + 3e-5 * 0.5 : 0.0, text ? 0.6e-9 + 3e-8 : 0.0);
    if (extension == ".csv" || extension == ".vtp") {
      ASSERT_EQ(back.feed.size(), path.size());
      EXPECT_EQ(back.feed.front(), motion.feed);
      EXPECT_EQ(back.feed.back(), motion.feed);
    }
  }
}

TEST(ToolpathFiles, PassesComeBackFromEveryFormat)
{
  const ScratchFolder folder;
  auto path = spiral(3000);
  EXPECT_TRUE(passBegins(path).empty());
  const std::vector<std::size_t> begins{700, 701, 2999};
  for (const std::size_t begin : begins)
    for (std::size_t i = begin; i < path.size(); ++i)
      path[i].arc_length -= 1.0 / 3.0; // the move to the pass is not a cut
  EXPECT_EQ(passBegins(path), begins);
  for (const std::string& extension : toolpathExtensions()) {
    const std::string file = folder.path("path" + extension);
    writeToolpath(file, path, motion);
    EXPECT_EQ(passBegins(readToolpath(file).path), begins) << extension;
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("path.vtp").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLines(), 4);
  for (ToolpathPoint& p : path)
    p.arc_length = 0.0;
  EXPECT_TRUE(passBegins(path).empty()); // it does not contain lifts
}

TEST(ToolpathFiles, CsvHasTheAgreedShape)
{
  const ScratchFolder folder;
  pcl::PointCloud<ToolpathPoint> path;
  path.resize(2);
  path[0].x = 1.5f;
  path[0].y = -0.0000001f;
  path[0].z = -2.25f;
  path[0].normal_z = 1.0f;
  path[0].axis_x = 0.5f;
  path[0].axis_z = 0.75f;
  path[0].arc_length = 123456789.0625;
  path[0].turn = 3.5f;
  path[1].x = std::numeric_limits<float>::quiet_NaN();
  path[1].y = 3e38f;
  writeToolpathCSV(folder.path("a.csv"), path, {4.0, 1500.0});
  std::istringstream lines(readText(folder.path("a.csv")));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "turn,arc_length,cc_x,cc_y,cc_z,normal_x,normal_y,normal_z,tip_x,tip_y,tip_z,axis_x,axis_y,"
                  "axis_z,feed,over_gap,lift");
  std::getline(lines, line);
  EXPECT_EQ(line, "3.500000,123456789.062500,1.500000,0.000000,-2.250000,0.000000000,0.000000000,1.000000000,"
                  "-0.500000,0.000000,-1.250000,0.500000000,0.000000000,0.750000000,1500.000,0,0.000000");
  std::getline(lines, line);
  char huge[64];
  std::snprintf(huge, sizeof(huge), ",%.6f,", static_cast<double>(3e38f));
  EXPECT_EQ(line.find("0.000000,0.000000,nan"), 0U) << line;
  EXPECT_NE(line.find(huge), std::string::npos) << line;
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(ToolpathFiles, CsvNumbersAreThoseOfPrintf)
{
  const ScratchFolder folder;
  pcl::PointCloud<ToolpathPoint> path;
  path.resize(20000);
  unsigned int seed = 7;
  for (ToolpathPoint& point : path) {
    seed = seed * 1664525U + 1013904223U;
    const double magnitude = std::pow(10.0, static_cast<int>(seed % 13) - 6);
    point.arc_length = magnitude * (static_cast<double>(seed) / 2147483648.0 - 1.0);
  }
  writeToolpathCSV(folder.path("a.csv"), path, motion);
  std::istringstream lines(readText(folder.path("a.csv")));
  std::string line;
  std::getline(lines, line);
  std::size_t same = 0;
  for (const ToolpathPoint& point : path) {
    std::getline(lines, line);
    char expected[64];
    std::snprintf(expected, sizeof(expected), "%.6f", point.arc_length);
    const std::string written = line.substr(9, line.find(',', 9) - 9);
    ASSERT_NEAR(std::stod(written), point.arc_length, 0.5e-6 * (1.0 + 1e-6)) << written;
    same += written == expected || (std::string(expected) == "-0.000000" && written == "0.000000");
  }
  EXPECT_EQ(same, path.size());
}

TEST(ToolpathFiles, PclReadsThemBack)
{
  const ScratchFolder folder;
  const auto path = spiral(1000);
  pcl::PointCloud<ToolpathPoint> pcd, ply;
  writeToolpathPCD(folder.path("a.pcd"), path);
  ASSERT_EQ(pcl::io::loadPCDFile(folder.path("a.pcd"), pcd), 0);
  expectNear(pcd, path, 0.0, 0.0);
  writeToolpathPLY(folder.path("a.ply"), path);
  ASSERT_EQ(pcl::io::loadPLYFile(folder.path("a.ply"), ply), 0);
  expectNear(ply, path, 0.0, 0.0);
}

TEST(ToolpathFiles, PlyHeaderDescribesItsBytes)
{
  const ScratchFolder folder;
  const auto path = spiral(10);
  writeToolpathPLY(folder.path("a.ply"), path);
  const std::string bytes = readText(folder.path("a.ply"));
  const std::string mark = "end_header\n";
  const std::size_t body = bytes.find(mark) + mark.size();
  std::istringstream header(bytes.substr(0, body));
  std::string line;
  std::size_t row = 0, length_at = 0;
  while (std::getline(header, line)) {
    if (line == "property double arc_length")
      length_at = row;
    row += line.rfind("property float ", 0) == 0 ? 4 : line.rfind("property double ", 0) == 0 ? 8 : line.rfind("property uchar ", 0) == 0;
  }
  ASSERT_EQ(bytes.size(), body + 10 * row);
  double length = 0.0;
  std::memcpy(&length, bytes.data() + body + 7 * row + length_at, sizeof(length));
  EXPECT_EQ(length, path[7].arc_length);
}

TEST(ToolpathFiles, VtkReadsOnePolyline)
{
  const ScratchFolder folder;
  const auto path = spiral(500);
  writeToolpathVTP(folder.path("a.vtp"), path, motion);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("a.vtp").c_str());
  reader->Update();
  vtkPolyData* const data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 500);
  ASSERT_EQ(data->GetNumberOfCells(), 1);
  EXPECT_EQ(data->GetCell(0)->GetCellType(), VTK_POLY_LINE);
  for (vtkIdType i = 0; i < 500; ++i)
    ASSERT_EQ(data->GetCell(0)->GetPointId(static_cast<int>(i)), i);
  vtkPointData* const arrays = data->GetPointData();
  ASSERT_NE(arrays->GetNormals(), nullptr);
  EXPECT_STREQ(arrays->GetNormals()->GetName(), "Normals");
  for (const char* name : {"Normals", "ToolAxis", "Feed", "Turn", "ArcLength"})
    ASSERT_NE(arrays->GetArray(name), nullptr) << name;
  EXPECT_EQ(arrays->GetArray("ArcLength")->GetComponent(499, 0), path[499].arc_length);
  EXPECT_EQ(arrays->GetArray("ToolAxis")->GetComponent(499, 0), path[499].axis_x);
  EXPECT_EQ(arrays->GetArray("Feed")->GetComponent(0, 0), motion.feed);
  EXPECT_EQ(arrays->GetNumberOfArrays(), 5) << "a path that was not judged has no values";
}

TEST(ToolpathFiles, VtpTakesValuesOfEachPoint)
{
  const ScratchFolder folder;
  const auto path = spiral(300);
  PathValues values;
  for (int i = 0; i < 300; ++i) {
    values.feed.push_back(1000.0 + i);
    values.deviation.push_back(i == 7 ? std::numeric_limits<float>::quiet_NaN() : 0.001f * static_cast<float>(i - 150));
    values.scallop.push_back(0.01f * static_cast<float>(i));
  }
  writeToolpath(folder.path("a.vtp"), path, motion, values);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("a.vtp").c_str());
  reader->Update();
  vtkPointData* const arrays = reader->GetOutput()->GetPointData();
  for (const char* name : {"Feed", "Deviation", "Scallop"})
    ASSERT_NE(arrays->GetArray(name), nullptr) << name;
  EXPECT_EQ(arrays->GetArray("Feed")->GetComponent(299, 0), 1299.0);
  EXPECT_TRUE(std::isnan(arrays->GetArray("Deviation")->GetComponent(7, 0)));
  EXPECT_EQ(arrays->GetArray("Deviation")->GetComponent(0, 0), values.deviation[0]);
  EXPECT_EQ(arrays->GetArray("Scallop")->GetComponent(299, 0), values.scallop[299]);
  EXPECT_EQ(readToolpath(folder.path("a.vtp")).feed.at(299), 1299.0);
  values.scallop.pop_back();
  EXPECT_THROW(writeToolpath(folder.path("b.vtp"), path, motion, values), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder.path("b.vtp")));
}

TEST(ToolpathFiles, GapsOfTheScanAndLiftsAreMarkedInEveryFormat)
{
  const ScratchFolder folder;
  auto path = spiral(5000);
  for (std::size_t i = 2040; i < 2060; ++i) // over the end of a block of rows
    path[i].over_gap = 1;
  for (std::size_t i = 2050; i < 2100; ++i)
    path[i].lift = 0.5f + 0.25f * static_cast<float>(i % 8); // exact in every format
  for (const std::string& extension : toolpathExtensions()) {
    writeToolpath(folder.path("a" + extension), path, motion);
    const auto back = readToolpath(folder.path("a" + extension)).path;
    ASSERT_EQ(back.size(), path.size()) << extension;
    for (std::size_t i = 0; i < path.size(); ++i) {
      ASSERT_EQ(back[i].over_gap, path[i].over_gap) << extension << " " << i;
      ASSERT_EQ(back[i].lift, path[i].lift) << extension << " " << i;
    }
  }
  pcl::PointCloud<ToolpathPoint> pcd, ply;
  ASSERT_EQ(pcl::io::loadPCDFile(folder.path("a.pcd"), pcd), 0);
  ASSERT_EQ(pcl::io::loadPLYFile(folder.path("a.ply"), ply), 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("a.vtp").c_str());
  reader->Update();
  vtkDataArray* const over_gap = reader->GetOutput()->GetPointData()->GetArray("OverGap");
  ASSERT_NE(over_gap, nullptr);
  vtkDataArray* const lift = reader->GetOutput()->GetPointData()->GetArray("Lift");
  ASSERT_NE(lift, nullptr);
  EXPECT_EQ(lift->GetComponent(2055, 0), path[2055].lift);
  for (std::size_t i = 0; i < path.size(); ++i) {
    ASSERT_EQ(pcd[i].over_gap, path[i].over_gap) << i;
    ASSERT_EQ(ply[i].over_gap, path[i].over_gap) << i;
    ASSERT_EQ(pcd[i].lift, path[i].lift) << i;
    ASSERT_EQ(over_gap->GetComponent(static_cast<vtkIdType>(i), 0), path[i].over_gap) << i;
  }
}

TEST(ToolpathFiles, EveryLineOfACsvBelowItsFirstIsNumbers)
{
  const ScratchFolder folder;
  auto path = spiral(5000);
  for (std::size_t i = 2040; i < 2060; ++i)
    path[i].over_gap = 1;
  for (std::size_t i = 3000; i < path.size(); ++i)
    path[i].arc_length -= 1.0 / 3.0; // a second pass
  writeToolpathCSV(folder.path("a.csv"), path, motion);
  std::istringstream lines(readText(folder.path("a.csv")));
  std::string line;
  std::getline(lines, line);
  const auto columns = std::count(line.begin(), line.end(), ',');
  std::vector<std::size_t> gaps;
  std::size_t row = 0;
  for (; std::getline(lines, line); ++row) {
    ASSERT_EQ(line.find_first_not_of("0123456789.,-"), std::string::npos) << line;
    ASSERT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
    if (line.substr(line.rfind(',', line.rfind(',') - 1)) == ",1,0.000000")
      gaps.push_back(row);
  }
  EXPECT_EQ(row, path.size());
  ASSERT_EQ(gaps.size(), 20U);
  EXPECT_EQ(gaps.front(), 2040U);
  EXPECT_EQ(gaps.back(), 2059U);
}

TEST(ToolpathFiles, CsvFilesOfEarlierVersionsAreRead)
{
  const ScratchFolder folder;
  writeText(folder.path("a.csv"), "turn,arc_length,cc_x,cc_y,cc_z,normal_x,normal_y,normal_z,tip_x,tip_y,tip_z,axis_x,axis_y,axis_z,feed\n"
                                  "0,0,1,2,3,0,0,1,1,2,3,0,0,1,900\n"
                                  "# over a gap of the scan, bridged\n"
                                  "0.5,2,3,2,3,0,0,1,3,2,3,0,0,1,900\n"
                                  "# on the scan\n"
                                  "1,4,5,2,3,0,0,1,5,2,3,0,0,1,900\n");
  const ToolpathFile file = readToolpath(folder.path("a.csv"));
  ASSERT_EQ(file.path.size(), 3U);
  EXPECT_EQ(file.path[2].x, 5.0f);
  EXPECT_EQ(file.path[1].over_gap, 0) << "a mark of comment lines is not read";
  EXPECT_EQ(file.feed, (std::vector<double>{900, 900, 900}));
  ASSERT_EQ(file.tips.size(), 3U);
  EXPECT_EQ(file.tips[2].x(), 5.0);
}

TEST(ToolpathFiles, RowsInAnotherOrderAreRefusedAndSortingHelps)
{
  const ScratchFolder folder;
  const std::string file = folder.path("path.csv");
  writeToolpathCSV(file, spiral(500), motion);
  std::istringstream in(readText(file));
  std::string head, row;
  std::getline(in, head);
  std::vector<std::string> rows;
  while (std::getline(in, row))
    rows.push_back(row);
  std::vector<std::string> shuffled;
  for (std::size_t i = 0; i < rows.size(); ++i)
    shuffled.push_back(rows[(i * 211) % 499]);
  const auto write = [&](const std::vector<std::string>& lines) {
    std::string text = head + "\n";
    for (const std::string& line : lines)
      text += line + "\n";
    writeText(file, text);
  };
  write(std::vector<std::string>(rows.rbegin(), rows.rend()));
  try {
    readToolpath(file);
    FAIL() << "rows from the end to the start";
  }
  catch (const FileError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("the arc length falls at 499 of 500 points, first at point 2; sort the rows by arc_length"), std::string::npos)
        << message;
  }
  write(shuffled);
  EXPECT_THROW(readToolpath(file), FileError);
  write(rows);
  EXPECT_EQ(readToolpath(file).path.size(), 500u);
}

TEST(ToolpathFiles, EveryPolylineIsAPassWhateverTheArcLengthsSay)
{
  const ScratchFolder folder;
  auto path = spiral(30);
  for (std::size_t i = 0; i < path.size(); ++i)
    path[i].x = 0.3f * static_cast<float>(i); // shorter moves are not lifts
  ToolpathMotion passes = motion;
  passes.passes = {10, 20, 29}; // the arc length increases everywhere, as from another program
  writeToolpath(folder.path("a.vtp"), path, passes);
  const auto read = readToolpath(folder.path("a.vtp")).path;
  EXPECT_EQ(passBegins(read), passes.passes);
  EXPECT_NEAR(read[9].arc_length, path[9].arc_length, 1e-12);
  EXPECT_NEAR(read[28].arc_length - read[20].arc_length, path[28].arc_length - path[20].arc_length, 1e-9);
  // Points that the polylines leave out, or have in another order, are reported.
  const std::string whole = readText(folder.path("a.vtp"));
  std::string entries;
  for (const std::int64_t i : {10, 11, 12})
    entries.append(reinterpret_cast<const char*>(&i), sizeof i);
  const std::size_t at = whole.rfind(entries);
  ASSERT_NE(at, std::string::npos);
  std::string changed = whole;
  changed[at] = 11;
  writeText(folder.path("b.vtp"), changed);
  EXPECT_THROW(readToolpath(folder.path("b.vtp")), FileError);
}

TEST(ToolpathFiles, TipLiesBelowTheBallCentre)
{
  for (const ToolpathPoint& point : spiral(100)) {
    const Eigen::Vector3d centre = point.getVector3fMap().cast<double>() + 10.0 * point.getNormalVector3fMap().cast<double>();
    EXPECT_NEAR((centre - toolTip(point, 10.0)).norm(), 10.0, 1e-5);
    EXPECT_NEAR((centre - toolTip(point, 10.0)).dot(point.getAxisVector3fMap().cast<double>()), 10.0, 1e-5);
  }
}

TEST(ToolpathFiles, AFullDiskIsAnError)
{
  if (!std::filesystem::exists("/dev/full"))
    return;
  const auto path = spiral(50000);
  EXPECT_THROW(writeToolpathCSV("/dev/full", path, motion), FileError);
  EXPECT_THROW(writeToolpathPLY("/dev/full", path), FileError);
  EXPECT_THROW(writeToolpathPCD("/dev/full", path), FileError);
  EXPECT_THROW(writeToolpathVTP("/dev/full", path, motion), FileError);
}

TEST(ToolpathFiles, APathWithoutPointsIsRefused)
{
  const ScratchFolder folder;
  for (const std::string& extension : toolpathExtensions())
    EXPECT_THROW(writeToolpath(folder.path("a" + extension), {}, motion), FileError);
  EXPECT_EQ(folder.count(), 0U);
}

TEST(ToolpathFiles, ReaderSaysWhatIsMissing)
{
  const ScratchFolder folder;
  writeText(folder.path("a.csv"), "turn,cc_x\n1,2\n");
  writeText(folder.path("a.vtp"), "<VTKFile type=\"PolyData\">");
  EXPECT_THROW(readToolpath(folder.path("a.csv")), FileError);
  EXPECT_THROW(readToolpath(folder.path("a.vtp")), FileError);
  writeToolpathVTP(folder.path("whole.vtp"), spiral(100), motion);
  const std::string whole = readText(folder.path("whole.vtp"));
  writeText(folder.path("half.vtp"), whole.substr(0, whole.size() / 2));
  EXPECT_THROW(readToolpath(folder.path("half.vtp")), FileError);
  const auto changed = [&](const std::string& what, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(what), what.size(), to);
    writeText(folder.path("changed.vtp"), text);
    try {
      readToolpath(folder.path("changed.vtp"));
    }
    catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(changed("Turn", "Turn"), "") << "the file as it is can be read";
  EXPECT_NE(changed("NumberOfPoints=\"100\"", "NumberOfPoints=\"999999999999999\"").find("1200 bytes of Points"),
            std::string::npos); // and no memory is allocated for them
  EXPECT_NE(changed("NumberOfLines=\"1\"", "NumberOfLines=\"0\"").find("no polyline"), std::string::npos);
  EXPECT_NE(changed("offset=\"0\"", "offset=\"99999999\"").find("cut off"), std::string::npos);
  EXPECT_NE(changed("\"raw\"", "\"base64\"").find("encoded"), std::string::npos);
  EXPECT_NE(changed("\"Turn\"", "\"Torn\"").find("no point data Turn"), std::string::npos);
  EXPECT_THROW(readToolpath(folder.path("missing.csv")), FileError);
  EXPECT_THROW(writeToolpath(folder.path("a.dwg"), spiral(3), motion), FileError);
}

} // namespace toolpath_files_test
