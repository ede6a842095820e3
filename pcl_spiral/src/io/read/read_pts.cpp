// SPDX-License-Identifier: BSD-3-Clause
#include "point_table.h"
#include "text_encoding.h"
#include "text_lead.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>

namespace pcl_spiral {
namespace {

/** The numbers x y z at the start of a line; intensity and colours behind them are not used. */
void
takePoint(const std::string& file, const std::vector<std::string_view>& words, std::size_t number, PointTable& table)
{
  if (words.size() < 3)
    throw FileError(file, atLine(number, Diagnostic(words.size(), " column(s), but x, y, z are needed; is the file cut off?")));
  for (std::size_t c = 0; c < 3; ++c) {
    const std::optional<double> value = toNumber(unquoted(words[c]));
    if (!value)
      throw FileError(file, atLine(number, Diagnostic(inQuotes(words[c]), " is not a number")));
    table[c].push_back(*value);
  }
}

/** Whether the words of a line above the first number of points are a title or a comment. */
bool
isTitle(const std::vector<std::string_view>& words)
{
  return !toNumber(unquoted(words[0]));
}

} // namespace

PointTable
readPtsTable(const std::string& file, std::string_view bytes, const TextLayout& layout)
{
  refuseWideText(file, bytes);
  PointTable table(3);
  LineScanner lines(bytes);
  std::string_view line;
  std::vector<std::string_view> words;
  Diagnostics titles;
  std::size_t left = 0; // points of the block that a count has announced
  while (lines.next(line)) {
    if (line.empty() || lines.number() <= layout.skipped)
      continue;
    splitWords(line, separatorOf(line), words);
    if (left > 0) {
      takePoint(file, words, lines.number(), table);
      --left;
      continue;
    }
    const std::optional<std::size_t> count = words.size() == 1 ? toCount(unquoted(words[0])) : std::nullopt;
    if (count)
      left = *count;
    else if (table[0].empty() && isTitle(words))
      titles.push_back(atLine(lines.number(), Diagnostic(inQuotes(line))));
    else
      throw FileError(
          file, atLine(lines.number(), Diagnostic(inQuotes(line), " must be the number of points that follow; if the file has no such "
                                                                  "line, rename it to .xyz, or correct the number before it")));
  }
  if (left > 0)
    throw FileError(file, Diagnostic("ends ", left,
                                     " points before the number that its heading gives: it is cut off; copy or "
                                     "export it again"));
  if (table[0].empty())
    throw FileError(file, Diagnostic("holds no points (", lines.number(), " lines)"));
  if (const Diagnostic warning = titleWarning(titles); layout.warnings && !warning.empty())
    layout.warnings->push_back(Diagnostic(file, ": ", warning));
  return table;
}

} // namespace pcl_spiral
