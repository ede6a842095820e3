// SPDX-License-Identifier: BSD-3-Clause
#include "point_table.h"
#include "text_encoding.h"
#include "text_lead.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <cctype>

namespace pcl_spiral {
namespace {

std::string
lower(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::string
joined(const Names& names)
{
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

/** Position of \p name, upper or lower case; the number of names if it is missing. */
std::size_t
find(const Names& names, const std::string& name)
{
  const auto same = [&](const std::string& other) { return lower(other) == lower(name); };
  return static_cast<std::size_t>(std::find_if(names.begin(), names.end(), same) - names.begin());
}

Names
namesIn(const std::vector<std::string_view>& words)
{
  Names names;
  for (const std::string_view word : words)
    names.emplace_back(unquoted(word));
  return names;
}

/** Words, not a number; a wrongly written number, such as 1,5, is not a heading. */
bool
isHeading(std::string_view word)
{
  const auto letter = [](unsigned char c) { return std::isalpha(c) || c == '_'; };
  word = unquoted(word);
  return !toNumber(word) && std::any_of(word.begin(), word.end(), letter);
}

/** Reads a text of points line by line. */
class TextTable {
public:
  TextTable(const std::string& file, std::string_view bytes, const Names& wanted, const TextLayout& layout, NormalColumns normals)
  : file_(file), bytes_(bytes), wanted_(wanted), names_(layout.columns), normals_(normals), layout_(layout),
    lead_(leadOf(bytes, layout.skipped, wanted))
  {}

  PointTable read()
  {
    checkText();
    LineScanner lines(bytes_);
    std::string_view line;
    while (lines.next(line)) {
      const std::size_t comment = line.substr(0, 2) == "//" ? 2 : line.substr(0, 1) == "#" ? 1 : 0;
      if (line.empty() || isPassedOver(lines.number()))
        continue;
      if (comment > 0)
        takeCommentedHeader(trimmed(line.substr(comment)));
      else
        takeLine(line, lines.number());
    }
    if (table_.empty() || table_[0].empty())
      throw FileError(file_, Diagnostic("holds no points (", lines.number(), " lines",
                                        layout_.skipped > 0 ? Diagnostic(", the first ", layout_.skipped, " skipped)") : ")"));
    checkLead();
    return std::move(table_);
  }

private:
  void checkText() const
  {
    refuseWideText(file_, bytes_);
    const std::size_t zero = bytes_.find('\0');
    if (zero != std::string_view::npos)
      throw FileError(file_, Diagnostic("byte ", zero, ": this is not a text file; write it as plain text (UTF-8)"));
  }

  bool isPassedOver(std::size_t number) const
  {
    const std::vector<std::size_t>& passed = lead_.passed;
    return number <= layout_.skipped ||
           (!passed.empty() && number <= passed.back() && std::binary_search(passed.begin(), passed.end(), number));
  }

  /** The number of points that a line gives must be theirs. */
  void checkLead() const
  {
    const std::size_t there = table_[0].size();
    if (lead_.count_line > 0 && lead_.count != static_cast<double>(there))
      throw FileError(
          file_, atLine(lead_.count_line, Diagnostic("this should be the number of points, ", wholeNumber(lead_.count), ", but ", there,
                                                     " follow: if the file is cut off, copy or export it "
                                                     "again; if the line means something else, skip the lines up to it "
                                                     "({ReadOptions::skip_lines} ",
                                                     lead_.count_line, ")")));
    if (const Diagnostic warning = titleWarning(lead_.titles); layout_.warnings && !warning.empty())
      layout_.warnings->push_back(Diagnostic(file_, ": ", warning));
  }

  /** "# x y z" or "//X Y Z" above the points names the columns; many programs write this. */
  void takeCommentedHeader(std::string_view line)
  {
    if (started_ || !names_.empty())
      return;
    splitWords(line, separatorOf(line), words_);
    if (namesAll(words_, wanted_))
      names_ = namesIn(words_);
  }

  void takeLine(std::string_view line, std::size_t number)
  {
    if (!started_) {
      separator_ = separatorOf(line);
      splitWords(line, separator_, words_);
      const bool header = isHeading(words_[0]);
      start(header, number);
      if (header)
        return;
    }
    splitWords(line, separator_, words_);
    takeNumbers(number);
  }

  static Diagnostic orSkip(std::size_t number)
  {
    return Diagnostic("; if it is no point, skip it ({ReadOptions::skip_lines} ", number, ")");
  }

  /** Finds the wanted columns, from the first line that is not a comment. */
  void start(bool header, std::size_t number)
  {
    started_ = true;
    const bool named_by_user = !layout_.columns.empty();
    const Diagnostic or_skip = orSkip(number);
    if (header && !named_by_user)
      names_ = namesIn(words_);
    if (words_.size() < wanted_.size())
      throw FileError(file_, atLine(number, Diagnostic(words_.size(), " column(s), but ", joined(wanted_),
                                                       " are needed; see {ReadOptions::columns}", or_skip)));
    if (names_.empty())
      names_ = wanted_;
    if (header && !named_by_user && find(names_, wanted_[0]) == names_.size())
      throw FileError(file_, atLine(number, Diagnostic(inQuotes(words_[0]), " is neither a number nor a heading with ", joined(wanted_),
                                                       "; name the columns ({ReadOptions::columns})", or_skip)));
    if (normals_ == NormalColumns::Read)
      wanted_ = withNormals(names_, wanted_);
    positions_ = columnsOf(file_, names_, wanted_);
    width_ = words_.size();
    const std::size_t last = *std::max_element(positions_.begin(), positions_.end());
    if (last >= width_)
      throw FileError(file_,
                      atLine(number, Diagnostic(width_, " columns, but column ", last + 1, " is needed; see {ReadOptions::columns}")));
    table_.resize(wanted_.size());
  }

  void takeNumbers(std::size_t number)
  {
    if (words_.size() != width_)
      throw FileError(file_,
                      atLine(number, Diagnostic(words_.size(), " columns, but the lines before have ", width_, "; is the file cut off?")));
    for (std::size_t c = 0; c < positions_.size(); ++c) {
      const std::string_view word = unquoted(words_[positions_[c]]);
      const std::optional<double> value = toNumber(word);
      if (!value) {
        const bool comma = word.find_first_of(", \t") != std::string_view::npos || word.substr(0, 1) == "\""; // "1,5" is cut at its comma
        throw FileError(file_, atLine(number, Diagnostic(inQuotes(word), " is not a number",
                                                         (comma ? "; write decimals with a point, not a comma" : ""),
                                                         (table_.back().empty() ? orSkip(number) : ""))));
      }
      table_[c].push_back(*value);
    }
  }

  std::string file_;
  std::string_view bytes_;
  Names wanted_;
  Names names_;
  NormalColumns normals_;
  TextLayout layout_;
  TextLead lead_;
  bool started_ = false;
  char separator_ = ' ';
  std::size_t width_ = 0;
  std::vector<std::size_t> positions_;
  std::vector<std::string_view> words_;
  PointTable table_;
};

} // namespace

Names
withNormals(const Names& names, const Names& wanted)
{
  for (const Names& normal : {Names{"nx", "ny", "nz"}, Names{"normal_x", "normal_y", "normal_z"}})
    if (std::all_of(normal.begin(), normal.end(), [&](const std::string& name) { return find(names, name) < names.size(); })) {
      Names all = wanted;
      all.insert(all.end(), normal.begin(), normal.end());
      return all;
    }
  return wanted;
}

std::vector<std::size_t>
columnsOf(const std::string& file, const Names& names, const Names& wanted)
{
  std::vector<std::size_t> positions;
  for (const std::string& name : wanted) {
    positions.push_back(find(names, name));
    if (positions.back() == names.size())
      throw FileError(file, Diagnostic("has no '", name, "'; it has: ", joined(names)));
  }
  return positions;
}

PointTable
readTextTable(const std::string& file, std::string_view bytes, const Names& wanted, const TextLayout& layout, NormalColumns normals)
{
  return TextTable(file, bytes, wanted, layout, normals).read();
}

} // namespace pcl_spiral
