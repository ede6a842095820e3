// SPDX-License-Identifier: BSD-3-Clause
// The map of the largest ball, against its closed form over a groove, in every format.
#include "run_program.h"
#include "support/tight_parts.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace reach_map_test {

namespace {

constexpr double slope = 0.7, fillet = 3.0, half_width = 20.0, tool = 4.0, largest = 4.0 * tool; // mm

using Row = std::array<double, 4>; // x, y, z, radius

/** The fields of a cloud as PCL reads them, whatever their types. */
std::vector<Row>
rowsOf(const pcl::PCLPointCloud2& cloud)
{
  std::vector<Row> rows(static_cast<std::size_t>(cloud.width) * cloud.height);
  const std::array<const char*, 4> names{"x", "y", "z", "radius"};
  for (const pcl::PCLPointField& field : cloud.fields)
    for (std::size_t k = 0; k < names.size(); ++k)
      if (field.name == names[k])
        for (std::size_t i = 0; i < rows.size(); ++i) {
          const std::uint8_t* const at = cloud.data.data() + i * cloud.point_step + field.offset;
          float single = 0.0f;
          if (field.datatype == pcl::PCLPointField::FLOAT64)
            std::memcpy(&rows[i][k], at, sizeof(double));
          else {
            std::memcpy(&single, at, sizeof(float));
            rows[i][k] = single;
          }
        }
  return rows;
}

std::vector<Row>
rowsOfText(const std::string& text)
{
  std::vector<Row> rows;
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "x,y,z,radius");
  while (std::getline(in, line)) {
    rows.emplace_back();
    EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &rows.back()[0], &rows.back()[1], &rows.back()[2], &rows.back()[3]), 4);
  }
  return rows;
}

/** Radius of the largest ball at \p x across the groove: that of the fillet in it; on a side the ball touches the other side, too. */
double
closedForm(double x)
{
  const double beside = std::abs(x) - fillet * std::sin(slope);
  return beside <= 0.0 ? fillet : std::min(largest, fillet + beside / std::cos(slope) / std::tan(slope));
}

} // namespace

TEST(ReachMap, IsThatOfTheGrooveInEveryFormat)
{
  const ScratchFolder folder;
  const auto cloud = pcl_spiral::test::valley(slope, fillet, 20.0, half_width).scan(0.4, 0.0, 5);
  pcl::io::savePCDFileBinary(folder.path("scan.pcd"), *cloud);
  const auto map = [&](const std::string& file) {
    const RunResult result =
        endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM,
                           {"scan.pcd", "-o", "a.csv", "--tool-radius", "4", "--scallop", "0.05", "--reach", file}, folder),
              folder);
    EXPECT_EQ(result.code, 0) << result.err;
    pcl::PCLPointCloud2 read;
    if (file == "map.csv")
      return rowsOfText(readText(folder.path(file)));
    EXPECT_EQ(file == "map.pcd" ? pcl::io::loadPCDFile(folder.path(file), read) : pcl::io::loadPLYFile(folder.path(file), read), 0);
    return rowsOf(read);
  };
  const std::vector<Row> rows = map("map.csv");
  ASSERT_EQ(rows.size(), cloud->size());
  int inside = 0, beside = 0, whole = 0;
  for (const Row& row : rows) {
    const double at = std::abs(row[0]), edge = fillet * std::sin(slope), exact = closedForm(row[0]);
    if (std::abs(row[1]) > half_width - 2.0 || std::abs(at - edge) < 0.8)
      continue; // the fit rounds the step of the curvature
    EXPECT_NEAR(row[3], exact, 0.06 * exact) << row[0] << ' ' << row[1];
    inside += at < edge;
    beside += at > edge && exact < largest;
    whole += exact == largest;
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(beside, 1000);
  EXPECT_GT(whole, 100);
  for (const std::string file : {"map.pcd", "map.ply"}) {
    const std::vector<Row> same = map(file);
    ASSERT_EQ(same.size(), rows.size()) << file;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k)
        ASSERT_NEAR(same[i][k], rows[i][k], 1e-4) << file << ' ' << i;
  }
}

TEST(ReachMap, AndThePathAgreeOnGroovesOfAFewSpacings)
{
  const double height = 1.2, length = 10.0, spacing = 1.7; // ripples z = -height cos(2 pi x / length)
  const double exact = length * length / (4.0 * M_PI * M_PI * height);
  for (const unsigned int seed : {2U, 3U}) {
    const ScratchFolder folder;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-0.35 * spacing, 0.35 * spacing);
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (double x = -24.0; x < 24.0; x += spacing)
      for (double y = -14.0; y < 14.0; y += spacing) {
        const double at = x + off(random), z = std::abs(at) < 1.5 * length ? -height * std::cos(2.0 * M_PI * at / length) : height;
        cloud.push_back({static_cast<float>(at), static_cast<float>(y + off(random)), static_cast<float>(z)});
      }
    pcl::io::savePCDFileBinary(folder.path("scan.pcd"), cloud);
    const RunResult result =
        endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM,
                           {"scan.pcd", "-o", "a.csv", "-o", "a.json", "--tool-radius", "2.5", "--scallop", "0.05", "--reach", "map.csv"},
                           folder),
              folder);
    ASSERT_EQ(result.code, 0) << result.err;
    double least = largest;
    for (const Row& row : rowsOfText(readText(folder.path("map.csv"))))
      least = std::min(least, row[3]);
    const std::string report = readText(folder.path("a.json")), key = "\"fitting_radius\":";
    const std::size_t at = report.find(key);
    ASSERT_NE(at, std::string::npos);
    EXPECT_NEAR(least, std::stod(report.substr(at + key.size())), 1e-4) << seed;
    EXPECT_LT(least, exact) << seed;       // a larger one gouges
    EXPECT_GT(least, 0.5 * exact) << seed; // with points up to 1.7 spacings apart, fits err to the safe side
  }
}

} // namespace reach_map_test
