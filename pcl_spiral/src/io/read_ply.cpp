#include "field_layout.h"
#include "point_table.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <map>

namespace pcl_spiral {
namespace {

// Own reading, because PCL 1.13's takes words that are no numbers for NaN without a complaint and reports
// what is wrong on the console alone.

struct PlyProperty {
  std::string name;
  FieldType type;
  bool list = false;
  FieldType count_type;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

/** Reads a PLY file: ascii, or binary of either byte order. */
class PlyTable {
public:
  PlyTable(const std::string& file, std::string_view bytes, const Names& wanted)
      : file_(file), bytes_(bytes), wanted_(wanted), lines_(bytes)
  {
  }

  PointTable
  read()
  {
    readHeader();
    at_ = lines_.position();
    bool found = false;
    for (const PlyElement& element : elements_) {
      const bool vertices = element.name == "vertex";
      if (vertices)
        settleColumns(element);
      found = found || vertices;
      if (element.properties.empty() && !ascii_) // nothing there, however many
        continue;
      for (std::size_t i = 0; i < element.count; ++i)
        ascii_ ? readLine(element, vertices, i) : readRecord(element, vertices, i);
    }
    if (!found || table_[0].empty())
      throw FileError(file_, "holds no vertices");
    return std::move(table_);
  }

private:
  [[noreturn]] void
  failLine(const std::string& what) const
  {
    throw FileError(file_, atLine(lines_.number(), what));
  }

  [[noreturn]] void
  failEnd(const PlyElement& element, std::size_t i) const
  {
    throw FileError(file_, "is cut off at byte " + std::to_string(bytes_.size()) + ", in " + element.name +
                               " " + std::to_string(i + 1) + " of " + std::to_string(element.count) +
                               "; copy or export it again");
  }

  FieldType
  typeOf(std::string_view word) const
  {
    static const std::map<std::string_view, FieldType> types{
        {"char", {'I', 1}},  {"int8", {'I', 1}},    {"uchar", {'U', 1}},  {"uint8", {'U', 1}},
        {"short", {'I', 2}}, {"int16", {'I', 2}},   {"ushort", {'U', 2}}, {"uint16", {'U', 2}},
        {"int", {'I', 4}},   {"int32", {'I', 4}},   {"uint", {'U', 4}},   {"uint32", {'U', 4}},
        {"float", {'F', 4}}, {"float32", {'F', 4}}, {"double", {'F', 8}}, {"float64", {'F', 8}}};
    const auto found = types.find(word);
    if (found == types.end())
      failLine(quoted(word) + " is no type of a property");
    return found->second;
  }

  void
  readHeader()
  {
    std::string_view line;
    std::vector<std::string_view> words;
    if (!lines_.next(line) || line != "ply")
      failLine("a PLY file begins with 'ply'; is this a PLY file?");
    while (lines_.next(line)) {
      if (line == "end_header")
        return;
      splitWords(line, ' ', words);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info")
        continue;
      if (words[0] == "format" && words.size() > 1)
        takeFormat(words[1]);
      else if (words[0] == "element" && words.size() == 3)
        takeElement(words);
      else if (words[0] == "property" && words.size() >= 3 && !elements_.empty())
        takeProperty(words);
      else
        failLine(quoted(line) + " is no line of a PLY header");
    }
    throw FileError(file_, "has no end_header: cut off in its header");
  }

  void
  takeFormat(std::string_view format)
  {
    if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      failLine("format " + quoted(format) + " is not known");
    ascii_ = format == "ascii";
    swapped_ = format == "binary_big_endian";
  }

  void
  takeElement(const std::vector<std::string_view>& words)
  {
    const std::optional<std::size_t> count = toCount(words[2]);
    if (!count)
      failLine(quoted(words[2]) + " is not a count");
    elements_.push_back({std::string(words[1]), *count, {}});
  }

  void
  takeProperty(const std::vector<std::string_view>& words)
  {
    PlyProperty property;
    property.name = words.back();
    property.list = words[1] == "list";
    if (words.size() != (property.list ? 5U : 3U))
      failLine("a property has a type and a name");
    property.type = typeOf(words[property.list ? 3 : 1]);
    if (property.list)
      property.count_type = typeOf(words[2]);
    elements_.back().properties.push_back(property);
  }

  void
  settleColumns(const PlyElement& element)
  {
    Names names;
    for (const PlyProperty& property : element.properties)
      names.push_back(property.name);
    column_of_.assign(names.size(), wanted_.size());
    const std::vector<std::size_t> positions = columnsOf(file_, names, wanted_);
    for (std::size_t c = 0; c < positions.size(); ++c) {
      if (element.properties[positions[c]].list)
        throw FileError(file_, "has a list for '" + wanted_[c] + "', where a number a vertex is needed");
      column_of_[positions[c]] = c;
    }
    table_.resize(wanted_.size());
    if (!ascii_) // enough bytes for that many, before memory is taken for them
      for (std::vector<double>& column : table_)
        column.reserve(std::min(element.count, bytes_.size()));
  }

  void
  readLine(const PlyElement& element, bool vertices, std::size_t i)
  {
    std::string_view line;
    do
      if (!lines_.next(line))
        failEnd(element, i);
    while (line.empty());
    if (!vertices)
      return;
    splitWords(line, ' ', words_);
    if (words_.size() < element.properties.size())
      failLine(std::to_string(words_.size()) + " values, where the header names " +
               std::to_string(element.properties.size()));
    std::size_t word = 0;
    for (std::size_t p = 0; p < element.properties.size(); ++p, ++word) {
      if (word >= words_.size())
        failLine(std::to_string(words_.size()) + " values, too few for the lists among them");
      const std::optional<double> value = toNumber(words_[word]);
      if (!value)
        failLine(quoted(words_[word]) + " is not a number");
      if (column_of_[p] < wanted_.size())
        table_[column_of_[p]].push_back(*value);
      if (element.properties[p].list)
        word += listSize(*value);
    }
  }

  void
  readRecord(const PlyElement& element, bool vertices, std::size_t i)
  {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.list) {
        const std::size_t count = listSize(take(element, i, property.count_type));
        skip(element, i, count * static_cast<std::size_t>(property.type.size));
        continue;
      }
      const double value = take(element, i, property.type);
      if (vertices && column_of_[p] < wanted_.size())
        table_[column_of_[p]].push_back(value);
    }
  }

  /** What stands before a list, as a count; a file that ends before it is found to when it is skipped. */
  std::size_t
  listSize(double value) const
  {
    if (!(value >= 0.0))
      throw FileError(file_, "has a list of " + std::to_string(value) + " entries");
    return static_cast<std::size_t>(std::min(value, 1e15));
  }

  double
  take(const PlyElement& element, std::size_t i, FieldType type)
  {
    const std::size_t from = at_;
    skip(element, i, static_cast<std::size_t>(type.size));
    return loadField(bytes_.data() + from, type, swapped_);
  }

  void
  skip(const PlyElement& element, std::size_t i, std::size_t count)
  {
    if (count > bytes_.size() - std::min(at_, bytes_.size()))
      failEnd(element, i);
    at_ += count;
  }

  std::string file_;
  std::string_view bytes_;
  Names wanted_;
  LineScanner lines_;
  std::vector<std::string_view> words_;
  std::vector<PlyElement> elements_;
  std::vector<std::size_t> column_of_; ///< for each vertex property, the wanted column; their count for none
  PointTable table_;
  std::size_t at_ = 0;
  bool ascii_ = true;
  bool swapped_ = false;
};

} // namespace

PointTable
readPlyTable(const std::string& file, std::string_view bytes, const Names& wanted)
{
  return PlyTable(file, bytes, wanted).read();
}

} // namespace pcl_spiral
