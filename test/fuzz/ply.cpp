// SPDX-License-Identifier: BSD-3-Clause
// Scans and meshes in PLY files.
#include "harness.h"
#include "mesh_harness.h"

using namespace pcl_spiral;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzzTable(data, size, 3, [](std::string_view bytes) { return readPlyTable("scan.ply", bytes, {"x", "y", "z"}); });
  return fuzzMesh(".ply", data, size);
}
