// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reading and writing files as bytes; every failure is an exception.
 */
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace pcl_spiral {

/** A file written from start to end. Call close: only after close is the file complete. */
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

/** Whether \p file is a pipe, a terminal or another stream, which can be read only once, from start to end. */
bool isStream(const std::string& file);

/** The whole file. \throw FileError if it is missing, a folder, a stream, empty or not readable */
std::string readBytes(const std::string& file);

/** The same; a stream is read to its end. */
std::string readStream(const std::string& file);

/** Extension in lower case with the dot; empty if there is none. */
std::string lowerExtension(const std::string& file);

} // namespace pcl_spiral
