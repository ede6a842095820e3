// SPDX-License-Identifier: BSD-3-Clause
// Job files (YAML, and JSON as part of it): read, set, and checked as in pcl_spiral_toolpath before any work.
#include "input_file.h"

#include "terminal/terminal.h"
#include "toolpath/command_line.h"

#include <pcl_spiral/io/file_error.h>

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const pcl_spiral::InputFile file(".yaml", data, size);
  const char* const call[] = {"pcl_spiral_toolpath", "--config", file.name().c_str()};
  try {
    parseCommandLine(3, call);
  }
  catch (const UsageError&) {
  }
  catch (const pcl_spiral::FileError&) {
  }
  return 0;
}
