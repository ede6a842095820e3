// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/io/stock_writer.h>

#include "common/formatted_text.h"
#include "io/byte_file.h"
#include <pcl_spiral/io/file_error.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <cstring>

namespace pcl_spiral {
namespace {

constexpr std::size_t block = 1u << 20; // bytes written together

/** Packs little-endian values and writes them in blocks. */
class Packed {
public:
  explicit Packed(ByteFile& out) : out_(out) {}

  template <typename T>
  void put(T value)
  {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    bytes_.append(bytes, sizeof(T));
    if (bytes_.size() >= block)
      flush();
  }
  void put(const Eigen::Vector3f& v)
  {
    for (int c = 0; c < 3; ++c)
      put(v[c]);
  }
  void flush()
  {
    out_.write(bytes_);
    bytes_.clear();
  }

private:
  ByteFile& out_;
  std::string bytes_;
};

void
writePly(const StockMesh& mesh, const Eigen::Vector3d& origin, ByteFile& out)
{
  const bool moved = !origin.isZero();
  const char* const real = moved ? "double" : "float";
  out.write(formatted("ply\nformat binary_little_endian 1.0\ncomment surface after cutting, mm; stock: height left, negative for a gouge\n"
                      "element vertex %zu\nproperty %s x\nproperty %s y\nproperty %s z\nproperty float stock\n"
                      "element face %zu\nproperty list uchar int vertex_indices\nend_header\n",
                      mesh.places.size(), real, real, real, mesh.triangles.size()));
  Packed packed(out);
  for (std::size_t i = 0; i < mesh.places.size(); ++i) {
    if (moved)
      for (int c = 0; c < 3; ++c)
        packed.put(static_cast<double>(mesh.places[i][c]) + origin[c]);
    else
      packed.put(mesh.places[i]);
    packed.put(mesh.stock[i]);
  }
  for (const Triangulation::Triangle& triangle : mesh.triangles) {
    packed.put(static_cast<std::uint8_t>(3));
    for (const std::uint32_t corner : triangle)
      packed.put(static_cast<std::int32_t>(corner));
  }
  packed.flush();
}

void
writeStl(const StockMesh& mesh, const Eigen::Vector3d& origin, ByteFile& out)
{
  std::string head = "surface after cutting, mm";
  if (!origin.isZero())
    head += formatted("; from %.10g %.10g %.10g", origin.x(), origin.y(), origin.z());
  head.resize(80, ' ');
  out.write(head);
  Packed packed(out);
  packed.put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f normal = (mesh.places[b] - mesh.places[a]).cross(mesh.places[c] - mesh.places[a]);
    packed.put(normal.norm() > 0.0f ? Eigen::Vector3f(normal.normalized()) : Eigen::Vector3f(Eigen::Vector3f::Zero()));
    for (const std::uint32_t corner : {a, b, c})
      packed.put(mesh.places[corner]);
    packed.put(static_cast<std::uint16_t>(0));
  }
  packed.flush();
}

} // namespace

void
writeStock(const std::string& file, const StockMesh& mesh, const Eigen::Vector3d& origin)
{
  const bool ply = lowerExtension(file) == ".ply";
  if (!ply && mesh.triangles.empty())
    throw FileError(file, "not written: the surface has no triangles; write its points as .ply");
  ByteFile out(file);
  ply ? writePly(mesh, origin, out) : writeStl(mesh, origin, out);
  out.close();
}

} // namespace pcl_spiral
