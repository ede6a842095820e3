// SPDX-License-Identifier: BSD-3-Clause
#include "text_lead.h"

#include "text_scan.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr std::size_t longest_lead = 64; ///< lines that are not blank or comments

struct LeadLine {
  std::size_t number = 0;
  std::string_view text;
  std::vector<std::string_view> words; ///< by its own separator
};

std::size_t
numbersIn(const std::vector<std::string_view>& words)
{
  const auto isNumber = [](std::string_view word) { return toNumber(unquoted(word)).has_value(); };
  return static_cast<std::size_t>(std::count_if(words.begin(), words.end(), isNumber));
}

/** The lines up to the first row of points, with it; empty if there is none among the first. */
std::vector<LeadLine>
linesToFirstRow(std::string_view bytes, std::size_t skipped, std::size_t wanted)
{
  std::vector<LeadLine> found;
  LineScanner lines(bytes);
  for (std::string_view line; found.size() < longest_lead && lines.next(line);) {
    if (lines.number() <= skipped || line.empty() || line[0] == '#' || line.substr(0, 2) == "//")
      continue;
    found.push_back({lines.number(), line, {}});
    splitWords(line, separatorOf(line), found.back().words);
    if (numbersIn(found.back().words) >= wanted)
      return found;
  }
  return {};
}

/** The number of points that a line of one or two counts gives; absent for other lines. */
std::optional<double>
countIn(const std::vector<std::string_view>& words)
{
  if (words.empty() || words.size() > 2)
    return std::nullopt;
  double product = 1.0;
  for (const std::string_view word : words) {
    const std::optional<std::size_t> count = toCount(unquoted(word));
    if (!count)
      return std::nullopt;
    product *= static_cast<double>(*count);
  }
  return product;
}

/** Whether \p word begins like a number, such as 1,5 or 12mm. */
bool
beginsAsNumber(std::string_view word)
{
  word = unquoted(word);
  const std::size_t first = word.find_first_not_of("+-.");
  return toNumber(word) || (first != std::string_view::npos && word[first] >= '0' && word[first] <= '9');
}

/** Whether a line of words is a title: it has not the columns of \p row, or few numbers among its words. Words alone in all columns are a
 *  heading of unknown names, unless another line is the heading; numbers in all columns but one are a faulty point. */
bool
isTitle(const LeadLine& line, const LeadLine& row, bool has_heading)
{
  if (numbersIn(line.words) == line.words.size())
    return false;
  std::vector<std::string_view> as_row;
  splitWords(line.text, separatorOf(row.text), as_row);
  if (as_row.size() != row.words.size())
    return true;
  const std::size_t numbers = numbersIn(as_row);
  return !beginsAsNumber(as_row[0]) && (numbers > 0 ? numbers + 2 <= as_row.size() : has_heading);
}

} // namespace

bool
namesAll(const std::vector<std::string_view>& words, const Names& wanted)
{
  return std::all_of(wanted.begin(), wanted.end(), [&words](const std::string& name) {
    return std::any_of(words.begin(), words.end(), [&name](std::string_view word) { return sameWord(unquoted(word), name); });
  });
}

TextLead
leadOf(std::string_view bytes, std::size_t skipped, const Names& wanted)
{
  const std::vector<LeadLine> lines = linesToFirstRow(bytes, skipped, wanted.size());
  const auto isHeading = [&wanted](const LeadLine& line) { return namesAll(line.words, wanted); };
  const bool has_heading = std::any_of(lines.begin(), lines.end(), isHeading);
  TextLead lead;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const LeadLine& line = lines[i];
    if (isHeading(line))
      continue;
    const std::optional<double> count = lead.count_line == 0 ? countIn(line.words) : std::nullopt;
    if (!count && !isTitle(line, lines.back(), has_heading))
      break;
    lead.passed.push_back(line.number);
    if (count) {
      lead.count = *count;
      lead.count_line = line.number;
    }
    else
      lead.titles.push_back(atLine(line.number, Diagnostic(inQuotes(line.text))));
  }
  return lead;
}

Diagnostic
titleWarning(const Diagnostics& titles)
{
  if (titles.empty())
    return {};
  const std::size_t more = titles.size() - 1;
  if (more == 0)
    return Diagnostic(titles.front(), " is no point and was passed over");
  return Diagnostic(titles.front(), " and ", more, more == 1 ? " more line are" : " more lines are", " no points and were passed over");
}

} // namespace pcl_spiral
