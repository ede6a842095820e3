// SPDX-License-Identifier: BSD-3-Clause
// Toolpath files, read as in pcl_spiral_verify. The first byte selects the format.
#include "input_file.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_reader.h>

using namespace pcl_spiral;

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const char* const extensions[] = {".csv", ".pcd", ".ply", ".vtp"};
  if (size == 0)
    return 0;
  const InputFile file(extensions[data[0] % 4], data + 1, size - 1);
  try {
    const ToolpathFile read = readToolpath(file.name());
    const bool feed = read.feed.empty() || read.feed.size() == read.path.size();
    const bool tips = read.tips.empty() || read.tips.size() == read.path.size();
    if (read.path.empty() || read.path.size() > size || !feed || !tips)
      std::abort();
  }
  catch (const FileError&) {
  }
  return 0;
}
