// SPDX-License-Identifier: BSD-3-Clause
// Scans in PCD files.
#include "harness.h"

using namespace pcl_spiral;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  return fuzzTable(data, size, 3, [](std::string_view bytes) { return readPcdTable("scan.pcd", bytes, {"x", "y", "z"}); });
}
