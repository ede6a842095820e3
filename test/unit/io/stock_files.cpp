// SPDX-License-Identifier: BSD-3-Clause
// The surface after cutting, written and read back by PCL: heights and places over an exact plane, triangles that close it.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/stock_writer.h>
#include <pcl_spiral/surface/scanned_surface.h>
#include <pcl_spiral/verify/material_removal.h>

#include "support/passes.h"
#include "support/reference.h"
#include "support/scratch_folder.h"

#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>
#include <pcl/io/vtk_lib_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

namespace stock_files_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double R = 6.0, step = 2.0, deep = 0.1, half = 20.0;

/** Rows along y over the plane, all of them too deep; what they leave is known everywhere. */
StockMesh
leftOnThePlane()
{
  const SurfacePtr surface = flat(Region({rectangle(2.0 * half, 2.0 * half)}));
  std::vector<double> us;
  for (int i = -10; i <= 10; ++i)
    us.push_back(step * i);
  CheckedPath path = straightPasses(*surface, us, half + 2.0, 2.0);
  for (std::size_t i = 0; i < path.size(); ++i)
    path.contacts[i] -= deep * path.normals[i];
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(toCloud(sampleUniform(*surface, 6000, 1).points));
  removal.setInputToolpath(toolpath(path));
  removal.setToolRadius(R);
  removal.setScallopHeight(0.05);
  pcl::PointCloud<pcl::PointXYZI> values;
  removal.compute(values);
  EXPECT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
  std::vector<float> stock;
  for (const pcl::PointXYZI& value : values)
    stock.push_back(value.intensity);
  return stockMesh(*removal.getReferenceSurface(), stock);
}

/** Height of the ball's groove over the plane at \p x. */
double
groove(double x)
{
  const double beside = x - step * std::round(x / step);
  return R - std::sqrt(R * R - beside * beside) - deep;
}

double
areaOf(const pcl::PointCloud<pcl::PointXYZ>& cloud, const std::vector<pcl::Vertices>& faces)
{
  double area = 0.0;
  for (const pcl::Vertices& face : faces) {
    const auto at = [&](int i) { return cloud[face.vertices[static_cast<std::size_t>(i)]].getVector3fMap(); };
    const Eigen::Vector3f normal = (at(1) - at(0)).cross(at(2) - at(0));
    EXPECT_GT(normal.z(), 0.0f); // seen from outside
    area += 0.5 * normal.norm();
  }
  return area;
}

} // namespace

TEST(StockFiles, PlyIsReadByPclWithTheHeightLeftAtEachVertex)
{
  const ScratchFolder folder;
  const StockMesh left = leftOnThePlane();
  writeStock(folder.path("left.ply"), left);
  pcl::PolygonMesh read;
  ASSERT_EQ(pcl::io::loadPLYFile(folder.path("left.ply"), read), 0);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2(read.cloud, cloud);
  ASSERT_GT(cloud.size(), 5900u);
  const auto field = std::find_if(read.cloud.fields.begin(), read.cloud.fields.end(), [](const auto& f) { return f.name == "stock"; });
  ASSERT_NE(field, read.cloud.fields.end());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    float stock = 0.0f;
    std::memcpy(&stock, &read.cloud.data[i * read.cloud.point_step + field->offset], sizeof stock);
    ASSERT_NEAR(stock, groove(cloud[i].x), 2e-3) << cloud[i].x;
    ASSERT_NEAR(cloud[i].z, stock, 1e-4); // over the plane
  }
  EXPECT_NEAR(areaOf(cloud, read.polygons), 4.0 * half * half, 0.03 * 4.0 * half * half); // no holes
}

TEST(StockFiles, EveryEdgeInsideHasTwoTriangles)
{
  const StockMesh left = leftOnThePlane();
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : left.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++edges[std::minmax({triangle[i], triangle[(i + 1) % 3]})];
  for (const auto& [edge, count] : edges) {
    ASSERT_LE(count, 2);
    const Eigen::Vector3f middle = 0.5f * (left.places[edge.first] + left.places[edge.second]);
    if (std::max(std::abs(middle.x()), std::abs(middle.y())) < half - 3.0)
      ASSERT_EQ(count, 2) << middle.transpose();
  }
}

TEST(StockFiles, StlIsReadByPcl)
{
  const ScratchFolder folder;
  const StockMesh left = leftOnThePlane();
  writeStock(folder.path("left.stl"), left);
  pcl::PolygonMesh read;
  ASSERT_GT(pcl::io::loadPolygonFileSTL(folder.path("left.stl"), read), 0);
  EXPECT_EQ(read.polygons.size(), left.triangles.size());
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2(read.cloud, cloud);
  for (const pcl::PointXYZ& point : cloud)
    ASSERT_NEAR(point.z, groove(point.x), 2e-3);
  EXPECT_NEAR(areaOf(cloud, read.polygons), 4.0 * half * half, 0.03 * 4.0 * half * half);
}

TEST(StockFiles, MapCoordinatesAreWrittenInDoublePrecision)
{
  const ScratchFolder folder;
  StockMesh left;
  left.places = {{0.125f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.5f}, {0.0f, 1.0f, 0.0f}};
  left.stock = {0.5f, -0.25f, 0.0f};
  const Eigen::Vector3d origin(393775000.0, 3689071000.0, 2000.0);
  writeStock(folder.path("left.ply"), left, origin); // points alone
  const std::string text = readText(folder.path("left.ply"));
  const std::size_t begin = text.find("end_header\n") + 11;
  double x = 0.0;
  std::memcpy(&x, text.data() + begin, sizeof x);
  EXPECT_EQ(x, 393775000.125);
  EXPECT_EQ(text.size(), begin + 3 * (3 * sizeof(double) + sizeof(float)));
  EXPECT_THROW(writeStock(folder.path("left.stl"), left, origin), FileError);
}

} // namespace stock_files_test
