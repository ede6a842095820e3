// SPDX-License-Identifier: BSD-3-Clause
#include "camera_view.h"
#include "field_layout.h"
#include "point_table.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>

#include <pcl/io/lzf.h>

#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

// An own reader, because the reader of PCL 1.13 ends the program on an empty file or one without a header, and reads words
// that are not numbers and missing columns as zeros; only its decompression is used.

constexpr std::size_t most_values = 1000000; ///< of one field at one point
constexpr double most_packing = 100.0;       ///< LZF makes no more than 264 bytes of 3

struct PcdField {
  FieldType type;
  std::size_t count = 1;
  std::size_t offset = 0;   ///< bytes within a record
  std::size_t position = 0; ///< words within a line
};

struct PcdHeader {
  Names names;
  std::vector<PcdField> fields;
  std::size_t points = 0;
  std::size_t words_a_point = 0;
  std::size_t bytes_a_point = 0;
  std::optional<Eigen::Vector3d> view_point; ///< of VIEWPOINT, unless it is the default
  std::size_t row = 0;                       ///< points in a row of an organised cloud
  std::string data;                          ///< ascii, binary, binary_compressed
  std::size_t begin = 0;
  std::size_t lines = 0;

  /** Bytes of all points, unpacked; a double, because a header may give any number. */
  double size() const { return static_cast<double>(points) * static_cast<double>(bytes_a_point); }
};

class PcdHeaderReader {
public:
  PcdHeaderReader(const std::string& file, std::string_view bytes) : file_(file), lines_(bytes) {}

  PcdHeader read()
  {
    std::string_view line;
    while (header_.data.empty()) {
      if (!lines_.next(line))
        throw FileError(file_, "has no DATA line: it is not a PCD file, or it is cut off in its header; copy or export it again");
      if (!line.empty() && line[0] != '#')
        takeLine(line);
    }
    header_.begin = lines_.position();
    header_.lines = lines_.number();
    settle();
    return header_;
  }

private:
  [[noreturn]] void fail(const Diagnostic& what) const { throw FileError(file_, atLine(lines_.number(), what)); }

  std::size_t count(std::string_view word) const
  {
    const std::optional<std::size_t> value = toCount(word);
    if (!value)
      fail(Diagnostic(inQuotes(word), " is not a count"));
    return *value;
  }

  void takeLine(std::string_view line)
  {
    splitWords(line, ' ', words_);
    const std::string_view key = words_[0];
    if (key == "VERSION")
      return;
    if (key == "VIEWPOINT")
      return takeViewPoint();
    if (words_.size() < 2)
      fail(Diagnostic(inQuotes(key), " has no value in the header"));
    if (key == "FIELDS" || key == "COLUMNS") {
      header_.names.assign(words_.begin() + 1, words_.end());
      header_.fields.resize(header_.names.size());
    }
    else if (key == "SIZE" || key == "TYPE" || key == "COUNT")
      takeFields(key);
    else if (key == "WIDTH")
      width_ = count(words_[1]);
    else if (key == "HEIGHT")
      height_ = count(words_[1]);
    else if (key == "POINTS")
      header_.points = count(words_[1]);
    else if (key == "DATA")
      header_.data = words_[1];
    else
      fail(Diagnostic(inQuotes(key), " is not a line of a PCD header; is this a PCD file?"));
  }

  /** Place of the scanner and a quaternion. The points are in the frame of the file, so only the place is used. */
  void takeViewPoint()
  {
    constexpr std::array<double, 7> by_default{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
    std::array<double, 7> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::optional<double> value = i + 1 < words_.size() ? toNumber(words_[i + 1]) : std::nullopt;
      if (!value || !std::isfinite(*value))
        fail("VIEWPOINT must have 7 numbers: the place x y z of the scanner and a quaternion");
      values[i] = *value;
    }
    if (values != by_default)
      header_.view_point = Eigen::Vector3d(values[0], values[1], values[2]);
  }

  void takeFields(std::string_view key)
  {
    if (words_.size() != header_.fields.size() + 1)
      fail(Diagnostic(std::string(key), " has ", words_.size() - 1, " entries for ", header_.fields.size(), " fields"));
    for (std::size_t i = 0; i < header_.fields.size(); ++i) {
      const std::string_view word = words_[i + 1];
      if (key == "TYPE")
        header_.fields[i].type.kind = word[0];
      else if (key == "SIZE")
        header_.fields[i].type.size = static_cast<int>(std::min<std::size_t>(count(word), 9));
      else
        header_.fields[i].count = count(word);
    }
  }

  /** In double precision, where counts below 1e15 do not overflow. */
  void checkPoints()
  {
    const std::size_t height = std::max<std::size_t>(height_, 1);
    const double product = static_cast<double>(width_) * static_cast<double>(height);
    if (header_.points == 0 && product < 1e15)
      header_.points = width_ * height;
    if (width_ > 0 && product != static_cast<double>(header_.points))
      fail(Diagnostic("the header says WIDTH ", width_, " and HEIGHT ", height, ", but POINTS ", header_.points));
    if (header_.points == 0)
      fail("the header says that there are no points");
    header_.row = width_ > 1 && height_ > 1 ? width_ : 0;
  }

  void settle()
  {
    checkPoints();
    for (PcdField& field : header_.fields) {
      const int size = field.type.size;
      const bool real = field.type.kind == 'F' && (size == 4 || size == 8);
      const bool whole = (field.type.kind == 'I' || field.type.kind == 'U') && (size == 1 || size == 2 || size == 4 || size == 8);
      if (!real && !whole)
        fail(Diagnostic("the header has a field of TYPE ", std::string(1, field.type.kind), " SIZE ", size));
      if (field.count > most_values)
        fail(Diagnostic("the header has a field of COUNT ", field.count));
      field.offset = header_.bytes_a_point;
      field.position = header_.words_a_point;
      header_.bytes_a_point += field.count * static_cast<std::size_t>(size);
      header_.words_a_point += field.count;
    }
  }

  std::string file_;
  LineScanner lines_;
  std::vector<std::string_view> words_;
  PcdHeader header_;
  std::size_t width_ = 0;
  std::size_t height_ = 1;
};

[[noreturn]] void
failCutOff(const std::string& file, std::size_t there, double needed)
{
  throw FileError(file, Diagnostic("is cut off: it ends at byte ", there, ", but the points in its header need ", wholeNumber(needed),
                                   " bytes; copy or export it again"));
}

PointTable
readAscii(const std::string& file, std::string_view bytes, const PcdHeader& header, const std::vector<std::size_t>& wanted)
{
  PointTable table(wanted.size());
  LineScanner lines(bytes.substr(std::min(header.begin, bytes.size())));
  std::string_view line;
  std::vector<std::string_view> words;
  while (table[0].size() < header.points && lines.next(line)) {
    if (line.empty() || line[0] == '#')
      continue;
    splitWords(line, ' ', words);
    const std::size_t number = header.lines + lines.number();
    if (words.size() != header.words_a_point)
      throw FileError(file, atLine(number, Diagnostic(words.size(), " values, but the header names ", header.words_a_point)));
    for (std::size_t c = 0; c < wanted.size(); ++c) {
      const std::string_view word = words[header.fields[wanted[c]].position];
      const std::optional<double> value = toNumber(word);
      if (!value)
        throw FileError(file, atLine(number, Diagnostic(inQuotes(word), " is not a number")));
      table[c].push_back(*value);
    }
  }
  if (table[0].size() < header.points)
    throw FileError(file, atLine(header.lines + lines.number(), Diagnostic("the file ends after ", table[0].size(), " of ", header.points,
                                                                           " points; copy or export it again")));
  return table;
}

Names
namesWithValues(const PcdHeader& header)
{
  Names names;
  for (std::size_t f = 0; f < header.fields.size(); ++f)
    if (header.fields[f].count > 0)
      names.push_back(header.names[f]);
  return names;
}

/** Fields of COUNT 0 have no values, as in PCL; those that are wanted need one. */
void
requireValues(const std::string& file, const PcdHeader& header, const std::vector<std::size_t>& wanted)
{
  for (const std::size_t f : wanted)
    if (header.fields[f].count == 0)
      throw FileError(file, Diagnostic("has no values of '", header.names[f], "': the header gives it COUNT 0; export it again"));
}

/** The body of a compressed file: all values of one field, then all values of the next. */
std::string
decompressed(const std::string& file, std::string_view bytes, const PcdHeader& header)
{
  const std::size_t there = bytes.size() - std::min(header.begin, bytes.size());
  if (there < 8)
    failCutOff(file, bytes.size(), static_cast<double>(header.begin + 8));
  const auto packed = static_cast<std::size_t>(loadAs<std::uint32_t>(bytes.data() + header.begin));
  const auto unpacked = static_cast<std::size_t>(loadAs<std::uint32_t>(bytes.data() + header.begin + 4));
  if (there < 8 + packed)
    failCutOff(file, bytes.size(), static_cast<double>(header.begin + 8 + packed));
  if (static_cast<double>(unpacked) != header.size())
    throw FileError(file, Diagnostic("byte ", header.begin, ": the packed points have ", unpacked, " bytes, but by the header they have ",
                                     wholeNumber(header.size())));
  if (static_cast<double>(unpacked) > most_packing * static_cast<double>(packed))
    throw FileError(file, Diagnostic("byte ", header.begin, ": ", packed, " packed bytes cannot hold ", unpacked));
  std::string body(unpacked, '\0');
  const unsigned int got = pcl::lzfDecompress(bytes.data() + header.begin + 8, static_cast<unsigned int>(packed), body.data(),
                                              static_cast<unsigned int>(unpacked));
  if (got != unpacked)
    throw FileError(file, Diagnostic("byte ", header.begin + 8, ": the packed points cannot be unpacked; copy or export the file again"));
  return body;
}

PointTable
readBinary(std::string_view body, const PcdHeader& header, const std::vector<std::size_t>& wanted, bool by_field)
{
  PointTable table(wanted.size());
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    const PcdField& field = header.fields[wanted[c]];
    const std::size_t first = by_field ? field.offset * header.points : field.offset;
    const std::size_t step = by_field ? field.count * static_cast<std::size_t>(field.type.size) : header.bytes_a_point;
    table[c].resize(header.points);
    for (std::size_t i = 0; i < header.points; ++i)
      table[c][i] = loadField(body.data() + first + i * step, field.type);
  }
  return table;
}

} // namespace

std::optional<Eigen::Vector3d>
readPcdViewPoint(const std::string& file, std::string_view bytes, const PointTable& table)
{
  const PcdHeader header = PcdHeaderReader(file, bytes).read();
  if (!header.view_point && header.row > 0 && seenFromOrigin(table, header.row))
    return Eigen::Vector3d(Eigen::Vector3d::Zero());
  return header.view_point;
}

PointTable
readPcdTable(const std::string& file, std::string_view bytes, const Names& wanted, NormalColumns normals)
{
  const PcdHeader header = PcdHeaderReader(file, bytes).read();
  const Names names = normals == NormalColumns::Read ? withNormals(namesWithValues(header), wanted) : wanted;
  const std::vector<std::size_t> fields = columnsOf(file, header.names, names);
  requireValues(file, header, fields);
  if (header.data == "ascii")
    return readAscii(file, bytes, header, fields);
  if (header.data == "binary_compressed")
    return readBinary(decompressed(file, bytes, header), header, fields, true);
  if (header.data != "binary")
    throw FileError(file, atLine(header.lines, Diagnostic("DATA ", inQuotes(header.data), " must be ascii, binary or binary_compressed")));
  if ((bytes.size() - std::min(header.begin, bytes.size())) / header.bytes_a_point < header.points)
    failCutOff(file, bytes.size(), static_cast<double>(header.begin) + header.size());
  return readBinary(bytes.substr(header.begin), header, fields, false);
}

} // namespace pcl_spiral
