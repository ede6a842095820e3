// SPDX-License-Identifier: BSD-3-Clause
// Scans in LAS files.
#include "harness.h"

using namespace pcl_spiral;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::vector<std::string> warnings;
  fuzzTable(data, size, 3, [&warnings](std::string_view bytes) { return readLasTable("scan.las", bytes, warnings); });
  return 0;
}
