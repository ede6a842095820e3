// SPDX-License-Identifier: BSD-3-Clause
// Makes the first inputs of the fuzzers, with the library's and PCL's writers: fuzz_seeds FOLDER.
#include <pcl_spiral/io/toolpath_writer.h>

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace pcl_spiral;
namespace fs = std::filesystem;

namespace {

constexpr int count = 5;

void
write(const fs::path& file, const std::string& bytes)
{
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string
bytesOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

template <typename PointT>
void
writeScans(const fs::path& folder, const std::string& name, const pcl::PointCloud<PointT>& cloud)
{
  fs::create_directories(folder / "pcd");
  fs::create_directories(folder / "ply");
  pcl::PCDWriter pcd;
  pcd.writeASCII((folder / "pcd" / (name + "_ascii")).string(), cloud);
  pcd.writeBinary((folder / "pcd" / (name + "_binary")).string(), cloud);
  pcd.writeBinaryCompressed((folder / "pcd" / (name + "_packed")).string(), cloud);
  pcl::PLYWriter ply;
  ply.write((folder / "ply" / (name + "_ascii")).string(), cloud, false);
  ply.write((folder / "ply" / (name + "_binary")).string(), cloud, true);
}

std::string
binaryStl()
{
  std::string bytes(84 + 50 * 2, '\0');
  bytes[80] = 2;
  for (std::size_t k = 0; k < 18; ++k) {
    const float value = 0.5f * static_cast<float>(k * k % 7);
    std::memcpy(&bytes[84 + 50 * (k / 9) + 12 + 4 * (k % 9)], &value, sizeof(value));
  }
  return bytes;
}

/** LAS 1.\p minor with two points. */
std::string
las(char minor, char format, std::size_t header, std::size_t size)
{
  std::string bytes(header + 2 * size, '\0');
  bytes.replace(0, 4, "LASF");
  bytes[24] = 1;
  bytes[25] = minor;
  for (const std::size_t at : {94, 96})
    std::memcpy(&bytes[at], &header, 2);
  bytes[104] = format;
  bytes[105] = static_cast<char>(size);
  bytes[minor == 4 ? 247 : 107] = 2;
  return bytes;
}

void
writeTexts(const fs::path& folder)
{
  const std::string rows = "1.5 -2.25 3\n4 5.5e-1 -6\nnan inf 7\n";
  write(folder / "text/plain", "\2" + rows);
  write(folder / "text/named", "\1"
                               "1;2;3;4\n2;1e3;+5;.5\n");
  write(folder / "text/header", "\2# made by hand\nz,x,\"y\"\r\n1,2,3\r\n4,5,6\r\n");
  write(folder / "text/comment", "\2//X Y Z I\n1\t2\t3\t4\n");
  write(folder / "obj/mesh", "# a mesh\no part\nv 1 2 3\nv 4 5 6 1\nv 1e-3 .5 -7\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  write(folder / "obj/faces", "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 10 10 5\nv 0 20 0\nvt 0 0\nf 1 2 3 4 5\nf -5/1 -3/1 \\\n"
                              " -1/1/1 # last\nf 5 4 3 2\n");
  write(folder / "pts/blocks", "2\r\n1.5 -2.25 3 -1024 255 0 128\r\n4 5.5e-1 -6 7 1 2 3\r\n\r\n1\r\n7 8 9\r\n");
  write(folder / "las/oldest", las(0, 0, 227, 20));
  write(folder / "las/newest", las(4, 7, 375, 36));
  write(folder / "stl/ascii", "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 1 2 3\n   vertex 4 5 6\n"
                              "   vertex 7 8 -9\n  endloop\n endfacet\nendsolid a\n");
  write(folder / "stl/binary", binaryStl());
  write(folder / "ply/lists", "ply\nformat ascii 1.0\nelement camera 1\nproperty list uchar int k\nelement vertex 1\n"
                              "property double x\nproperty float z\nproperty short y\nproperty list uchar float c\n"
                              "end_header\n2 8 9\n1 2 3 2 4 5\n");
  write(folder / "ply/big_endian", "ply\nformat binary_big_endian 1.0\nelement face 1\nproperty list uchar short i\n"
                                   "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                                   "end_header\n" +
                                       std::string("\2\0\1\0\2\0\0\0\0\0\0\0\0\0\0\0\0", 17));
  const std::string corners = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  write(folder / "ply/faces", "ply\nformat ascii 1.0\n" + corners +
                                  "element face 3\nproperty uchar red\nproperty list uchar int vertex_indices\nend_header\n"
                                  "0 0 0\n9 3 0\n0 6 0\n2 3 1\n1 3 0 1 2\n2 4 0 1 2 3\n3 4 3 2 1 0\n");
  for (const std::string order : {"little", "big"}) {
    std::string bytes =
        "ply\nformat binary_" + order + "_endian 1.0\n" + corners + "element face 2\nproperty list uchar uchar vertex_index\nend_header\n";
    for (std::size_t byte = 0; byte < 48; ++byte)
      bytes += static_cast<char>(byte * 37 % 64);
    write(folder / ("ply/faces_" + order), bytes + std::string("\3\0\1\2\4\0\1\2\3", 9));
  }
  write(folder / "job/plain.yaml", "scan: part.pcd\ntool-radius: 10\nscallop: 0.05\noutput: [a.csv, a.vtp]\n"
                                   "center: [1, 2, 3]\nboundaries: two\nverify: true\n");
  write(folder / "job/block.yaml", "# a job\nscan: 'part.xyz'\ncolumns: id,x,y,z\nunits: inch\noutput:\n  - a.png\n"
                                   "  - a.json\ntilt: -5\noutliers: 16,3\nlines: harmonic\n");
  write(folder / "job/json.yaml", "{\"scan\": \"part.ply\", \"tool-radius\": 3, \"scallop\": 1e-2, \"output\": "
                                  "[\"a.html\"], \"origin\": [1, 2.5, -3]}\n");
}

/** The machine files of the examples. */
void
copyMachines(const fs::path& folder)
{
  fs::create_directories(folder / "machine");
  for (const auto& file : fs::directory_iterator(PCL_SPIRAL_MACHINES_DIR))
    fs::copy(file.path(), folder / "machine" / file.path().filename());
}

/** Each with a first byte that gives its format to the fuzzer. */
void
writeToolpaths(const fs::path& folder)
{
  pcl::PointCloud<ToolpathPoint> path;
  for (int i = 0; i < count; ++i) {
    ToolpathPoint point;
    point.x = static_cast<float>(i);
    point.normal_z = point.axis_z = 1.0f;
    point.arc_length = i;
    path.push_back(point);
  }
  char format = 0;
  for (const std::string& extension : toolpathExtensions()) {
    const fs::path file = folder / ("path" + extension);
    writeToolpath(file.string(), path, {10.0, 1000.0});
    write(folder / "toolpath" / extension.substr(1), std::string(1, format++) + bytesOf(file));
    fs::remove(file);
  }
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  const fs::path folder = argv[1];
  pcl::PointCloud<pcl::PointXYZ> plain;
  pcl::PointCloud<pcl::PointNormal> rich;
  for (int i = 0; i < count; ++i) {
    plain.emplace_back(static_cast<float>(i), 0.5f, 1e-3f);
    rich.emplace_back(1.0f, static_cast<float>(i), 2.0f, 0.0f, 0.0f, 1.0f);
  }
  writeScans(folder, "plain", plain);
  writeScans(folder, "rich", rich);
  writeTexts(folder);
  writeToolpaths(folder);
  copyMachines(folder);
  return 0;
}
