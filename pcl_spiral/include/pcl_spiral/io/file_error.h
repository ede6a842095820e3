// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The exception of readers and writers.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace pcl_spiral {

/** A file that cannot be read or written. The message gives
 *  the file, the line or byte, the reason and the remedy. */
class FileError : public std::runtime_error {
public:
  /** \p reason with its place and remedy, after the name of the \p file. */
  FileError(const std::string& file, const Diagnostic& reason) : FileError(Diagnostic(file, ": ", reason)) {}

  /** The whole message, with the name of the file. */
  explicit FileError(Diagnostic diagnostic) : std::runtime_error(diagnostic.text()), diagnostic_(std::move(diagnostic)) {}

  const Diagnostic& diagnostic() const { return diagnostic_; } ///< What what() says, as data.

private:
  Diagnostic diagnostic_;
};

} // namespace pcl_spiral
