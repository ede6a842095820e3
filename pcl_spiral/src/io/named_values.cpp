// SPDX-License-Identifier: BSD-3-Clause
#include "named_values.h"

#include <vector>

namespace pcl_spiral {

bool
isWrittenLine(std::string_view line, std::string_view written)
{
  std::vector<std::string_view> texts{""}; // between the names; the first begins and the last ends the line
  takePieces(line, [&texts](std::string_view piece, bool is_name) {
    if (is_name)
      texts.push_back("");
    else
      texts.back() = piece;
  });
  if (written.substr(0, texts.front().size()) != texts.front())
    return false;
  if (texts.size() == 1)
    return written == texts.front();
  std::size_t at = texts.front().size();
  for (std::size_t i = 1; i + 1 < texts.size(); ++i) {
    const std::size_t found = written.find(texts[i], at);
    if (found == std::string_view::npos)
      return false;
    at = found + texts[i].size();
  }
  const std::string_view last = texts.back();
  return written.size() >= at + last.size() && written.substr(written.size() - last.size()) == last;
}

} // namespace pcl_spiral
