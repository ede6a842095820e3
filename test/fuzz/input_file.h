// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The bytes of a fuzzer as a file, for readers that open files themselves.
 */
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace pcl_spiral {

/** A file in memory with this extension, removed at the end. */
class InputFile {
public:
  InputFile(const std::string& extension, const std::uint8_t* data, std::size_t size)
  : name_("/dev/shm/pcl_spiral_fuzz_" + std::to_string(::getpid()) + extension)
  {
    std::FILE* const stream = std::fopen(name_.c_str(), "wb");
    if (!stream || std::fwrite(data, 1, size, stream) != size || std::fclose(stream) != 0)
      std::abort();
  }
  ~InputFile() { ::unlink(name_.c_str()); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& name() const { return name_; }

private:
  std::string name_;
};

} // namespace pcl_spiral
