// SPDX-License-Identifier: BSD-3-Clause
// Scans and meshes in STL files, ascii and binary.
#include "harness.h"
#include "mesh_harness.h"

using namespace pcl_spiral;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzzTable(data, size, 3, [](std::string_view bytes) { return readStlTable("scan.stl", bytes); });
  return fuzzMesh(".stl", data, size);
}
