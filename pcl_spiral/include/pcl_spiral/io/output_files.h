// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Several output files that are written all or none.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Output files written under temporary names in their own folders and renamed at the end.
 *
 *  \code
 *  OutputFiles files({"part.csv", "part.vtp"});  // throws if a path cannot be written
 *  writeToolpath(files.temporary(0), ...);
 *  writeToolpath(files.temporary(1), ...);
 *  files.commit();                               // all of them, or none: then the earlier files are unchanged
 *  \endcode
 *  Without commit the destructor removes the written files. A killed process leaves its temporary files
 *  (.part.writing-PID.csv), and every target unchanged or complete; the next OutputFiles of that target removes them.
 */
class OutputFiles {
public:
  /** Checks that every path can be written: makes and removes a file beside it.
   *  \throw FileError if the folder is missing or not writable, the path is a folder, or a path is given twice */
  explicit OutputFiles(std::vector<std::string> paths);
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  std::size_t size() const { return targets_.size(); } ///< Number of files.
  /** The path as given. */
  const std::string& path(std::size_t i) const { return paths_[i]; }
  /** Temporary name to write the file \p i to, with the same extension. */
  const std::string& temporary(std::size_t i) const { return temporaries_[i]; }

  /** \p message with the given names instead of the temporary names. */
  Diagnostic asGiven(Diagnostic message) const;

  /** Forces all temporary files to the disk, then renames them to their targets, one directly after the other. \throw FileError after it
   *  has restored the earlier files */
  void commit();

private:
  std::vector<std::string> paths_;
  std::vector<std::string> targets_; ///< paths with symbolic links followed
  std::vector<std::string> temporaries_;
};

} // namespace pcl_spiral
