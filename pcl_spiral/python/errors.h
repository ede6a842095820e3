// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the library says, as exceptions of Python in the words of keywords.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/file_error.h>

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace pcl_spiral::python {

namespace py = pybind11;

/** A place of the cloud in the coordinates that \p read takes it from. */
inline Eigen::Vector3d
shown(const Eigen::Vector3d& place, const ReadOptions& read)
{
  return place / millimetres(read.unit) + read.origin;
}

/** How one call names things: its keywords, and its places in the coordinates of the points of the user. */
struct Words {
  Vocabulary vocabulary;
  ReadOptions read; ///< that makes coordinates of the user into those of the cloud

  Words(Vocabulary vocabulary = {}, const ReadOptions& read = {});
  std::string text(const Diagnostic& diagnostic) const { return diagnostic.text(vocabulary); }
};

/** Raises pcl_spiral.Error. \p code: "invalid-argument", "invalid-input", "failed", "cancelled" or "file". \p names: keywords that the
 *  words do not name as settings. */
[[noreturn]] void raise(const std::string& code, const Diagnostic& diagnostic, const Words& words = {},
                        const std::vector<std::string>& names = {});

/** The same for a status that is not ok. */
void require(const Status& status, const Words& words);

/** Raises TypeError. */
[[noreturn]] void raiseType(const Diagnostic& diagnostic, const Words& words = {});

/** \p run() without the lock of the interpreter; a FileError becomes pcl_spiral.Error of this \p code. */
template <typename Run>
auto
withFiles(const Words& words, Run run, const char* code = "file") -> decltype(run())
{
  try {
    const py::gil_scoped_release release;
    return run();
  }
  catch (const FileError& error) {
    raise(code, error.diagnostic(), words);
  }
}

} // namespace pcl_spiral::python
