// SPDX-License-Identifier: BSD-3-Clause
// Meshes in every format: the same faces from each.
#include <pcl_spiral/io/mesh_reader.h>

#include "support/mesh_files.h"

#include <pcl/conversions.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/vtk_lib_io.h>

#include <cmath>

namespace mesh_reader_test {

using namespace pcl_spiral;

namespace {

pcl::PointCloud<pcl::PointXYZ>
pointsOf(const pcl::PolygonMesh& mesh)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2(mesh.cloud, cloud);
  return cloud;
}

Triangles
trianglesOf(const pcl::PolygonMesh& mesh)
{
  Triangles triangles;
  for (const pcl::Vertices& face : mesh.polygons) {
    EXPECT_EQ(face.vertices.size(), 3U);
    triangles.push_back({face.vertices[0], face.vertices[1], face.vertices[2]});
  }
  return triangles;
}

/** The places of all corners of all faces, in sequence. */
std::vector<Eigen::Vector3f>
cornerPlaces(const pcl::PolygonMesh& mesh)
{
  const auto points = pointsOf(mesh);
  std::vector<Eigen::Vector3f> places;
  for (const auto& triangle : trianglesOf(mesh))
    for (const int corner : triangle)
      places.push_back(points[static_cast<std::size_t>(corner)].getVector3fMap());
  return places;
}

/** A sphere of 50 mm, bulged, of 2 * rings * sectors faces with uneven numbers. */
pcl::PolygonMesh
bulgedSphere(int rings, int sectors)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::PolygonMesh mesh;
  for (int r = 0; r <= rings; ++r)
    for (int s = 0; s < sectors; ++s) {
      const double a = 0.1 + 2.9 * r / rings, b = 2.0 * M_PI * s / sectors, radius = 50.0 + std::sin(3 * a + 5 * b);
      cloud.emplace_back(radius * std::sin(a) * std::cos(b), radius * std::sin(a) * std::sin(b), radius * std::cos(a));
    }
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < sectors; ++s) {
      const int here = r * sectors + s, next = r * sectors + (s + 1) % sectors;
      for (const std::array<int, 3>& t : {std::array<int, 3>{here, here + sectors, next}, {next, here + sectors, next + sectors}}) {
        mesh.polygons.emplace_back();
        mesh.polygons.back().vertices.assign(t.begin(), t.end());
      }
    }
  pcl::toPCLPointCloud2(cloud, mesh.cloud);
  return mesh;
}

class MeshReader : public MeshFiles {
protected:
  void expectMesh(const std::string& file, const Triangles& faces = two_faces)
  {
    const MeshFile read = readMesh(file);
    const auto points = pointsOf(*read.mesh);
    ASSERT_EQ(points.size(), corners.size()) << file;
    for (std::size_t i = 0; i < corners.size(); ++i)
      EXPECT_EQ(points[i].getVector3fMap(), corners[i]) << file << " vertex " << i;
    EXPECT_EQ(trianglesOf(*read.mesh), faces) << file;
    EXPECT_TRUE(read.warnings.empty());
  }
};

} // namespace

TEST_F(MeshReader, Stl)
{
  // Vertices are numbered in the order in which facets name them.
  const auto inOrder = [](const MeshFile& read) {
    const std::vector<Eigen::Vector3f> wanted{corners[0], corners[2], corners[1], corners[0], corners[1], corners[3]};
    EXPECT_EQ(trianglesOf(*read.mesh), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(cornerPlaces(*read.mesh), wanted);
    EXPECT_EQ(pointsOf(*read.mesh).size(), 4U) << "corners at one place are one vertex";
  };
  inOrder(readMesh(text("a.stl", binaryStl(two_faces))));
  inOrder(readMesh(text("b.stl", "solid a\n" + facet("vertex 0 0 0\nvertex 0 10 0\nvertex 10 -0 0\n") +
                                     facet("VERTEX 0 0 0\r\nVERTEX 10 0 0\r\nVERTEX 0 0 1.05E1\r\n") + "endsolid a\n")));
}

TEST_F(MeshReader, Obj)
{
  expectMesh(text("a.obj", "mtllib m.mtl\n" + obj_corners + "vt 0 0\nvn 0 0 1\ng one\nf 1 3 2\ns 1\nf 1 2 4\n"));
  expectMesh(text("b.obj", obj_corners + "f 1/1 3/1 2/1\nf 1//1 2//1 4//1\n"));
  expectMesh(text("c.obj", obj_corners + "f 1/1/1 3/2/1 2/3/1 # first\nf -4 -3/1/1 -1\n"));
  expectMesh(text("d.obj", "v 0 0 0\nv 10 0 0\nf 1 3 2\nv 0 10 0\nv 0 0 10.5\nf\t1  2\t4 \n")); // named before it is defined
  expectMesh(text("e.obj", obj_corners + "f 1 3 \\\r\n 2\r\nf 1 \\\r\n2\\\r\n4"));
}

TEST_F(MeshReader, AsciiPly)
{
  expectMesh(text("a.ply", ascii + ply_vertices + ply_faces + "end_header\n" + ply_rows + "3 0 2 1\n3 0 1 3\n"));
  expectMesh(text("b.ply", ascii + "comment\n" + ply_vertices +
                               "element face 2\nproperty uchar red\nproperty list uint8 float texcoord\n"
                               "property list uchar uint vertex_index\nproperty float quality\n"
                               "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n" +
                               ply_rows + "7 2 .5 .5 3 0 2 1 0.5\n\n8 0 3 0 1 3 nan\n0 1\n"));
  expectMesh(text("c.ply", ascii + ply_faces + ply_vertices + "end_header\n3 0 2 1\n3 0 1 3\n" + ply_rows)); // faces first
  expectMesh(text("d.ply", ascii + ply_vertices + "element face 1\nproperty list uchar int vertex_indices\n" +
                               "element face 1\nproperty list uchar int vertex_index\n"
                               "element tristrips 0\nproperty list int int vertex_indices\nend_header\n" +
                               ply_rows + "3 0 2 1\n3 0 1 3\n"));
}

TEST_F(MeshReader, BinaryPlyOfBothOrders)
{
  for (const bool swapped : {false, true}) {
    std::string bytes = std::string("ply\nformat binary_") + (swapped ? "big" : "little") + "_endian 1.0\n" +
                        "element vertex 4\nproperty double x\nproperty uchar red\nproperty float y\nproperty double z\n"
                        "element face 2\nproperty list uchar float texcoord\nproperty list ushort short vertex_indices\n"
                        "property uchar flags\nend_header\n";
    for (const Eigen::Vector3f& p : corners)
      bytes +=
          bytesOf(static_cast<double>(p.x()), swapped) + "\x7f" + bytesOf(p.y(), swapped) + bytesOf(static_cast<double>(p.z()), swapped);
    for (const auto& face : two_faces) {
      bytes += "\x01" + bytesOf(0.5f, swapped) + bytesOf(std::uint16_t{3}, swapped);
      for (const int corner : face)
        bytes += bytesOf(static_cast<std::int16_t>(corner), swapped);
      bytes += '\x09';
    }
    expectMesh(text("a.ply", bytes));
    expectProblem("b.ply", bytes.substr(0, bytes.size() - 4),
                  "is cut off at byte " + std::to_string(bytes.size() - 4) + ", in face 2 of 2");
  }
}

TEST_F(MeshReader, AgreesWithVtkOnItsOwnFiles)
{
  const pcl::PolygonMesh made = bulgedSphere(23, 31);
  const std::vector<Eigen::Vector3f> wanted = cornerPlaces(made);
  for (const std::string& extension : meshExtensions())
    for (const bool binary : {false, true}) {
      const std::string file = folder_.path("sphere" + extension);
      ASSERT_TRUE(extension == ".obj" ? pcl::io::saveOBJFile(file, made, 9) == 0 : pcl::io::savePolygonFile(file, made, binary));
      pcl::PolygonMesh theirs;
      ASSERT_GT(pcl::io::loadPolygonFile(file, theirs), 0);
      const std::vector<Eigen::Vector3f> by_us = cornerPlaces(*readMesh(file).mesh), by_vtk = cornerPlaces(theirs);
      ASSERT_EQ(by_us.size(), wanted.size()) << file;
      ASSERT_EQ(by_vtk.size(), wanted.size()) << file;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_LE((by_us[i] - wanted[i]).norm(), 1e-3f) << file << " corner " << i; // ascii has six digits
        EXPECT_EQ(by_us[i], by_vtk[i]) << file << " corner " << i;
      }
    }
}

TEST_F(MeshReader, VerticesAreThoseOfTheScan)
{
  const std::string ply = ascii + "element vertex 5\nproperty double x\nproperty double y\nproperty double z\n" +
                          "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                          "393775.001 3689071.002 3107.003\n393776.001 3689072.002 3108.003\nnan 0 0\n"
                          "393775.501 3689071.002 3107.003\n1 2 3\n3 0 1 3\n";
  for (const std::string& file : {text("far.ply", ply), text("a.obj", obj_corners + "f 1 3 2\n"), text("a.stl", binaryStl(two_faces))}) {
    ReadOptions options;
    options.unit = LengthUnit::Metre;
    options.origin = {393775.0, 3689071.0, 3107.0};
    const MeshFile mesh = readMesh(file, options);
    const Scan scan = readCloud(file, options);
    const auto points = pointsOf(*mesh.mesh);
    ASSERT_EQ(points.size(), scan.cloud->size());
    EXPECT_EQ(std::memcmp(points.data(), scan.cloud->data(), points.size() * sizeof(pcl::PointXYZ)), 0) << file;
    EXPECT_EQ(mesh.warnings, scan.warnings) << file;
  }
}

TEST_F(MeshReader, UnitsHintsAndColumns)
{
  const std::string small = text("a.obj", "v 0 0 0\nv 0.5 0 0\nv 0 0.5 0\nf 1 2 3\n");
  ASSERT_EQ(readMesh(small).warnings.size(), 1U);
  EXPECT_NE(readMesh(small).warnings[0].text().find("ReadOptions::unit"), std::string::npos);
  ReadOptions options;
  options.unit = LengthUnit::Inch;
  EXPECT_TRUE(readMesh(small, options).warnings.empty());
  EXPECT_FLOAT_EQ(pointsOf(*readMesh(small, options).mesh)[1].x, 12.7f);
  options.columns = {"x", "y", "z"};
  EXPECT_NE(problem(small, options).find("leave ReadOptions::columns out"), std::string::npos);
}

TEST_F(MeshReader, FacesWithoutAreaStayButTheyAreNotCut)
{
  expectMesh(text("a.obj", obj_corners + "f 1 3 2\nf 1 1 2\nf 4 4 4 4\nf 1 3 2\n"), {{0, 2, 1}, {0, 0, 1}, {3, 3, 3}, {0, 2, 1}});
  const MeshFile read = readMesh(text("b.obj", obj_corners + "f 1 3 2 2\nf 1 2 4 1\n"));
  EXPECT_EQ(trianglesOf(*read.mesh), two_faces) << "corners named twice running count once";
  EXPECT_EQ(read.polygons, 0U);
}

} // namespace mesh_reader_test
