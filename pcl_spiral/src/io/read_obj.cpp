#include "point_table.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>

namespace pcl_spiral {

PointTable
readObjTable(const std::string& file, std::string_view bytes)
{
  PointTable table(3);
  LineScanner lines(bytes);
  std::string_view line;
  std::vector<std::string_view> words;
  while (lines.next(line)) {
    if (line.substr(0, 2) != "v " && line.substr(0, 2) != "v\t")
      continue;
    splitWords(line, ' ', words);
    if (words.size() < 4)
      throw FileError(file, atLine(lines.number(), "a vertex needs x y z; is the file cut off?"));
    for (std::size_t c = 0; c < 3; ++c) {
      const std::optional<double> value = toNumber(words[c + 1]);
      if (!value)
        throw FileError(file, atLine(lines.number(), quoted(words[c + 1]) + " is not a number"));
      table[c].push_back(*value);
    }
  }
  if (table[0].empty())
    throw FileError(file, "holds no vertices ('v x y z')");
  return table;
}

} // namespace pcl_spiral
