// SPDX-License-Identifier: BSD-3-Clause
#include "face_list.h"
#include "field_layout.h"
#include "text_encoding.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <unordered_map>

namespace pcl_spiral {
namespace {

// An own reader, because VTK's accepts a cut-off file as a smaller one and reads the file twice.

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;
constexpr std::size_t normal_bytes = 12;

using Corner = std::array<float, 3>;

/** Compares bits, so that a corner that is not a number equals itself. */
struct CornerHash {
  std::size_t operator()(const Corner& corner) const
  {
    std::size_t hash = 0;
    for (const float value : corner) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

struct SameCorner {
  bool operator()(const Corner& a, const Corner& b) const
  {
    return std::memcmp(a.data(), b.data(), sizeof(a)) == 0; // NOLINT(bugprone-suspicious-memory-comparison): equal bits, as the hash
  }
};

/** Different corners in the order of the file. */
class Corners {
public:
  /** \return its number, from 0 */
  std::size_t add(Corner corner)
  {
    for (float& value : corner)
      value += 0.0f; // -0 becomes 0
    const auto [place, added] = seen_.emplace(corner, table_[0].size());
    if (added)
      for (std::size_t c = 0; c < 3; ++c)
        table_[c].push_back(corner[c]);
    return place->second;
  }
  PointTable take() { return std::move(table_); }

private:
  PointTable table_ = PointTable(3);
  std::unordered_map<Corner, std::size_t, CornerHash, SameCorner> seen_;
};

std::size_t
triangleCount(std::string_view bytes)
{
  return static_cast<std::size_t>(loadAs<std::uint32_t>(bytes.data() + 80));
}

bool
hasBinarySize(std::string_view bytes)
{
  return bytes.size() > header_bytes && bytes.size() == header_bytes + triangleCount(bytes) * triangle_bytes;
}

/** Some programs also begin binary files with "solid"; the file size for their count identifies them. */
bool
isText(std::string_view bytes)
{
  const std::string_view text = bytes.substr(utf8Mark(bytes));
  const std::string_view word = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()), 5);
  return sameWord(word, "solid") && !hasBinarySize(bytes) && bytes.substr(0, 1024).find('\0') == std::string_view::npos;
}

PointTable
readBinary(const std::string& file, std::string_view bytes, FaceList* faces)
{
  if (bytes.size() < header_bytes)
    throw FileError(file, Diagnostic("is not an STL file, neither ascii nor binary (", bytes.size(), " bytes)"));
  const std::size_t triangles = triangleCount(bytes);
  if (triangles == 0)
    throw FileError(file, "byte 80: by its header the file has no triangles; export it again");
  if (bytes.size() < header_bytes + triangles * triangle_bytes)
    throw FileError(file, Diagnostic("is cut off at byte ", bytes.size(), ": its ", triangles, " triangles need ",
                                     header_bytes + triangles * triangle_bytes, " bytes; copy or export it again"));
  Corners corners;
  for (std::size_t t = 0; t < triangles; ++t) {
    const std::size_t place = header_bytes + t * triangle_bytes;
    for (std::size_t k = 0; k < 3; ++k) {
      Corner corner;
      std::memcpy(corner.data(), bytes.data() + place + normal_bytes + k * sizeof(corner), sizeof(corner));
      const std::size_t number = corners.add(corner);
      if (faces)
        faces->corners.push_back(static_cast<std::int64_t>(number));
    }
    if (faces)
      faces->close(place);
  }
  return corners.take();
}

/** The corners on successive lines are a triangle; the first is on line \p number. */
void
closeFacet(const std::string& file, std::size_t number, FaceList& faces)
{
  if (faces.open() == 0)
    return;
  if (faces.open() != 3)
    throw FileError(file, atLine(number, Diagnostic("a facet of ", faces.open(),
                                                    " corners begins here, but STL has triangles; export the file again")));
  faces.close(number);
}

Corner
cornerOf(const std::string& file, const std::vector<std::string_view>& words, std::size_t number)
{
  if (words.size() != 4)
    throw FileError(file, atLine(number, "a vertex needs x y z; is the file cut off?"));
  Corner corner;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::optional<double> value = toNumber(words[c + 1]);
    if (!value)
      throw FileError(file, atLine(number, Diagnostic(inQuotes(words[c + 1]), " is not a number")));
    corner[c] = static_cast<float>(*value);
  }
  return corner;
}

PointTable
readText(const std::string& file, std::string_view bytes, FaceList* faces)
{
  Corners corners;
  LineScanner lines(bytes);
  std::string_view line;
  std::vector<std::string_view> words;
  bool ended = false, any = false;
  std::size_t first = 0; // line of the facet's first corner
  while (lines.next(line)) {
    splitWords(line, ' ', words);
    if (words.empty())
      continue;
    ended = sameWord(words[0], "endsolid");
    const bool vertex = sameWord(words[0], "vertex");
    if (!vertex && faces)
      closeFacet(file, first, *faces);
    if (!vertex)
      continue;
    const std::size_t number = corners.add(cornerOf(file, words, lines.number()));
    if (faces) {
      first = faces->open() == 0 ? lines.number() : first;
      faces->corners.push_back(static_cast<std::int64_t>(number));
    }
    any = true;
  }
  if (!ended)
    throw FileError(file, "is cut off: 'endsolid' is missing; copy or export it again");
  if (!any)
    throw FileError(file, "holds no triangles ('vertex x y z'); export it again");
  return corners.take();
}

PointTable
readStl(const std::string& file, std::string_view bytes, FaceList* faces)
{
  if (isText(bytes))
    return readText(file, bytes, faces);
  if (!hasBinarySize(bytes))
    refuseWideText(file, bytes);
  return readBinary(file, bytes, faces);
}

} // namespace

bool
isStl(std::string_view bytes)
{
  return isText(bytes) || hasBinarySize(bytes);
}

PointTable
readStlTable(const std::string& file, std::string_view bytes)
{
  return readStl(file, bytes, nullptr);
}

MeshTable
readStlMesh(const std::string& file, std::string_view bytes)
{
  MeshTable mesh;
  mesh.faces.first_vertex = 1;
  mesh.faces.place_word = isText(bytes) ? "line" : "byte";
  mesh.vertices = readStl(file, bytes, &mesh.faces);
  return mesh;
}

} // namespace pcl_spiral
