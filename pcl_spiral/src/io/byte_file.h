// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A file in bytes, with every failure an exception.
 */
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace pcl_spiral {

/** A file written from front to back. Call close: only then is it known to be complete. */
class ByteFile {
public:
  /** \throw FileError */
  explicit ByteFile(std::string file);
  ~ByteFile();
  ByteFile(const ByteFile&) = delete;
  ByteFile& operator=(const ByteFile&) = delete;

  /** \throw FileError with the system's reason, such as a full disk */
  void write(std::string_view bytes);
  /** \throw FileError */
  void close();

private:
  std::string file_;
  std::FILE* stream_;
};

/** The whole file. \throw FileError missing, a folder, empty, not readable */
std::string readBytes(const std::string& file);

/** Extension in lower case with the dot; empty without one. */
std::string lowerExtension(const std::string& file);

} // namespace pcl_spiral
