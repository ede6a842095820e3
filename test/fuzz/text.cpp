// SPDX-License-Identifier: BSD-3-Clause
// Scans in text files: .xyz .txt .csv .asc. The first byte selects whether the user names the columns, and how many lines are skipped.
#include "harness.h"

using namespace pcl_spiral;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
    return 0;
  const Names columns = data[0] % 2 == 0 ? Names{} : Names{"id", "z", "x", "y"};
  std::vector<std::string> warnings;
  const TextLayout layout{columns, data[0] / 2U % 4U, &warnings};
  return fuzzTable(data + 1, size - 1, 3, [&layout](std::string_view bytes) {
    return readTextTable("scan.csv", bytes, {"x", "y", "z"}, layout);
  });
}
