// SPDX-License-Identifier: BSD-3-Clause
#include "known_lines.h"

#include "text_scan.h"

#include "io/named_values.h"

#include <algorithm>

namespace pcl_spiral {

std::string_view
lineWithoutNumber(std::string_view line)
{
  line = trimmed(line);
  std::size_t at = !line.empty() && (line[0] == 'N' || line[0] == 'n') ? 1 : 0;
  const std::size_t begin = at;
  while (at < line.size() && line[at] >= '0' && line[at] <= '9')
    ++at;
  return at > begin ? trimmed(line.substr(at)) : line;
}

bool
isShopLine(const Machine& machine, std::string_view line)
{
  const auto isAny = [line](const std::vector<std::string>& lines) {
    return std::any_of(lines.begin(), lines.end(), [line](const std::string& known) { return isWrittenLine(trimmed(known), line); });
  };
  const ShopLines& lines = machine.lines;
  const ControlWords& words = machine.words;
  if (isAny(lines.header) || isAny(lines.footer) || isAny(lines.pass_begin) || isAny(lines.pass_end))
    return true;
  for (const auto& smoothing : {words.smoothing_on, words.smoothing_off})
    if (smoothing && isAny(*smoothing))
      return true;
  for (const std::string& word : {words.mist, words.flood, words.through, words.coolant_off})
    if (!word.empty() && line == word)
      return true;
  return false;
}

} // namespace pcl_spiral
