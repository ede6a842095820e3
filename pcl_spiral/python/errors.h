// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the library says, as exceptions of Python in the words of keywords.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/io/file_error.h>

#include <pybind11/pybind11.h>

#include <string>

namespace pcl_spiral::python {

namespace py = pybind11;

/** How one call names things: its keywords, and its places in the coordinates of the scan. */
struct Words {
  Vocabulary vocabulary;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< see Scan::shift

  std::string text(const Diagnostic& diagnostic) const { return diagnostic.text(vocabulary); }
};

/** Raises pcl_spiral.Error. \p code: "invalid-argument", "invalid-input", "failed", "cancelled" or "file" */
[[noreturn]] void raise(const std::string& code, const Diagnostic& diagnostic, const Words& words);

/** The same for a status that is not ok. */
void require(const Status& status, const Words& words);

/** Raises TypeError. */
[[noreturn]] void raiseType(const Diagnostic& diagnostic, const Words& words = {});

/** \p run(); a FileError becomes pcl_spiral.Error. */
template <typename Run>
auto
withFiles(const Words& words, Run run) -> decltype(run())
{
  try {
    return run();
  }
  catch (const FileError& error) {
    raise("file", error.diagnostic(), words);
  }
}

} // namespace pcl_spiral::python
