// SPDX-License-Identifier: BSD-3-Clause
#include "io/base64_text.h"
#include "io/byte_file.h"
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/scene_writer.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace pcl_spiral {
namespace {

using Json = nlohmann::ordered_json;

constexpr int floats = 5126, unsigned_ints = 5125;                         // component types of glTF
constexpr int vertices = 34962, indices = 34963, lines = 1, triangles = 4; // targets of views, modes of primitives

/** Data and their description, one view and one accessor each. */
class GltfData {
public:
  std::size_t addVectors(const std::vector<Eigen::Vector3f>& values, bool bounds)
  {
    std::size_t accessor = add(values, "VEC3", floats, vertices);
    if (bounds) {
      Eigen::Array3f low = values.front(), high = low;
      for (const Eigen::Vector3f& v : values) {
        low = low.min(v.array());
        high = high.max(v.array());
      }
      accessors_.back()["min"] = {low[0], low[1], low[2]};
      accessors_.back()["max"] = {high[0], high[1], high[2]};
    }
    return accessor;
  }
  std::size_t addNumbers(const std::vector<float>& values) { return add(values, "SCALAR", floats, vertices); }
  std::size_t addIndices(const std::vector<std::uint32_t>& values) { return add(values, "SCALAR", unsigned_ints, indices); }

  const std::string& bytes() const { return bytes_; }
  const Json& views() const { return views_; }
  const Json& accessors() const { return accessors_; }

private:
  template <typename Value>
  std::size_t add(const std::vector<Value>& values, const char* type, int component, int target)
  {
    const std::size_t begin = bytes_.size(), length = values.size() * sizeof(Value);
    bytes_.resize(begin + length);
    std::memcpy(bytes_.data() + begin, values.data(), length);
    views_.push_back({{"buffer", 0}, {"byteOffset", begin}, {"byteLength", length}, {"target", target}});
    accessors_.push_back({{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", values.size()}, {"type", type}});
    return accessors_.size() - 1;
  }

  std::string bytes_;
  Json views_ = Json::array(), accessors_ = Json::array();
};

/** From mm with z up to m with y up. */
Eigen::Vector3f
placeInGltf(const Eigen::Vector3f& p)
{
  return 1e-3f * Eigen::Vector3f(p.x(), p.z(), -p.y());
}

/** From dark blue through green to yellow up to the limit; orange above it, red for gouges. Linear, as glTF wants vertex colours. */
Eigen::Vector3f
colorOfStock(float height, const CutScene& scene)
{
  if (height > scene.limit)
    return {1.0f, 0.26f, 0.0f};
  if (height < -scene.gouge)
    return {0.67f, 0.0f, 0.01f};
  const double range = scene.limit + scene.gouge;
  const auto f = static_cast<float>(range > 0.0 ? std::clamp((height + scene.gouge) / range, 0.0, 1.0) : 0.0);
  return {0.05f + 0.6f * f * f, 0.05f + 0.65f * f, 0.25f * (1.0f - f)};
}

Json
materialOf(const char* name, double red, double green, double blue)
{
  return {{"name", name},
          {"doubleSided", true},
          {"pbrMetallicRoughness", {{"baseColorFactor", {red, green, blue, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}}};
}

Json
surfacePrimitives(const CutScene& scene, bool raised, GltfData& data)
{
  const StockMesh& mesh = scene.stock;
  std::vector<Eigen::Vector3f> places, normals, colors;
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < mesh.places.size(); ++i) {
    const Eigen::Vector3f& n = mesh.normals[i];
    places.push_back(placeInGltf(raised ? mesh.places[i] : Eigen::Vector3f(mesh.places[i] - mesh.stock[i] * n)));
    normals.push_back(1e3f * placeInGltf(n.normalized()));
    colors.push_back(colorOfStock(mesh.stock[i], scene));
  }
  for (const Triangulation::Triangle& triangle : mesh.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  Json attributes = {{"POSITION", data.addVectors(places, true)}, {"NORMAL", data.addVectors(normals, false)}};
  if (raised) {
    attributes["COLOR_0"] = data.addVectors(colors, false);
    attributes["_STOCK"] = data.addNumbers(mesh.stock);
  }
  return Json::array(
      {{{"attributes", attributes}, {"indices", data.addIndices(corners)}, {"material", raised ? 2 : 0}, {"mode", triangles}}});
}

/** The passes that have moves. */
std::vector<PassRange>
movingPasses(const pcl::PointCloud<ToolpathPoint>& path)
{
  std::vector<PassRange> passes = passRanges(passBegins(path), path.size());
  passes.erase(std::remove_if(passes.begin(), passes.end(), [](const PassRange& pass) { return pass.end < pass.begin + 2; }), passes.end());
  return passes;
}

Json
pathPrimitives(const pcl::PointCloud<ToolpathPoint>& path, GltfData& data)
{
  std::vector<Eigen::Vector3f> places;
  std::vector<std::uint32_t> ends;
  for (const PassRange& pass : movingPasses(path))
    for (std::size_t i = pass.begin; i < pass.end; ++i) {
      if (i > pass.begin)
        for (const std::size_t end : {places.size() - 1, places.size()})
          ends.push_back(static_cast<std::uint32_t>(end));
      places.push_back(placeInGltf(path[i].getVector3fMap()));
    }
  return Json::array({{{"attributes", {{"POSITION", data.addVectors(places, true)}}},
                       {"indices", data.addIndices(ends)},
                       {"material", 1},
                       {"mode", lines}}});
}

Json
documentOf(const CutScene& scene, GltfData& data)
{
  Json document = {{"asset", {{"version", "2.0"}, {"generator", "pcl_spiral"}}}, {"scene", 0}};
  if (!scene.shift.isZero())
    document["asset"]["extras"]["shift_mm"] = {scene.shift.x(), scene.shift.y(), scene.shift.z()};
  document["scenes"] = Json::array({{{"nodes", {0, 1, 2}}}});
  document["nodes"] = Json::array({{{"name", "part"}, {"mesh", 0}}, {{"name", "path"}, {"mesh", 1}}, {{"name", "stock"}, {"mesh", 2}}});
  document["materials"] =
      Json::array({materialOf("part", 0.6, 0.65, 0.72), materialOf("path", 0.1, 0.3, 0.9), materialOf("stock", 1.0, 1.0, 1.0)});
  document["meshes"] = Json::array({{{"name", "part"}, {"primitives", surfacePrimitives(scene, false, data)}},
                                    {{"name", "path"}, {"primitives", pathPrimitives(*scene.path, data)}},
                                    {{"name", "stock"}, {"primitives", surfacePrimitives(scene, true, data)}}});
  document["accessors"] = data.accessors();
  document["bufferViews"] = data.views();
  document["buffers"] = Json::array({{{"byteLength", data.bytes().size()}}});
  return document;
}

/** A number of a .glb: little-endian. */
std::string
word(std::size_t value)
{
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(value >> shift & 0xffu);
  return bytes;
}

} // namespace

void
writeScene(const std::string& file, const CutScene& scene)
{
  if (scene.stock.triangles.empty())
    throw FileError(file, "not written: the surface has no triangles");
  if (!scene.path || movingPasses(*scene.path).empty())
    throw FileError(file, "not written: the path has no moves");
  GltfData data;
  Json document = documentOf(scene, data);
  ByteFile out(file);
  if (lowerExtension(file) == ".glb") {
    std::string text = document.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    out.write("glTF" + word(2) + word(28 + text.size() + data.bytes().size()));
    out.write(word(text.size()) + "JSON" + text);
    out.write(word(data.bytes().size()) + std::string("BIN\0", 4));
    out.write(data.bytes());
  }
  else {
    document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(data.bytes().data(), data.bytes().size());
    out.write(document.dump() + "\n");
  }
  out.close();
}

} // namespace pcl_spiral
