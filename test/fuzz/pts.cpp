// SPDX-License-Identifier: BSD-3-Clause
// Scans in PTS files: blocks with the number of their points.
#include "harness.h"

using namespace pcl_spiral;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzzTable(data, size, 3, [](std::string_view bytes) { return readPtsTable("scan.pts", bytes); });
  return 0;
}
