// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Several output files that appear together or not at all.
 */
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Output files written under temporary names in their own folders and renamed at the end.
 *
 *  \code
 *  OutputFiles files({"part.csv", "part.vtp"});  // throws where a path cannot be written
 *  writeToolpath(files.temporary(0), ...);
 *  writeToolpath(files.temporary(1), ...);
 *  files.commit();                               // all of them, or none and the earlier files as they were
 *  \endcode
 *  Without commit the destructor removes what was written. A process that is killed leaves its temporaries
 *  (.part.writing-PID.csv), and every target as it was or complete; the next OutputFiles of that target removes them.
 */
class OutputFiles {
public:
  /** Checks that every path can be written, by making and removing a file beside it.
   *  \throw FileError folder missing or not writable, a folder in place of the file, a path given twice */
  explicit OutputFiles(std::vector<std::string> paths);
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  std::size_t size() const { return targets_.size(); }
  /** The path as it was given. */
  const std::string& path(std::size_t i) const { return paths_[i]; }
  /** Where to write the file \p i; ends in the same extension. */
  const std::string& temporary(std::size_t i) const { return temporaries_[i]; }

  /** \p message with the names that were given in place of the temporaries'. */
  std::string asGiven(std::string message) const;

  /** Have every temporary on the disk, then rename them all to their targets, one right after the other. \throw FileError after earlier
   *  files have been put back */
  void commit();

private:
  std::vector<std::string> paths_;
  std::vector<std::string> targets_; ///< paths with symbolic links followed
  std::vector<std::string> temporaries_;
};

} // namespace pcl_spiral
