// SPDX-License-Identifier: BSD-3-Clause
#include "face_list.h"
#include "ply_header.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

// An own reader, because the reader of PCL 1.13 reads words that are not numbers as NaN without an error and reports
// other errors only on the console.

constexpr std::size_t no_column = std::numeric_limits<std::size_t>::max();
const Names face_lists{"vertex_indices", "vertex_index"};

/** How an ascii file is read: as words, wherever its lines end, as the format is meant; or one record per line, which may have more words
 *  than the header names. */
enum class AsciiRows { Words, Lines };

/** Reads a PLY file: ascii, or binary of either byte order. */
class PlyTable {
public:
  /** Faces are read if a list for them is given, otherwise skipped. */
  PlyTable(const std::string& file, std::string_view bytes, const Names& wanted, FaceList* faces, NormalColumns normals)
  : file_(file), bytes_(bytes), wanted_(wanted), normals_(normals), lines_(bytes), header_(readPlyHeader(file, lines_)),
    scanner_(bytes, lines_), at_(lines_.position()), faces_(faces)
  {}

  bool isAscii() const { return header_.ascii; }

  /** Whether the first line of an ascii file holds one record. */
  bool hasRecordPerLine() const { return beginsWithRecord(header_, lines_); }

  PointTable read(AsciiRows rows)
  {
    bool found = false;
    for (const PlyElement& element : header_.elements) {
      const bool vertices = element.name == "vertex";
      column_of_.assign(element.properties.size(), no_column);
      list_of_faces_ = element.properties.size();
      if (vertices)
        settleColumns(element);
      else if (faces_ && element.count > 0)
        settleFaces(element);
      found = found || vertices;
      const bool by_lines = header_.ascii && rows == AsciiRows::Lines;
      if (element.properties.empty() && !by_lines) // elements without data, in any number
        continue;
      for (std::size_t i = 0; i < element.count; ++i)
        by_lines ? readLine(element, vertices, i) : header_.ascii ? readWords(element, vertices, i) : readRecord(element, i);
    }
    if (std::string_view word; header_.ascii && rows == AsciiRows::Words && scanner_.next(word))
      throw FileError(file_, atLine(scanner_.number(),
                                    Diagnostic(inQuotes(word), " comes after the last value that the header names; export it again")));
    if (!found || table_[0].empty())
      throw FileError(file_, "holds no vertices; export it again");
    return std::move(table_);
  }

private:
  [[noreturn]] void failLine(const Diagnostic& what) const { throw FileError(file_, atLine(lines_.number(), what)); }

  [[noreturn]] void failEnd(const PlyElement& element, std::size_t i) const
  {
    throw FileError(file_, Diagnostic("is cut off at byte ", bytes_.size(), ", in ", element.name, " ", i + 1, " of ", element.count,
                                      "; copy or export it again"));
  }

  void settleColumns(const PlyElement& element)
  {
    if (normals_ == NormalColumns::Read)
      wanted_ = withNormals(element.propertyNames(), wanted_);
    const std::vector<std::size_t> positions = columnsOf(file_, element.propertyNames(), wanted_);
    for (std::size_t c = 0; c < positions.size(); ++c) {
      if (element.properties[positions[c]].list)
        throw FileError(file_, Diagnostic("has a list for '", wanted_[c], "', but one number per vertex is needed"));
      column_of_[positions[c]] = c;
    }
    table_.resize(wanted_.size());
    if (!header_.ascii) // the file must have enough bytes before memory is allocated
      for (std::vector<double>& column : table_)
        column.reserve(std::min(element.count, bytes_.size()));
  }

  /** The property of the faces that lists their corners. */
  void settleFaces(const PlyElement& element)
  {
    if (element.name == "tristrips")
      throw FileError(file_, "holds triangle strips (element tristrips), which cannot be read; export it with faces");
    if (element.name != "face")
      return;
    const auto lists_corners = [](const PlyProperty& property) {
      return property.list && std::find(face_lists.begin(), face_lists.end(), property.name) != face_lists.end();
    };
    const auto& properties = element.properties;
    const auto found = std::find_if(properties.begin(), properties.end(), lists_corners);
    if (found == properties.end())
      throw FileError(file_, "has faces without a list 'vertex_indices' or 'vertex_index'; export it again");
    list_of_faces_ = static_cast<std::size_t>(found - properties.begin());
    faces_->place_word = header_.ascii ? "line" : "byte";
  }

  void readLine(const PlyElement& element, bool vertices, std::size_t i)
  {
    std::string_view line;
    do
      if (!lines_.next(line))
        failEnd(element, i);
    while (line.empty());
    if (!vertices && list_of_faces_ == element.properties.size())
      return;
    splitWords(line, ' ', words_);
    if (words_.size() < element.properties.size())
      failLine(Diagnostic(words_.size(), " values, but the header names ", element.properties.size()));
    std::size_t word = 0;
    for (std::size_t p = 0; p < element.properties.size(); ++p, ++word) {
      if (word >= words_.size())
        failLine(Diagnostic(words_.size(), " values, too few for the lists in the line"));
      const double value = numberIn(word);
      if (column_of_[p] != no_column)
        table_[column_of_[p]].push_back(value);
      const std::size_t count = element.properties[p].list ? listSize(value) : 0;
      if (p == list_of_faces_)
        takeFaceWords(word + 1, count);
      word += count;
    }
  }

  /** One record of a file that is a stream of words. */
  void readWords(const PlyElement& element, bool vertices, std::size_t i)
  {
    const bool wanted = vertices || list_of_faces_ < element.properties.size();
    std::size_t first = 0; // line of the record
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const bool list = element.properties[p].list;
      const std::string_view word = nextWord(element, i);
      first = p == 0 ? scanner_.number() : first;
      if (!wanted && !list)
        continue;
      const double value = numberIn(word, scanner_.number());
      if (column_of_[p] != no_column)
        table_[column_of_[p]].push_back(value);
      for (std::size_t left = list ? listSize(value) : 0; left > 0; --left)
        if (const std::string_view corner = nextWord(element, i); p == list_of_faces_)
          takeCorner(numberIn(corner, scanner_.number()), scanner_.number());
      if (p == list_of_faces_)
        faces_->close(first);
    }
  }

  std::string_view nextWord(const PlyElement& element, std::size_t i)
  {
    std::string_view word;
    if (!scanner_.next(word))
      failEnd(element, i);
    return word;
  }

  double numberIn(std::string_view word, std::size_t line) const
  {
    const std::optional<double> value = toNumber(word);
    if (!value)
      throw FileError(file_, atLine(line, Diagnostic(inQuotes(word), " is not a number")));
    return *value;
  }

  double numberIn(std::size_t word) const { return numberIn(words_[word], lines_.number()); }

  void takeFaceWords(std::size_t first, std::size_t count)
  {
    if (count > words_.size() - first)
      failLine(Diagnostic("a list of ", count, " corners, but the line has ", words_.size() - first, "; is the file cut off?"));
    for (std::size_t k = 0; k < count; ++k)
      takeCorner(numberIn(first + k), lines_.number());
    faces_->close(lines_.number());
  }

  void readRecord(const PlyElement& element, std::size_t i)
  {
    const std::size_t start = at_;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.list) {
        const std::size_t count = listSize(take(element, i, property.count_type));
        const std::size_t size = static_cast<std::size_t>(property.type.size);
        skip(element, i, count * size);
        if (p == list_of_faces_) {
          for (std::size_t from = at_ - count * size; from < at_; from += size)
            takeCorner(loadField(bytes_.data() + from, property.type, header_.swapped), start);
          faces_->close(start);
        }
        continue;
      }
      const double value = take(element, i, property.type);
      if (column_of_[p] != no_column)
        table_[column_of_[p]].push_back(value);
    }
  }

  void takeCorner(double value, std::size_t place)
  {
    constexpr double most = 1e15;
    if (!(std::abs(value) < most) || value != std::floor(value))
      throw FileError(file_, Diagnostic(std::string(faces_->place_word), " ", place, ": ", value, " names no vertex; export it again"));
    faces_->corners.push_back(static_cast<std::int64_t>(value));
  }

  /** The number before a list, as a count; a file that ends earlier is reported when the list is skipped. */
  std::size_t listSize(double value) const
  {
    if (!(value >= 0.0))
      throw FileError(file_, Diagnostic("has a list of ", value, " entries"));
    return static_cast<std::size_t>(std::min(value, 1e15));
  }

  double take(const PlyElement& element, std::size_t i, FieldType type)
  {
    const std::size_t from = at_;
    skip(element, i, static_cast<std::size_t>(type.size));
    return loadField(bytes_.data() + from, type, header_.swapped);
  }

  void skip(const PlyElement& element, std::size_t i, std::size_t count)
  {
    if (count > bytes_.size() - std::min(at_, bytes_.size()))
      failEnd(element, i);
    at_ += count;
  }

  std::string file_;
  std::string_view bytes_;
  Names wanted_;
  NormalColumns normals_;
  LineScanner lines_;
  std::vector<std::string_view> words_;
  PlyHeader header_;
  WordScanner scanner_;
  std::vector<std::size_t> column_of_; ///< for each property of the element, the wanted column, or no_column
  std::size_t list_of_faces_ = 0;      ///< the property of the element that lists corners; the number of properties for none
  PointTable table_;
  std::size_t at_;
  FaceList* faces_;
};

/** An ascii file that is no exact stream of words may still have one record per line, with words that its header does not name. */
PointTable
readPly(const std::string& file, std::string_view bytes, const Names& wanted, FaceList* faces, NormalColumns normals)
{
  PlyTable table(file, bytes, wanted, faces, normals);
  if (!table.isAscii())
    return table.read(AsciiRows::Words);
  const bool by_lines = table.hasRecordPerLine();
  try {
    return table.read(AsciiRows::Words);
  }
  catch (const FileError& of_words) {
    if (faces)
      *faces = {};
    try {
      return PlyTable(file, bytes, wanted, faces, normals).read(AsciiRows::Lines);
    }
    catch (const FileError&) {
      if (by_lines) // what is wrong in a line tells more
        throw;
      throw of_words;
    }
  }
}

} // namespace

PointTable
readPlyTable(const std::string& file, std::string_view bytes, const Names& wanted, NormalColumns normals)
{
  return readPly(file, bytes, wanted, nullptr, normals);
}

MeshTable
readPlyMesh(const std::string& file, std::string_view bytes)
{
  MeshTable mesh;
  mesh.vertices = readPly(file, bytes, {"x", "y", "z"}, &mesh.faces, NormalColumns::Leave);
  return mesh;
}

} // namespace pcl_spiral
