// SPDX-License-Identifier: BSD-3-Clause
#include "face_list.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>

#include <charconv>

namespace pcl_spiral {
namespace {

/** Whether the line is of this kind: a letter, and a space or a backslash that continues it. */
bool
startsWith(std::string_view line, char kind)
{
  return line.size() > 1 && line[0] == kind && (line[1] == ' ' || line[1] == '\t' || (line.size() == 2 && line[1] == '\\'));
}

void
takeVertex(const std::string& file, const std::vector<std::string_view>& words, std::size_t number, PointTable& table)
{
  if (words.size() < 4)
    throw FileError(file, atLine(number, "a vertex needs x y z; is the file cut off?"));
  for (std::size_t c = 0; c < 3; ++c) {
    const std::optional<double> value = toNumber(words[c + 1]);
    if (!value)
      throw FileError(file, atLine(number, Diagnostic(inQuotes(words[c + 1]), " is not a number")));
    table[c].push_back(*value);
  }
}

/** The vertex that a corner names as v, v/vt, v//vn or v/vt/vn: from 1, or below 0 counted back from the last vertex
 * before it. */
std::int64_t
vertexOf(const std::string& file, std::string_view word, std::size_t number, std::size_t vertices)
{
  const std::string_view digits = word.substr(0, word.find('/'));
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || value == 0)
    throw FileError(file, atLine(number, Diagnostic(inQuotes(word), " names no vertex; a face needs numbers from 1, or negative numbers "
                                                                    "that count back; export the file again")));
  const auto so_far = static_cast<std::int64_t>(vertices);
  if (value < -so_far)
    throw FileError(file, atLine(number, Diagnostic(inQuotes(word), " counts back beyond the ", vertices,
                                                    " vertices before it; export the file again")));
  return value > 0 ? value - 1 : so_far + value;
}

/** Whether the line goes on below it: a backslash is at its end. */
bool
isContinued(std::string_view line)
{
  return !line.empty() && line.back() == '\\';
}

/** Calls \p take for the words of a line without its comment, and for those of the lines that continue it. */
template <typename Take>
void
forWords(LineScanner& lines, std::string_view line, const Take& take)
{
  std::vector<std::string_view> words;
  for (bool more = true; more;) {
    line = line.substr(0, line.find('#'));
    more = isContinued(line);
    splitWords(more ? line.substr(0, line.size() - 1) : line, ' ', words);
    for (const std::string_view word : words)
      take(word);
    more = more && lines.next(line);
  }
}

void
takeFace(const std::string& file, LineScanner& lines, std::string_view line, std::size_t vertices, FaceList& faces)
{
  const std::size_t first = lines.number();
  line.remove_prefix(1);
  forWords(lines, line, [&](std::string_view word) { faces.corners.push_back(vertexOf(file, word, lines.number(), vertices)); });
  faces.close(first);
}

/** Vertices, and faces if a list for them is given. */
PointTable
readObj(const std::string& file, std::string_view bytes, FaceList* faces)
{
  PointTable table(3);
  LineScanner lines(bytes);
  std::string_view line;
  std::vector<std::string_view> words;
  while (lines.next(line)) {
    if (startsWith(line, 'v')) {
      const std::size_t number = lines.number();
      if (isContinued(line)) {
        words.clear();
        forWords(lines, line, [&words](std::string_view word) { words.push_back(word); });
      }
      else
        splitWords(line, ' ', words);
      takeVertex(file, words, number, table);
    }
    else if (faces && (startsWith(line, 'f') || line == "f"))
      takeFace(file, lines, line, table[0].size(), *faces);
  }
  if (table[0].empty())
    throw FileError(file, "holds no vertices ('v x y z'); export it again");
  return table;
}

} // namespace

PointTable
readObjTable(const std::string& file, std::string_view bytes)
{
  return readObj(file, bytes, nullptr);
}

MeshTable
readObjMesh(const std::string& file, std::string_view bytes)
{
  MeshTable mesh;
  mesh.faces.first_vertex = 1;
  mesh.vertices = readObj(file, bytes, &mesh.faces);
  return mesh;
}

} // namespace pcl_spiral
