// SPDX-License-Identifier: BSD-3-Clause
#include "field_layout.h"
#include "point_table.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <map>
#include <utility>

namespace pcl_spiral {
namespace {

// An own reader for the files of this library, because VTK's allocates memory for as many points as the header gives.

struct VtpArray {
  FieldType type;
  std::size_t components = 1;
  std::size_t offset = 0; ///< in the appended data
};

/** Reads successive polylines with arrays after the XML: appended, raw, not compressed. */
class VtpFile {
public:
  VtpFile(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes)
  {
    readTags();
    begin_ = bytes_.find('_', begin_);
    if (begin_ == std::string_view::npos)
      fail("has no data after its XML; is it cut off?");
    ++begin_;
    if (points_ == 0)
      fail("holds no polyline, so no path; write the path again");
  }

  bool has(const std::string& name) const { return arrays_.count(name) > 0; }

  /** One column for each component. */
  void append(PointTable& table, const std::string& name, std::size_t components) const
  {
    const auto found = arrays_.find(name);
    if (found == arrays_.end() || found->second.components != components)
      fail(Diagnostic("has no point data ", name, "; it is not a toolpath of pcl_spiral"));
    const VtpArray& array = found->second;
    const auto width = static_cast<std::size_t>(array.type.size);
    const std::string_view data = block(name, array);
    if (data.size() / (width * components) != points_ || data.size() % (width * components) != 0)
      fail(Diagnostic("has ", data.size(), " bytes of ", name, " for ", points_, " points"));
    for (std::size_t c = 0; c < components; ++c) {
      table.emplace_back(points_);
      for (std::size_t i = 0; i < points_; ++i)
        table.back()[i] = loadField(data.data() + (i * components + c) * width, array.type);
    }
  }

  /** An array of whole numbers of the lines. */
  std::vector<std::size_t> lineNumbers(const std::string& name) const
  {
    const auto found = arrays_.find("Lines " + name);
    if (found == arrays_.end())
      fail(Diagnostic("has no array ", name, " of its lines, which defines its polylines; it is not a toolpath of pcl_spiral"));
    const auto width = static_cast<std::size_t>(found->second.type.size);
    const std::string_view data = block(name, found->second);
    std::vector<std::size_t> numbers(data.size() / width);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double number = loadField(data.data() + i * width, found->second.type);
      if (!(number >= 0.0 && number < 1e12))
        fail(Diagnostic("has the number ", number, " among the ", name, " of its lines"));
      numbers[i] = static_cast<std::size_t>(number);
    }
    return numbers;
  }

  std::vector<std::size_t> passes() const
  {
    const std::vector<std::size_t> points = lineNumbers("connectivity"), ends = lineNumbers("offsets");
    std::vector<std::size_t> begins;
    std::size_t next = 0, begin = 0; // the next point and the next entry
    for (const std::size_t end : ends) {
      if (end <= begin || end > points.size())
        fail(Diagnostic("has polylines that end at entries ", begin, " and ", end, " of ", points.size()));
      if (next > 0)
        begins.push_back(next);
      const bool alone = end == begin + 2 && points[begin] == points[begin + 1]; // a pass of one point, written twice
      for (std::size_t i = begin; i < end - (alone ? 1 : 0); ++i, ++next)
        if (points[i] != next)
          fail(Diagnostic("has polylines whose points are not in order: point ", points[i], " comes where point ", next,
                          " must come; give the path as .csv"));
      begin = end;
    }
    if (next != points_)
      fail(Diagnostic("has polylines through only ", next, " of its ", points_, " points; a path must go through all points"));
    return begins;
  }

private:
  using Attributes = std::map<std::string_view, std::string_view>;

  [[noreturn]] void fail(const Diagnostic& what) const { throw FileError(file_, what); }

  /** Reads up to the tag of the appended data. */
  void readTags()
  {
    while (begin_ < bytes_.size()) {
      const std::size_t open = bytes_.find('<', begin_);
      const std::size_t close = std::min(bytes_.find('>', open), bytes_.size());
      if (open == std::string_view::npos || close == bytes_.size())
        break;
      begin_ = close + 1;
      if (takeTag(bytes_.substr(open + 1, close - open - 1)))
        return;
    }
    fail("has no appended data: it is not a .vtp file of pcl_spiral, or it is cut off");
  }

  /** Whether this is the tag before the data. */
  bool takeTag(std::string_view tag)
  {
    const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/", 1));
    const Attributes attributes = attributesOf(tag.substr(name.size()));
    if (name == "VTKFile")
      takeFormat(attributes);
    else if (name == "Piece")
      takePiece(attributes);
    else if (name == "PointData" || name == "Points")
      of_points_ = true;
    else if (name == "/PointData" || name == "/Points")
      of_points_ = false;
    else if (name == "Lines" || name == "/Lines")
      of_lines_ = name == "Lines";
    else if (name == "DataArray" && (of_points_ || of_lines_))
      takeArray(attributes);
    else if (name == "AppendedData" && value(attributes, "encoding") != "raw")
      fail("holds encoded data; save it with raw appended data, or give the path as .csv");
    return name == "AppendedData";
  }

  static Attributes attributesOf(std::string_view text)
  {
    Attributes attributes;
    for (std::size_t equal = text.find('='); equal != std::string_view::npos; equal = text.find('=')) {
      std::string_view name = trimmed(text.substr(0, equal));
      name = name.substr(std::min(name.find_last_of(" \t\r\n") + 1, name.size()));
      const std::size_t open = text.find_first_of("\"'", equal);
      const std::size_t close = open == std::string_view::npos ? open : text.find(text[open], open + 1);
      if (close == std::string_view::npos)
        break;
      attributes[name] = text.substr(open + 1, close - open - 1);
      text.remove_prefix(close + 1);
    }
    return attributes;
  }

  static std::string_view value(const Attributes& attributes, std::string_view name)
  {
    const auto found = attributes.find(name);
    return found == attributes.end() ? std::string_view() : found->second;
  }

  std::size_t countIn(const Attributes& attributes, std::string_view name) const
  {
    const std::optional<std::size_t> count = toCount(value(attributes, name));
    if (!count)
      fail(Diagnostic("has ", std::string(name), " ", inQuotes(value(attributes, name)), ", which is not a count"));
    return *count;
  }

  void takeFormat(const Attributes& attributes)
  {
    if (value(attributes, "byte_order") == "BigEndian" || attributes.count("compressor") > 0)
      fail("holds compressed or big-endian data; save it as little-endian without compression, or give the path as .csv");
    wide_headers_ = value(attributes, "header_type") == "UInt64";
  }

  void takePiece(const Attributes& attributes)
  {
    if (points_ > 0 || countIn(attributes, "NumberOfLines") == 0)
      fail("holds more than one piece or no polyline; a toolpath is one piece with one polyline per pass");
    points_ = countIn(attributes, "NumberOfPoints");
  }

  void takeArray(const Attributes& attributes)
  {
    static const std::map<std::string_view, FieldType> types{
        {"Int8", {'I', 1}},   {"UInt8", {'U', 1}}, {"Int16", {'I', 2}},  {"UInt16", {'U', 2}},  {"Int32", {'I', 4}},
        {"UInt32", {'U', 4}}, {"Int64", {'I', 8}}, {"UInt64", {'U', 8}}, {"Float32", {'F', 4}}, {"Float64", {'F', 8}}};
    const auto type = types.find(value(attributes, "type"));
    if (type == types.end() || value(attributes, "format") != "appended")
      return; // not of this library: reported as missing when needed
    VtpArray array;
    array.type = type->second;
    if (attributes.count("NumberOfComponents") > 0)
      array.components = countIn(attributes, "NumberOfComponents");
    array.offset = countIn(attributes, "offset");
    arrays_[(of_lines_ ? "Lines " : "") + std::string(value(attributes, "Name"))] = array;
  }

  template <typename T>
  static std::size_t load(std::string_view bytes)
  {
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return static_cast<std::size_t>(value);
  }

  /** The bytes of an array, which follow their number. */
  std::string_view block(const std::string& name, const VtpArray& array) const
  {
    const std::size_t header = wide_headers_ ? 8 : 4;
    std::string_view rest = bytes_.substr(std::min(begin_ + array.offset, bytes_.size()));
    if (rest.size() >= header) {
      const std::size_t size = wide_headers_ ? load<std::uint64_t>(rest) : load<std::uint32_t>(rest);
      rest.remove_prefix(header);
      if (size <= rest.size())
        return rest.substr(0, size);
    }
    fail(Diagnostic("is cut off at byte ", bytes_.size(), ", in ", name, "; make it again"));
  }

  std::string file_;
  std::string_view bytes_;
  std::size_t begin_ = 0; ///< of the appended data
  std::size_t points_ = 0;
  bool of_points_ = false; ///< inside the tags of arrays with one value per point
  bool of_lines_ = false;  ///< inside the tag of the polylines
  bool wide_headers_ = false;
  std::map<std::string, VtpArray> arrays_;
};

} // namespace

PointTable
readVtpTable(const std::string& file, std::string_view bytes, Names& later)
{
  const VtpFile vtp(file, bytes);
  PointTable table;
  vtp.append(table, "Points", 3);
  vtp.append(table, "Normals", 3);
  vtp.append(table, "ToolAxis", 3);
  vtp.append(table, "ArcLength", 1);
  vtp.append(table, "Turn", 1);
  if (vtp.has("Feed"))
    vtp.append(table, "Feed", 1);
  for (const auto& [array, column] : {std::pair{"OverGap", "over_gap"}, std::pair{"Lift", "lift"}})
    if (vtp.has(array)) {
      vtp.append(table, array, 1);
      later.emplace_back(column);
    }
  return table;
}

PointTable
readVtpTips(const std::string& file, std::string_view bytes)
{
  const VtpFile vtp(file, bytes);
  PointTable table;
  if (vtp.has("Tip"))
    vtp.append(table, "Tip", 3);
  return table;
}

std::vector<std::size_t>
readVtpPasses(const std::string& file, std::string_view bytes)
{
  return VtpFile(file, bytes).passes();
}

} // namespace pcl_spiral
