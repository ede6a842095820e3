// SPDX-License-Identifier: BSD-3-Clause
// Machine files (YAML): read and checked as in the programs.
#include "input_file.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/machine_reader.h>

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const pcl_spiral::InputFile file(".yaml", data, size);
  try {
    pcl_spiral::readMachine(file.name());
  }
  catch (const pcl_spiral::FileError&) {
  }
  return 0;
}
