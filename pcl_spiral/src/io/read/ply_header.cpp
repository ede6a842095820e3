// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <map>

namespace pcl_spiral {
namespace {

/** Takes the lines of a header one by one. */
class PlyHeaderLines {
public:
  PlyHeaderLines(const std::string& file, LineScanner& lines) : file_(file), lines_(lines) {}

  PlyHeader read()
  {
    std::string_view line;
    std::vector<std::string_view> words;
    if (!lines_.next(line) || line != "ply")
      failLine("a PLY file begins with 'ply'; is this a PLY file?");
    while (lines_.next(line)) {
      if (line == "end_header")
        return std::move(header_);
      splitWords(line, ' ', words);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info")
        continue;
      if (words[0] == "format" && words.size() > 1)
        takeFormat(words[1]);
      else if (words[0] == "element" && words.size() == 3)
        takeElement(words);
      else if (words[0] == "property" && words.size() >= 3 && !header_.elements.empty())
        takeProperty(words);
      else
        failLine(Diagnostic(inQuotes(line), " is not a line of a PLY header"));
    }
    throw FileError(file_, "has no end_header: it is cut off in its header; copy or export it again");
  }

private:
  [[noreturn]] void failLine(const Diagnostic& what) const { throw FileError(file_, atLine(lines_.number(), what)); }

  FieldType typeOf(std::string_view word) const
  {
    static const std::map<std::string_view, FieldType> types{
        {"char", {'I', 1}},   {"int8", {'I', 1}},    {"uchar", {'U', 1}},  {"uint8", {'U', 1}},  {"short", {'I', 2}}, {"int16", {'I', 2}},
        {"ushort", {'U', 2}}, {"uint16", {'U', 2}},  {"int", {'I', 4}},    {"int32", {'I', 4}},  {"uint", {'U', 4}},  {"uint32", {'U', 4}},
        {"float", {'F', 4}},  {"float32", {'F', 4}}, {"double", {'F', 8}}, {"float64", {'F', 8}}};
    const auto found = types.find(word);
    if (found == types.end())
      failLine(Diagnostic(inQuotes(word), " is not a type of a property"));
    return found->second;
  }

  void takeFormat(std::string_view format)
  {
    if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      failLine(Diagnostic("format ", inQuotes(format), " is not known"));
    header_.ascii = format == "ascii";
    header_.swapped = format == "binary_big_endian";
  }

  void takeElement(const std::vector<std::string_view>& words)
  {
    const std::optional<std::size_t> count = toCount(words[2]);
    if (!count)
      failLine(Diagnostic(inQuotes(words[2]), " is not a count"));
    header_.elements.push_back({std::string(words[1]), *count, {}});
  }

  void takeProperty(const std::vector<std::string_view>& words)
  {
    PlyProperty property;
    property.name = words.back();
    property.list = words[1] == "list";
    if (words.size() != (property.list ? 5U : 3U))
      failLine("a property needs a type and a name");
    property.type = typeOf(words[property.list ? 3 : 1]);
    if (property.list)
      property.count_type = typeOf(words[2]);
    header_.elements.back().properties.push_back(property);
  }

  const std::string& file_;
  LineScanner& lines_;
  PlyHeader header_;
};

} // namespace

std::vector<std::string>
PlyElement::propertyNames() const
{
  std::vector<std::string> names;
  for (const PlyProperty& property : properties)
    names.push_back(property.name);
  return names;
}

bool
PlyElement::hasLists() const
{
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& property) { return property.list; });
}

bool
beginsWithRecord(const PlyHeader& header, LineScanner lines)
{
  std::string_view line;
  while (lines.next(line) && line.empty())
    continue;
  std::vector<std::string_view> words;
  splitWords(line, ' ', words);
  for (const PlyElement& element : header.elements)
    if (element.count > 0)
      return element.hasLists() ? words.size() >= element.properties.size() : words.size() == element.properties.size();
  return false;
}

PlyHeader
readPlyHeader(const std::string& file, LineScanner& lines)
{
  return PlyHeaderLines(file, lines).read();
}

} // namespace pcl_spiral
