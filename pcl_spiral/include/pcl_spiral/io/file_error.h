// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The exception of readers and writers.
 */
#pragma once

#include <stdexcept>
#include <string>

namespace pcl_spiral {

/** A file that cannot be read or written. The message gives
 *  the file, the line or byte, the reason and the remedy. */
class FileError : public std::runtime_error {
public:
  /** \p reason with its place and remedy, after the name of the \p file. */
  FileError(const std::string& file, const std::string& reason) : std::runtime_error(file + ": " + reason) {}
};

} // namespace pcl_spiral
